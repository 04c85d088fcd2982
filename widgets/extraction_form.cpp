#include "widgets/extraction_form.h"

#include "widgets/curve_editor.h"
#include "widgets/extraction_words.h"
#include "widgets/form_parts.h"
#include "widgets/slider_row.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace limner {
namespace {

constexpr std::size_t kFigureRows = 4;
constexpr int kTile = 56; // logical pixels

QCheckBox* box(const QString& text, const QString& tip) {
    auto* result = new QCheckBox(text);
    result->setToolTip(tip);
    return result;
}

} // namespace

ExtractionForm::ExtractionForm(QWidget* parent)
    : QWidget(parent), pictureRow_(new QGridLayout), view_(new ExtractionView),
      filled_(box(tr("Show what is filled in"), tr("Tints the parts of the ball that were not seen in the artwork"))),
      advice_(new QLabel),
      depth_(new SliderRow(tr("Depth"), tr("How deep the form is: 1 as deep as it is wide, less for a relief"),
                           {0.1, 4, 0.05, 2})),
      smoothing_(
          new SliderRow(tr("Smoothing"), tr("Evens out grain and hatching, edges of light and shadow stay"), {})),
      turn_(new SliderRow(tr("Turn light"), tr("Turns the light counter-clockwise about the line of sight"),
                          {-180, 180, 1, 0, tr("°")})),
      tile_(new QLabel), size_(new QComboBox),
      byAngle_(box(tr("Opacity by &angle"), tr("Makes the style clearer where it faces the viewer, or at its rim"))),
      opacity_(new CurveEditor(tr("facing → rim"))) {
    buildBoxes();
    pictureRow_->setContentsMargins(0, 0, 0, 0);
    pictureRow_->setHorizontalSpacing(8);
    pictureRow_->setVerticalSpacing(4);
    pictureRow_->addWidget(buildSwitch(), 0, 0);
    pictureRow_->addWidget(view_, 1, 0);
    constexpr int kPictureHeight = 280;
    pictureRow_->setRowMinimumHeight(1, kPictureHeight);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addLayout(pictureRow_);
    layout->addWidget(buildFigures());
    layout->addWidget(buildControls());
    layout->addStretch(1);
    connectControls();
    setDraft({});
    setPictures(nullptr, {});
}

void ExtractionForm::buildBoxes() {
    symmetric_ =
        box(tr("S&ymmetric about the light"), tr("Takes the mean of the ball and its mirror image: what is not "
                                                 "lighting goes"));
    paperCast_ = box(tr("Remove paper &cast"), tr("As if painted on white paper instead of this one"));
    lettering_ = box(tr("&Leave letters out"), tr("Printed letters and leader lines over the form are not looked at"));
    texture_ = box(tr("Separate te&xture"), tr("Keeps grain, hatching and patterns as a tile beside the lighting"));
    tile_->setFixedSize(kTile, kTile);
    tile_->setAccessibleName(tr("Texture tile"));
    tile_->setToolTip(tr("What the lighting does not explain, as a tile without seams"));
    for (const int pixels : {128, 256, 512, 1024, 2048})
        size_->addItem(tr("%1 pixels").arg(pixels), pixels);
    size_->setAccessibleName(tr("Size"));
    size_->setToolTip(tr("Side of the style's picture; 512 is plenty for print"));
    leaveWheelToPanel(size_);
}

QWidget* ExtractionForm::buildSwitch() {
    auto* bar = new QWidget;
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    shows_ = new QButtonGroup(this);
    using Shows = ExtractionView::Shows;
    const std::tuple<Shows, QString, QString> choices[] = {
        {Shows::ball, tr("Ball"), tr("The style as a ball")},
        {Shows::reshaded, tr("Re-shaded"),
         tr("The form, shaded again with the style: it should look like the artwork")},
        {Shows::difference, tr("Difference"), tr("Grey: as in the artwork; lighter or darker: the artwork is")}};
    for (const auto& [shows, text, tip] : choices) {
        QToolButton* button = textButton(text, tip);
        showWhenChosen(button);
        button->setChecked(shows == Shows::ball);
        shows_->addButton(button, static_cast<int>(shows));
        layout->addWidget(button);
    }
    layout->addStretch(1);
    connect(shows_, &QButtonGroup::idClicked, this, [this](int id) { view_->setShows(static_cast<Shows>(id)); });
    return bar;
}

QWidget* ExtractionForm::buildFigures() {
    auto* content = new QWidget;
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(3, 1);
    for (std::size_t i = 0; i < kFigureRows; ++i) {
        FigureRow row{new QLabel, new QLabel, new QLabel};
        row.number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        const int line = static_cast<int>(i);
        grid->addWidget(row.label, line, 0);
        grid->addWidget(row.number, line, 1);
        grid->addWidget(row.word, line, 2);
        figures_.push_back(row);
    }
    advice_->setWordWrap(true);
    advice_->setAccessibleName(tr("What to do"));
    constexpr int kAdviceHeight = 38; // two lines: the controls below stay where they are
    advice_->setMinimumHeight(kAdviceHeight);
    advice_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    grid->addWidget(advice_, static_cast<int>(kFigureRows), 0, 1, 4);
    grid->addWidget(filled_, 0, 3, static_cast<int>(kFigureRows), 1, Qt::AlignRight | Qt::AlignTop);
    return content;
}

QWidget* ExtractionForm::buildControls() {
    auto* content = new QWidget;
    QFormLayout* form = formLayout(content);
    depthLabel_ = addLabelled(form, tr("&Depth"), depth_);
    addLabelled(form, tr("&Smoothing"), smoothing_);
    addLabelled(form, tr("T&urn light"), turn_);
    auto* boxes = new QGridLayout;
    boxes->setContentsMargins(0, 2, 0, 2);
    boxes->setHorizontalSpacing(14);
    boxes->setVerticalSpacing(4);
    boxes->addWidget(symmetric_, 0, 0);
    boxes->addWidget(paperCast_, 0, 1);
    boxes->addWidget(lettering_, 1, 0);
    boxes->addWidget(texture_, 1, 1);
    boxes->addWidget(byAngle_, 2, 0);
    boxes->setColumnStretch(1, 1);
    boxes->addWidget(tile_, 0, 2, 3, 1, Qt::AlignRight | Qt::AlignTop);
    form->addRow(boxes);
    form->addRow(opacity_);
    addLabelled(form, tr("Si&ze"), size_);
    return content;
}

void ExtractionForm::once(ExtractionDraft changed, const QString& label) {
    Q_EMIT edited({std::move(changed), label, {}, false});
}

void ExtractionForm::changeEdits(const QString& label, const std::string& key, bool ongoing, const SphereEdits& edits) {
    ExtractionDraft changed = draft_;
    changed.edits = edits;
    Q_EMIT edited({std::move(changed), label, key, ongoing});
}

void ExtractionForm::connectControls() {
    connect(filled_, &QCheckBox::toggled, view_, &ExtractionView::setShowsFilled);
    connect(depth_, &SliderRow::changed, this, [this](double value, const std::string& key, bool ongoing) {
        ExtractionDraft changed = draft_;
        changed.marks.depth = value;
        Q_EMIT edited({std::move(changed), tr("Depth"), key, ongoing});
    });
    connect(smoothing_, &SliderRow::changed, this, [this](double value, const std::string& key, bool ongoing) {
        SphereEdits edits = draft_.edits;
        edits.smoothing = value;
        changeEdits(tr("Smoothing"), key, ongoing, edits);
    });
    connect(turn_, &SliderRow::changed, this, [this](double value, const std::string& key, bool ongoing) {
        SphereEdits edits = draft_.edits;
        edits.turnDegrees = value;
        changeEdits(tr("Turn light"), key, ongoing, edits);
    });
    connect(symmetric_, &QCheckBox::clicked, this, [this](bool on) {
        SphereEdits edits = draft_.edits;
        edits.symmetric = on;
        changeEdits(tr("Symmetric"), {}, false, edits);
    });
    connect(byAngle_, &QCheckBox::clicked, this, [this](bool on) {
        SphereEdits edits = draft_.edits;
        edits.alpha = on ? AlphaCurve{{0, 0.25}, {1, 1}} : AlphaCurve{}; // a start that can be seen
        changeEdits(tr("Opacity by angle"), {}, false, edits);
    });
    connect(opacity_, &CurveEditor::changed, this,
            [this](const OpacityPoints& points, const QString& what, const std::string& key, bool ongoing) {
                SphereEdits edits = draft_.edits;
                edits.alpha = points;
                changeEdits(what, key, ongoing, edits);
            });
    const auto toggles = [this](QCheckBox* of, bool ExtractionDraft::*flag) {
        connect(of, &QCheckBox::clicked, this, [this, of, flag](bool on) {
            ExtractionDraft changed = draft_;
            changed.*flag = on;
            once(std::move(changed), of->text().remove('&'));
        });
    };
    toggles(paperCast_, &ExtractionDraft::removePaperCast);
    toggles(lettering_, &ExtractionDraft::skipLettering);
    toggles(texture_, &ExtractionDraft::separateTexture);
    connect(size_, &QComboBox::activated, this, [this] {
        ExtractionDraft changed = draft_;
        changed.size = size_->currentData().toInt();
        once(std::move(changed), tr("Size"));
    });
    connect(view_, &ExtractionView::lightTurned, this,
            [this](const glm::dvec2& towards, const std::string& key, bool ongoing) {
                ExtractionDraft changed = draft_;
                changed.swatches.towardsLight = towards;
                Q_EMIT edited({std::move(changed), tr("Turn light"), key, ongoing});
            });
}

void ExtractionForm::setDraft(const ExtractionDraft& draft) {
    draft_ = draft;
    depth_->setValue(draft.marks.depth);
    depth_->setVisible(draft.form == FormKind::region);
    depthLabel_->setVisible(draft.form == FormKind::region);
    smoothing_->setValue(draft.edits.smoothing);
    turn_->setValue(draft.edits.turnDegrees);
    symmetric_->setChecked(draft.edits.symmetric);
    paperCast_->setChecked(draft.removePaperCast);
    lettering_->setChecked(draft.skipLettering);
    texture_->setChecked(draft.separateTexture);
    byAngle_->setChecked(!draft.edits.alpha.empty());
    opacity_->setVisible(!draft.edits.alpha.empty());
    opacity_->setPoints(draft.edits.alpha);
    size_->setCurrentIndex(size_->findData(draft.size));
    const bool swatches = draft.form == FormKind::swatches;
    for (QCheckBox* ofArtwork : {paperCast_, lettering_, texture_})
        ofArtwork->setEnabled(!swatches);
    view_->setLight(swatches && canExtract(draft) ? std::optional(draft.swatches.towardsLight) : std::nullopt);
}

void ExtractionForm::setPictures(std::shared_ptr<const ExtractionPictures> pictures, const QString& words) {
    pictures_ = std::move(pictures);
    view_->setWords(words);
    view_->setPictures(pictures_);
    const bool extracted = pictures_ && pictures_->extraction;
    filled_->setEnabled(extracted && !pictures_->filled.isNull());
    tile_->setVisible(pictures_ && !pictures_->tile.isNull());
    if (tile_->isVisibleTo(this)) {
        QPixmap tile = QPixmap::fromImage(
            pictures_->tile.scaled(tile_->size() * devicePixelRatioF(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
        tile.setDevicePixelRatio(devicePixelRatioF());
        tile_->setPixmap(tile);
    }
    showFigures();
}

void ExtractionForm::showFigures() {
    std::vector<GradedFigure> graded;
    if (pictures_ && pictures_->extraction)
        graded = gradedFigures(pictures_->extraction->figures, draft_.form == FormKind::region);
    for (std::size_t i = 0; i < figures_.size(); ++i) {
        const FigureRow& row = figures_[i];
        const bool there = i < graded.size();
        for (QLabel* label : {row.label, row.number, row.word}) {
            label->setVisible(there);
            label->setToolTip(there ? graded[i].tip + "\n" + graded[i].advice : QString());
        }
        if (!there)
            continue;
        row.label->setText(graded[i].label);
        row.number->setText(graded[i].number);
        row.word->setText(QStringLiteral("<b>%1</b>").arg(gradeWord(graded[i].grade)));
        QPalette colours = palette();
        colours.setColor(QPalette::WindowText, gradeColour(graded[i].grade, palette()));
        row.word->setPalette(colours);
        row.label->setAccessibleDescription(graded[i].tip + " " + graded[i].advice);
    }
    if (!pictures_)
        advice_->setText(tr("Coverage, residual and holes are told here once a style is extracted."));
    else if (graded.empty())
        advice_->setText(tr("Made of picked colours: there is nothing to measure it by."));
    else
        advice_->setText(std::ranges::max(graded, {}, &GradedFigure::grade).advice);
}

void ExtractionForm::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange)
        showFigures();
    QWidget::changeEvent(event);
}

} // namespace limner
