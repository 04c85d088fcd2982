#include "widgets/annotation_form.h"

#include "core/figure/annotation_edits.h"
#include "core/figure/rich_text.h"
#include "widgets/colour_button.h"
#include "widgets/form_parts.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTextCursor>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace limner {
namespace {

constexpr int kListHeight = 132; // six; more scroll
constexpr int kWordsHeight = 64; // three lines
constexpr double kMostPt = 200;
constexpr double kMostMm = 10000;

QString kindName(const std::string& kind) {
    if (kind == "label")
        return AnnotationForm::tr("Label");
    if (kind == "scale-bar")
        return AnnotationForm::tr("Scale bar");
    if (kind == "orientation")
        return AnnotationForm::tr("Orientation mark");
    if (kind == "title")
        return AnnotationForm::tr("Title");
    if (kind == "caption")
        return AnnotationForm::tr("Caption");
    return AnnotationForm::tr("Legend");
}

QString rowText(const Annotation& annotation) {
    const QString kind = kindName(annotation.kind);
    const QString words = QString::fromStdString(plainText(annotation.text));
    return words.isEmpty() ? kind : AnnotationForm::tr("%1: %2").arg(kind, words);
}

} // namespace

AnnotationForm::AnnotationForm(QWidget* parent)
    : QWidget(parent), layout_(choiceBox("/annotation_layout", {{"columns", tr("Columns at the sides")},
                                                                {"ring", tr("Ring around the figure")},
                                                                {"free", tr("Free, beside their points")}})),
      list_(new QListWidget), add_(textButton(tr("&Add"), tr("Add a label, a scale bar, a title and the like"))),
      remove_(textButton(tr("Remo&ve"), tr("Remove the chosen one (Delete)"))), settings_(new QWidget),
      words_(new QPlainTextEdit), colour_(new ColourButton(tr("Colour of the letters"))),
      ownColour_(new QCheckBox(tr("Own &colour"))),
      side_(choiceBox("/annotations/0/side",
                      {{"auto", tr("Whichever is nearer")}, {"left", tr("Left")}, {"right", tr("Right")}})),
      automatic_(new QCheckBox(tr("Placed &automatically"))) {
    buildTop();
    buildSettings();
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add_);
    buttons->addWidget(remove_);
    buttons->addStretch(1);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    auto* top = formLayout();
    addLabelled(top, tr("La&bels stand"), layout_);
    column->addLayout(top);
    column->addWidget(list_);
    column->addLayout(buttons);
    column->addWidget(settings_);
    column->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolling(content));
    showChosen();
}

void AnnotationForm::buildTop() {
    list_->setFixedHeight(kListHeight);
    list_->setUniformItemSizes(true);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setAccessibleName(tr("Annotations"));
    list_->setToolTip(tr("What is written over the figure; drag it in the picture to place it"));
    list_->installEventFilter(this);
    auto* menu = new QMenu(this);
    for (const char* kind : {"label", "scale-bar", "orientation", "title", "caption", "legend"}) {
        QAction* action = menu->addAction(kindName(kind));
        action->setObjectName(kind);
        connect(action, &QAction::triggered, this, [this, kind = std::string(kind)] {
            if (kind == "label")
                Q_EMIT labelWanted();
            else
                addKind(kind);
        });
    }
    add_->setMenu(menu);
    add_->setPopupMode(QToolButton::InstantPopup);
    connect(remove_, &QToolButton::clicked, this, &AnnotationForm::removeSelected);
    connect(list_, &QListWidget::currentRowChanged, this, [this] {
        showChosen();
        Q_EMIT selectionChanged();
    });
    connect(list_, &QListWidget::itemDoubleClicked, this, [this] { words_->setFocus(); });
    connect(layout_, &QComboBox::activated, this, [this] {
        Edit edit{*figure_, tr("Layout of labels").toStdString(), {}, false};
        edit.figure.annotationLayout = chosenWord(layout_);
        Q_EMIT edited(edit);
    });
}

QWidget* AnnotationForm::buildMarkup() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    struct Mark {
        const char* tag;
        QString text, tip;
        QKeySequence keys;
    };
    const std::array<Mark, 4> marks{
        Mark{"b", tr("B"), tr("Bold"), QKeySequence::Bold}, Mark{"i", tr("I"), tr("Italic"), QKeySequence::Italic},
        Mark{"sub", tr("x₂"), tr("Subscript"), {}}, Mark{"sup", tr("x²"), tr("Superscript"), {}}};
    for (const Mark& one : marks) {
        QToolButton* button = textButton(one.text, one.tip);
        button->setObjectName(one.tag);
        button->setAccessibleName(one.tip);
        QFont font = button->font();
        font.setBold(one.tag == std::string("b"));
        font.setItalic(one.tag == std::string("i"));
        button->setFont(font);
        connect(button, &QToolButton::clicked, this, [this, tag = one.tag] { mark(tag); });
        row->addWidget(button);
    }
    QToolButton* greek = textButton(tr("Ω"), tr("Greek letters and signs"));
    greek->setAccessibleName(tr("Greek letters and signs"));
    auto* menu = new QMenu(greek);
    auto* grid = new QMenu(tr("Capitals"), menu);
    for (const char32_t letter : std::u32string(U"αβγδεζηθικλμνξοπρστυφχψω"))
        connect(menu->addAction(QString::fromUcs4(&letter, 1)), &QAction::triggered, this,
                [this, letter] { words_->insertPlainText(QString::fromUcs4(&letter, 1)); });
    for (const char32_t letter : std::u32string(U"ΓΔΘΛΞΠΣΦΨΩ"))
        connect(grid->addAction(QString::fromUcs4(&letter, 1)), &QAction::triggered, this,
                [this, letter] { words_->insertPlainText(QString::fromUcs4(&letter, 1)); });
    auto* signs = new QMenu(tr("Signs"), menu);
    for (const char32_t letter : std::u32string(U"°±×µ–—→←’″‰♂♀"))
        connect(signs->addAction(QString::fromUcs4(&letter, 1)), &QAction::triggered, this,
                [this, letter] { words_->insertPlainText(QString::fromUcs4(&letter, 1)); });
    menu->insertMenu(menu->actions().front(), signs);
    menu->insertMenu(menu->actions().front(), grid);
    greek->setMenu(menu);
    greek->setPopupMode(QToolButton::InstantPopup);
    row->addWidget(greek);
    row->addStretch(1);
    return bar;
}

QDoubleSpinBox* AnnotationForm::spin(double most, const QString& suffix, const QString& whenZero) {
    auto* box = new QDoubleSpinBox;
    box->setRange(0, most);
    box->setDecimals(1);
    box->setSuffix(suffix);
    if (!whenZero.isEmpty())
        box->setSpecialValueText(whenZero);
    box->setKeyboardTracking(false);
    leaveWheelToPanel(box);
    return box;
}

void AnnotationForm::buildSettings() {
    rows_ = formLayout(settings_);
    words_->setFixedHeight(kWordsHeight);
    words_->setTabChangesFocus(true);
    words_->setAccessibleName(tr("Words"));
    words_->setToolTip(helpOfSetting("/annotations/0/text"));
    rows_->addRow(words_);
    rows_->addRow(buildMarkup());
    size_ = spin(kMostPt, tr(" pt"), tr("Usual"));
    size_->setSingleStep(0.5);
    length_ = spin(kMostMm, tr(" mm"), tr("Round"));
    across_ = spin(100, tr(" %"), {});
    down_ = spin(100, tr(" %"), {});
    size_->setToolTip(helpOfSetting("/annotations/0/size_pt"));
    length_->setToolTip(tr("Length in the patient; in a perspective it is true in the plane of the camera's target"));
    across_->setToolTip(tr("Place from the left edge, in percent of the sheet's width"));
    down_->setToolTip(tr("Place from the top, in percent of the sheet's height"));
    automatic_->setToolTip(tr("Off where you have dragged it; on gives the place back to the layout"));
    ownColour_->setToolTip(tr("Off: black, or white on dark paper"));
    addLabelled(rows_, tr("Si&ze"), size_);
    addLabelled(rows_, tr("&Length"), length_);
    addLabelled(rows_, tr("&Side"), side_);
    auto* colours = new QHBoxLayout;
    colours->addWidget(ownColour_);
    colours->addWidget(colour_);
    colours->addStretch(1);
    rows_->addRow(QString(), colours);
    rows_->addRow(QString(), automatic_);
    addLabelled(rows_, tr("From the le&ft"), across_);
    addLabelled(rows_, tr("From the &top"), down_);
    connectSettings();
}

void AnnotationForm::connectSettings() {
    connect(words_, &QPlainTextEdit::textChanged, this, [this] {
        change(tr("Write %1").arg(kindName(figure_->annotations[*selected()].kind).toLower()),
               key_.again("annotation/words"), [&](Annotation& a) { a.text = words_->toPlainText().toStdString(); });
    });
    const auto optional = [](double value) { return value > 0 ? std::optional(value) : std::nullopt; };
    connect(size_, &QDoubleSpinBox::valueChanged, this, [=, this](double value) {
        change(tr("Size of letters"), key_.again("annotation/size"),
               [&](Annotation& a) { a.sizePt = optional(value); });
    });
    connect(length_, &QDoubleSpinBox::valueChanged, this, [=, this](double value) {
        change(tr("Length of scale bar"), key_.again("annotation/length"),
               [&](Annotation& a) { a.lengthMm = optional(value); });
    });
    connect(side_, &QComboBox::activated, this,
            [this] { change(tr("Side of label"), {}, [&](Annotation& a) { a.side = chosenWord(side_); }); });
    connect(ownColour_, &QCheckBox::clicked, this, [this](bool on) {
        change(tr("Colour of letters"), {},
               [&](Annotation& a) { a.rgb = on ? std::optional(colour_->colour()) : std::nullopt; });
    });
    connect(colour_, &ColourButton::chosen, this, [this](const glm::dvec3& rgb) {
        change(tr("Colour of letters"), {}, [&](Annotation& a) { a.rgb = rgb; });
    });
    connect(automatic_, &QCheckBox::clicked, this, [this](bool on) {
        const glm::dvec2 at(across_->value() / 100, down_->value() / 100);
        change(on ? tr("Place automatically") : tr("Keep place"), {},
               [&](Annotation& a) { a.at = on ? std::nullopt : std::optional(at); });
    });
    for (QDoubleSpinBox* box : {across_, down_})
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            change(tr("Move lettering"), key_.again("annotation/at"),
                   [&](Annotation& a) { a.at = glm::dvec2(across_->value() / 100, down_->value() / 100); });
        });
}

std::optional<std::size_t> AnnotationForm::selected() const {
    const int row = list_->currentRow();
    return figure_ && row >= 0 && static_cast<std::size_t>(row) < figure_->annotations.size()
               ? std::optional<std::size_t>(row)
               : std::nullopt;
}

void AnnotationForm::select(std::optional<std::size_t> index) {
    list_->setCurrentRow(index ? static_cast<int>(*index) : -1);
}

void AnnotationForm::writeWords(std::size_t index) {
    select(index);
    words_->setFocus(Qt::OtherFocusReason);
    words_->selectAll();
}

void AnnotationForm::setFigure(std::shared_ptr<const Figure> figure) {
    figure_ = std::move(figure);
    const int count = figure_ ? static_cast<int>(figure_->annotations.size()) : 0;
    {
        const QSignalBlocker quiet(list_);
        while (list_->count() > count)
            delete list_->takeItem(list_->count() - 1);
        while (list_->count() < count)
            list_->addItem(QString());
        for (int i = 0; i < count; ++i)
            list_->item(i)->setText(rowText(figure_->annotations[static_cast<std::size_t>(i)]));
    }
    add_->setEnabled(figure_ && figure_->annotations.size() < kMostAnnotations);
    layout_->setEnabled(figure_ != nullptr);
    choose(layout_, figure_ ? figure_->annotationLayout : Figure{}.annotationLayout);
    showChosen();
}

void AnnotationForm::setPlaces(const std::vector<AnnotationPlace>& places) {
    places_ = places;
    for (int i = 0; i < list_->count() && i < static_cast<int>(places_.size()); ++i) {
        const AnnotationPlace& place = places_[static_cast<std::size_t>(i)];
        const QString note = QString::fromStdString(place.note);
        QListWidgetItem* item = list_->item(i);
        item->setToolTip(note.isEmpty() ? item->text() : item->text() + "\n" + note);
        item->setForeground(palette().color(place.drawn ? QPalette::Normal : QPalette::Disabled, QPalette::Text));
    }
    showChosen();
}

void AnnotationForm::showChosen() {
    const auto chosen = selected();
    remove_->setEnabled(chosen.has_value());
    settings_->setEnabled(chosen.has_value());
    const Annotation annotation = chosen ? figure_->annotations[*chosen] : Annotation{};
    const QString words = QString::fromStdString(annotation.text);
    if (words_->toPlainText() != words) { // else the cursor would jump while one writes
        const QSignalBlocker quiet(words_);
        words_->setPlainText(words);
    }
    words_->setPlaceholderText(annotation.kind == "title"       ? tr("The figure's title")
                               : annotation.kind == "scale-bar" ? tr("Its length")
                               : annotation.kind == "legend"    ? tr("Heading, or none")
                                                                : tr("Words"));
    words_->setEnabled(annotation.kind != "orientation");
    const auto show = [](QDoubleSpinBox* box, double value) {
        const QSignalBlocker quiet(box);
        box->setValue(value);
    };
    show(size_, annotation.sizePt.value_or(0));
    show(length_, annotation.lengthMm.value_or(0));
    choose(side_, annotation.side);
    ownColour_->setChecked(annotation.rgb.has_value());
    colour_->setColour(annotation.rgb.value_or(glm::dvec3(0)));
    automatic_->setChecked(!annotation.at);
    const bool seen = chosen && *chosen < places_.size();
    const glm::dvec2 at = annotation.at.value_or(seen ? places_[*chosen].at : glm::dvec2(0.5));
    show(across_, at.x * 100);
    show(down_, at.y * 100);
    for (const auto& [field, kind] : {std::pair<QWidget*, const char*>{length_, "scale-bar"}, {side_, "label"}}) {
        field->setVisible(annotation.kind == kind);
        rows_->labelForField(field)->setVisible(annotation.kind == kind);
    }
    side_->setEnabled(!annotation.at && figure_ && figure_->annotationLayout != "ring");
}

void AnnotationForm::change(const QString& label, const std::string& key,
                            const std::function<void(Annotation&)>& change) {
    const auto chosen = selected();
    if (!chosen)
        return;
    Edit edit{*figure_, label.toStdString(), key.empty() ? key : key + "@" + std::to_string(*chosen), false};
    change(edit.figure.annotations[*chosen]);
    Q_EMIT edited(edit);
}

void AnnotationForm::mark(const char* tag) {
    const QString open = QString("<%1>").arg(tag);
    const QString close = QString("</%1>").arg(tag);
    QTextCursor cursor = words_->textCursor();
    QString chosen = cursor.selectedText();
    const bool marked = chosen.startsWith(open) && chosen.endsWith(close);
    chosen = marked ? chosen.mid(open.size(), chosen.size() - open.size() - close.size()) : open + chosen + close;
    const int from = cursor.selectionStart();
    const bool empty = !cursor.hasSelection();
    cursor.insertText(chosen);
    const int length = static_cast<int>(chosen.size());
    if (empty) { // what is typed next stands between the tags
        cursor.setPosition(from + static_cast<int>(open.size()));
    } else {
        cursor.setPosition(from);
        cursor.setPosition(from + length, QTextCursor::KeepAnchor);
    }
    words_->setTextCursor(cursor);
    words_->setFocus();
}

void AnnotationForm::addKind(const std::string& kind) {
    if (!figure_ || figure_->annotations.size() >= kMostAnnotations)
        return;
    Edit edit{*figure_, tr("Add %1").arg(kindName(kind).toLower()).toStdString(), {}, false};
    Annotation annotation = newAnnotation(kind);
    if (kind == "caption")
        annotation.text = tr("Caption").toStdString();
    if (kind == "title" && figure_->title.empty())
        annotation.text = tr("Title").toStdString();
    edit.figure.annotations.push_back(annotation);
    Q_EMIT edited(edit);
    if (kind == "caption" || kind == "title")
        writeWords(figure_->annotations.size() - 1);
    else
        select(figure_->annotations.size() - 1);
}

void AnnotationForm::removeSelected() {
    const auto chosen = selected();
    if (!chosen)
        return;
    Edit edit{
        *figure_, tr("Remove %1").arg(kindName(figure_->annotations[*chosen].kind).toLower()).toStdString(), {}, false};
    auto& left = edit.figure.annotations;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(*chosen));
    Q_EMIT edited(edit);
}

bool AnnotationForm::eventFilter(QObject* watched, QEvent* event) {
    if (watched == list_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Delete) {
            removeSelected();
            return true;
        }
        if ((key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_F2) && selected()) {
            writeWords(*selected());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace limner
