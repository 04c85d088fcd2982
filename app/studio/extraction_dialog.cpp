#include "app/studio/extraction_dialog.h"

#include "core/figure/layer_edits.h"
#include "core/figure/transfer_edits.h"
#include "widgets/artwork_brush_tools.h"
#include "widgets/artwork_canvas.h"
#include "widgets/artwork_tool_bar.h"
#include "widgets/draft_edits.h"
#include "widgets/extraction_form.h"
#include "widgets/figure_preview.h"
#include "widgets/notice_bar.h"
#include "widgets/style_card_form.h"

#include <QApplication>
#include <QClipboard>
#include <QDate>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QStackedWidget>

#include <utility>

/// What the dialog does; how it is laid out is in extraction_dialog_layout.cpp.

namespace limner {
namespace {

/// "haeckel_plate85-ascidiae" as a name to start from: "Haeckel plate85 ascidiae".
QString nameOf(const std::filesystem::path& file) {
    QString name = QString::fromStdString(file.stem().string());
    name = name.replace('_', ' ').replace('-', ' ').simplified();
    return name.left(1).toUpper() + name.mid(1);
}

/// Without the file's path: the artwork is in front of the reader.
QString lineOf(const Error& error) {
    ErrorText text = error.text();
    text.where = std::filesystem::path(text.where).filename().string();
    return QString::fromStdString(oneLine(text));
}

std::optional<std::filesystem::path> pictureFile(const QMimeData& data) {
    if (data.hasUrls() && data.urls().front().isLocalFile())
        return data.urls().front().toLocalFile().toStdString();
    return std::nullopt;
}

} // namespace

ExtractionDialog::ExtractionDialog(FigurePreview* preview, StyleLibrary library, QWidget* parent)
    : QDialog(parent), library_(std::move(library)), work_(new ExtractionWork(this)), preview_(preview) {
    build();
    connectWidgets();
    connectWork();
    showDraft();
    setFigure(nullptr, 0, std::nullopt);
}

ExtractionDialog::~ExtractionDialog() = default;

void ExtractionDialog::connectWidgets() {
    const auto change = [this](const DraftEdit& edit) { apply(edit); };
    connect(canvas_, &ArtworkCanvas::edited, this, change);
    connect(form_, &ExtractionForm::edited, this, change);
    connect(card_, &StyleCardForm::edited, this, change);
    connect(tools_, &ArtworkToolBar::chosen, this, &ExtractionDialog::chooseTool);
    connect(options_, &ArtworkToolOptions::optionsChanged, canvas_, &ArtworkCanvas::setOptions);
    connect(canvas_, &ArtworkCanvas::optionsChanged, options_, &ArtworkToolOptions::setOptions);
    connect(options_, &ArtworkToolOptions::removeWanted, canvas_, &ArtworkCanvas::removeChosen);
    connect(options_, &ArtworkToolOptions::snapWanted, this, [this] {
        if (draft().form == FormKind::ellipse && draft().ellipse)
            work_->snap(draft().plate, *draft().ellipse);
    });
    connect(options_, &ArtworkToolOptions::lettersWanted, this, [this] {
        if (draft().plate)
            work_->findLetters(draft().plate);
    });
    connect(canvas_, &ArtworkCanvas::outlineDrawn, this,
            [this](const ArtPath& outline, OutlineMode mode) { work_->refine(draft().plate, outline, mode); });
    connect(canvas_, &ArtworkCanvas::sharperWanted, this,
            [this](const ArtRect& part, int longest) { work_->cutSharper(draft().plate, part, longest); });
    connect(canvas_, &ArtworkCanvas::zoomChanged, this, [this] {
        zoom_->setText(draft().plate ? tr("%1 %").arg(canvas_->view().scale() * devicePixelRatioF() * 100, 0, 'f', 0)
                                     : QString());
    });
    connect(card_->add(), &QAbstractButton::clicked, this, [this] { addStyle(ExtractionWork::Then::keepOnly); });
    connect(card_->addAndUse(), &QAbstractButton::clicked, this, [this] { addStyle(ExtractionWork::Then::use); });
    connect(card_->closeButton(), &QAbstractButton::clicked, this, &ExtractionDialog::reject);
}

void ExtractionDialog::connectWork() {
    connect(work_, &ExtractionWork::opened, this, &ExtractionDialog::plateOpened);
    connect(work_, &ExtractionWork::roundThingsFound, this,
            [this](const PlatePtr& plate, const std::vector<RoundThing>& things) {
                if (plate == draft().plate)
                    canvas_->setRoundThings(things);
            });
    connect(work_, &ExtractionWork::sharperCut, canvas_, &ArtworkCanvas::setSharper);
    connect(work_, &ExtractionWork::snapped, this, [this](const PlatePtr& plate, const std::optional<Ellipse>& found) {
        if (plate == draft().plate)
            snapped(found);
    });
    connect(work_, &ExtractionWork::refined, this, &ExtractionDialog::outlineFitted);
    connect(work_, &ExtractionWork::lettersFound, this, [this](const PlatePtr& plate, const MaskPtr& letters) {
        if (plate != draft().plate)
            return;
        ExtractionDraft changed = draft();
        changed.ignored = marksAnything(*letters) ? letters : nullptr;
        changed.skipLettering = false; // what is shown is what counts from now on
        apply({std::move(changed), tr("Find letters"), {}, false});
        card_->say(draft().ignored ? tr("Letters and leader lines are marked; paint to add, Alt erases.")
                                   : tr("There are no letters on this artwork."));
    });
    connect(work_, &ExtractionWork::extracted, this, &ExtractionDialog::extracted);
    connect(work_, &ExtractionWork::extractionFailed, this, &ExtractionDialog::extractionFailed);
    connect(work_, &ExtractionWork::extractionStopped, this, [this] {
        wanted_.reset(); // the next change asks anew
        addWhenDone_.reset();
    });
    connect(work_, &ExtractionWork::added, this, &ExtractionDialog::wasAdded);
    connect(work_, &ExtractionWork::failed, this, [this](const Error& error) {
        addWhenDone_.reset();
        showProblem(lineOf(error));
    });
}

void ExtractionDialog::apply(const DraftEdit& edit) {
    card_->say({}); // it was about what has been done before
    const bool was = std::exchange(ongoing_, edit.ongoing);
    const bool changed = history_.apply(edit);
    if (!changed && was == ongoing_)
        return;
    showDraft();
}

void ExtractionDialog::showDraft() {
    const ExtractionDraft& now = draft();
    const bool otherPlate = now.plate && now.plate != plateShown_;
    pages_->setCurrentIndex(now.plate ? 1 : 0);
    canvas_->setDraft(now);
    options_->setDraft(now);
    form_->setDraft(now);
    card_->setDraft(now);
    for (QWidget* ofPlate : {static_cast<QWidget*>(tools_), static_cast<QWidget*>(options_)})
        ofPlate->setEnabled(now.plate != nullptr);
    if (otherPlate)
        work_->findRoundThings(now.plate);
    if (plateShown_ != now.plate) {
        const QString file =
            now.plate ? QString::fromStdString(now.plate->artwork->file().filename().string()) : QString();
        setWindowTitle(file.isEmpty() ? tr("Style from artwork") : tr("Style from artwork – %1").arg(file));
    }
    plateShown_ = now.plate;
    showActions();
    wantExtraction();
}

void ExtractionDialog::showActions() {
    const auto named = [](const QString& verb, const QString& label) {
        return label.isEmpty() ? verb : tr("%1 “%2”").arg(verb, label);
    };
    undo_->setEnabled(history_.canUndo());
    redo_->setEnabled(history_.canRedo());
    undo_->setToolTip(named(tr("Undo"), history_.undoLabel()));
    redo_->setToolTip(named(tr("Redo"), history_.redoLabel()));
}

void ExtractionDialog::chooseTool(ToolKind kind) {
    tools_->setTool(kind);
    options_->setTool(kind);
    canvas_->setTool(kind);
    canvas_->setFocus();
}

void ExtractionDialog::chooseArtwork() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open artwork"), {},
        tr("Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.psd *.webp *.exr *.bmp);;Everything (*)"));
    if (!path.isEmpty())
        openArtwork(path.toStdString());
}

void ExtractionDialog::openArtwork(const std::filesystem::path& file) { work_->open(file); }

void ExtractionDialog::paste() {
    const QMimeData* copied = QApplication::clipboard()->mimeData();
    if (const auto file = copied ? pictureFile(*copied) : std::nullopt)
        openArtwork(*file);
    else if (copied && copied->hasImage())
        work_->open(QApplication::clipboard()->image(), tr("Pasted picture"));
    else
        showProblem(tr("There is no picture on the clipboard; copy one, or open a file."));
}

void ExtractionDialog::plateOpened(const PlatePtr& plate) {
    ExtractionDraft fresh; // forms and credits belong to the artwork they were made for
    fresh.plate = plate;
    fresh.name = nameOf(plate->artwork->file()).toStdString();
    fresh.size = draft().size;
    notices_->setNotices({}, NoticeBar::Kind::information);
    apply({std::move(fresh), tr("Open artwork"), {}, false});
    card_->say(tr("Click a dashed outline to take it, or draw around a form."));
    canvas_->setFocus();
}

void ExtractionDialog::outlineFitted(const ExtractionWork::Refined& refined) {
    if (refined.plate != draft().plate)
        return;
    if (refined.form.empty() || !marksAnything(refined.form)) {
        apply({withOutline(draft(), refined.outline, refined.mode), tr("Outline form"), {}, false});
        card_->say(tr("Nothing stands out within the outline: it is taken as drawn."));
        return;
    }
    const bool fresh = refined.mode == OutlineMode::replace || !draft().region;
    const Mask base = fresh ? blankMask(*refined.plate) : *draft().region;
    apply({withRegion(draft(), withCutMarked(*refined.plate, base, refined.cut, refined.form), refined.mode),
           tr("Outline form"),
           {},
           false});
    card_->say(tr("Brush and Shift or Alt with the lasso mend the form; normals and creases tell its shape."));
}

void ExtractionDialog::snapped(const std::optional<Ellipse>& ellipse) {
    if (!ellipse) {
        card_->say(tr("There is no edge near the outline to follow."));
        return;
    }
    ExtractionDraft changed = draft();
    changed.form = FormKind::ellipse;
    changed.ellipse = *ellipse;
    apply({std::move(changed), tr("Snap to edge"), {}, false});
    card_->say(tr("The outline follows the edge now."));
}

void ExtractionDialog::wantExtraction() {
    const ExtractionDraft& now = draft();
    if (!canExtract(now)) {
        work_->dropExtraction();
        wanted_.reset();
        shown_ = {};
        failed_ = false;
        addWhenDone_.reset();
        showPictures();
        return;
    }
    if (wanted_ && sameSphere(*wanted_, now) && (wantedWhole_ || ongoing_))
        return;
    wanted_ = now;
    wantedWhole_ = !ongoing_;
    failed_ = false;
    work_->extract(now, ongoing_);
    showPictures();
}

void ExtractionDialog::extracted(const ExtractionDraft& of, std::shared_ptr<const ExtractionPictures> pictures,
                                 bool whole) {
    if (!wanted_ || of.plate != draft().plate)
        return;
    shown_ = {of, std::move(pictures), whole};
    if (notices_->notices() == QStringList(problem_))
        notices_->setNotices({}, NoticeBar::Kind::information);
    showPictures();
    if (addWhenDone_ && sameSphere(of, draft()) && whole)
        addNow(*std::exchange(addWhenDone_, std::nullopt));
}

void ExtractionDialog::extractionFailed(const Error& error) {
    shown_ = {};
    failed_ = true;
    addWhenDone_.reset();
    showProblem(lineOf(error));
    showPictures();
}

void ExtractionDialog::showProblem(const QString& line) {
    problem_ = line.left(1).toUpper() + line.mid(1);
    notices_->setNotices({problem_}, NoticeBar::Kind::problem);
    notices_->raise();
}

void ExtractionDialog::showPictures() {
    QString words = tr("Click a dashed outline or draw around a form: the style appears here.");
    if (draft().form == FormKind::swatches)
        words = tr("Pick light and shadow: the style appears here.");
    if (!draft().plate)
        words = tr("Open an artwork to take styles from.");
    if (failed_)
        words = tr("No style comes of this form; the line above the artwork says why.");
    form_->setPictures(shown_.pictures, words);
    card_->setPossible(canExtract(draft()) && !failed_, whyNotUse());
    showPreview();
}

QString ExtractionDialog::whyNotUse() const {
    if (!figure_ || layer_ >= figure_->layers.size())
        return tr("Open a scan to use styles on it");
    return mayChange(*figure_, layer_) ? QString() : tr("The chosen layer is locked");
}

void ExtractionDialog::showPreview() {
    const QString whyNot = whyNotUse();
    if (!whyNot.isEmpty() || !shown_.pictures) {
        preview_->setWords(whyNot.isEmpty() ? tr("The figure with the style is shown here.") : whyNot + ".");
        preview_->setFigure(nullptr, false);
        return;
    }
    Style style;
    style.card.id = "style-being-made"; // of the preview's figure only
    style.sphere = shown_.pictures->sphere;
    if (shown_.pictures->extraction)
        style.texture = shown_.pictures->extraction->texture;
    preview_->setFigure(std::make_shared<const Figure>(withStyle(*figure_, layer_, node_, style)), ongoing_);
}

void ExtractionDialog::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer,
                                 std::optional<std::size_t> node) {
    figure_ = std::move(figure);
    layer_ = layer;
    node_ = node;
    showPictures();
}

bool ExtractionDialog::unadded() const {
    return canExtract(draft()) && !failed_ && !(added_ && sameSphere(*added_, draft()));
}

void ExtractionDialog::addStyle(ExtractionWork::Then then) {
    if (!canExtract(draft()) || failed_)
        return;
    if (shown_.pictures && shown_.whole && sameSphere(shown_.of, draft())) {
        addNow(then);
        return;
    }
    addWhenDone_ = then; // the newest is still being made
    wantExtraction();
}

void ExtractionDialog::addNow(ExtractionWork::Then then) {
    Style style;
    style.card = cardOf(draft(), QDate::currentDate().toString(Qt::ISODate).toStdString());
    style.sphere = shown_.pictures->sphere;
    if (shown_.pictures->extraction)
        style.texture = shown_.pictures->extraction->texture;
    adding_ = draft();
    work_->add(library_, style, then);
}

void ExtractionDialog::wasAdded(const Style& style, ExtractionWork::Then then) {
    added_ = adding_;
    const QString name = QString::fromStdString(style.card.name);
    Q_EMIT styleAdded(style);
    const bool uses = then == ExtractionWork::Then::use && whyNotUse().isEmpty();
    if (uses)
        Q_EMIT edited({withStyle(*figure_, layer_, node_, style), tr("Style “%1”").arg(name).toStdString(), {}, false});
    ExtractionDraft next = draft();
    next.name = nextName(style.card.name);
    apply({std::move(next), tr("Name"), {}, false});
    card_->say(uses ? tr("“%1” is in your styles and on the figure. Draw the next form, or close.").arg(name)
                    : tr("“%1” is in your styles. Draw the next form, or close.").arg(name));
}

bool ExtractionDialog::mayClose() {
    if (!unadded())
        return true;
    if (askAboutUnadded)
        return askAboutUnadded() == Answer::discard;
    const auto button = QMessageBox::question(this, tr("Style not added"),
                                              tr("The style on the ball has not been added. Close without it?"),
                                              QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel);
    return button == QMessageBox::Discard;
}

void ExtractionDialog::reject() {
    if (mayClose())
        QDialog::reject();
}

void ExtractionDialog::dragEnterEvent(QDragEnterEvent* event) {
    if (pictureFile(*event->mimeData()) || event->mimeData()->hasImage())
        event->acceptProposedAction();
}

void ExtractionDialog::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    if (const auto file = pictureFile(*event->mimeData()))
        openArtwork(*file);
    else if (event->mimeData()->hasImage())
        work_->open(qvariant_cast<QImage>(event->mimeData()->imageData()), tr("Dropped picture"));
}

} // namespace limner
