#include "widgets/artwork_tool_bar.h"

#include "widgets/artwork_picker_tool.h"
#include "widgets/artwork_tool_icons.h"
#include "widgets/form_parts.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QPainter>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSlider>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr int kIcon = 20;
constexpr int kChip = 18;

struct ToolRow {
    ToolKind kind;
    const char* name;
    const char* tip;
    const char* key;
    bool startsGroup;
};

constexpr ToolRow kTools[] = {
    {ToolKind::circle, QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Circle"),
     QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Take a style from a round thing: a ball, an eye, a fruit"), "C",
     false},
    {ToolKind::ellipse, QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Ellipse"),
     QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "As the circle, for a ball seen at an angle or egg-shaped"), "E",
     false},
    {ToolKind::region, QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Region"),
     QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Take a style from any shaded form: drag around it"), "R", true},
    {ToolKind::brush, QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Brush"),
     QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Paint more of the form, or erase some of it"), "B", false},
    {ToolKind::normal, QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Normal"),
     QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Tell how the form faces at a place"), "N", false},
    {ToolKind::crease, QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Crease"),
     QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Draw a ridge or a valley of the form"), "L", false},
    {ToolKind::open, QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Open edge"),
     QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Tell where the form goes on behind something or is cut off"), "O",
     false},
    {ToolKind::ignore, QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Ignore"),
     QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Paint over letters and lines that are not the form's"), "I", true},
    {ToolKind::picker, QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Picker"),
     QT_TRANSLATE_NOOP("limner::ArtworkToolBar", "Make a style of two to five colours picked from the artwork"), "P",
     true},
};

/// At once: a button's own short cut waits for the picture of a press, and the hand may be faster.
void clickBy(QToolButton* button, const char* key) {
    QObject::connect(new QShortcut(QKeySequence(key), button), &QShortcut::activated, button, &QToolButton::click);
}

QHBoxLayout* lineOf(QWidget* page) {
    auto* line = new QHBoxLayout(page);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    return line;
}

QIcon chipIcon(const std::optional<PickedSwatch>& swatch, const QPalette& palette, double pixelRatio) {
    QPixmap pixmap(QSize(kChip, kChip) * pixelRatio);
    pixmap.setDevicePixelRatio(pixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette.color(QPalette::ButtonText), 1, swatch ? Qt::SolidLine : Qt::DashLine));
    if (swatch)
        painter.setBrush(QColor::fromRgbF(swatch->colour.r, swatch->colour.g, swatch->colour.b));
    painter.drawRoundedRect(QRectF(1, 1, kChip - 2, kChip - 2), 3, 3);
    return pixmap;
}

} // namespace

ArtworkToolBar::ArtworkToolBar(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* group = new QButtonGroup(this);
    constexpr int kGap = 10;
    for (const ToolRow& row : kTools) {
        if (row.startsGroup)
            layout->addSpacing(kGap);
        QToolButton* button = textButton(tr(row.name), tr("%1 (%2)").arg(tr(row.tip), row.key));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setIconSize({kIcon, kIcon});
        showWhenChosen(button);
        button->setAutoRaise(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        clickBy(button, row.key);
        group->addButton(button, static_cast<int>(row.kind));
        layout->addWidget(button);
        buttons_[row.kind] = button;
    }
    layout->addStretch(1);
    connect(group, &QButtonGroup::idClicked, this, [this](int id) { Q_EMIT chosen(static_cast<ToolKind>(id)); });
    showIcons();
    setTool(ToolKind::circle);
}

void ArtworkToolBar::setTool(ToolKind kind) { buttons_.at(kind)->setChecked(true); }

void ArtworkToolBar::showIcons() {
    for (const auto& [kind, button] : buttons_)
        button->setIcon(toolIcon(kind, palette(), kIcon, devicePixelRatioF()));
}

void ArtworkToolBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange)
        showIcons();
    QWidget::changeEvent(event);
}

ArtworkToolOptions::ArtworkToolOptions(QWidget* parent) : QWidget(parent), pages_(new QStackedWidget) {
    for (QWidget* page : {ballPage(), outlinePage(), brushPage(), markPage(), pickerPage()})
        pages_->addWidget(page);
    auto* layout = lineOf(this);
    layout->addWidget(pages_, 1);
    setTool(kind_);
    setOptions(options_);
    setDraft({});
}

QWidget* ArtworkToolOptions::ballPage() {
    auto* page = new QWidget;
    fromCentre_ = new QCheckBox(tr("From the &centre"));
    fromCentre_->setToolTip(tr("Draw from the ball's centre; off: from edge to edge (Alt does the other)"));
    snap_ = textButton(tr("Snap to edge"), tr("Lets the outline follow the picture's edge near it (S)"));
    clickBy(snap_, "S");
    auto* line = lineOf(page);
    line->addWidget(fromCentre_);
    line->addWidget(snap_);
    line->addStretch(1);
    connect(fromCentre_, &QCheckBox::clicked, this, [this](bool on) {
        ToolOptions changed = options_;
        changed.fromCentre = on;
        change(changed);
    });
    connect(snap_, &QToolButton::clicked, this, &ArtworkToolOptions::snapWanted);
    return page;
}

QWidget* ArtworkToolOptions::outlinePage() {
    auto* page = new QWidget;
    findEdge_ = new QCheckBox(tr("&Find the edge"));
    findEdge_->setToolTip(tr("Fits a rough outline to the form it means; off: takes it as drawn"));
    auto* line = lineOf(page);
    line->addWidget(findEdge_);
    line->addStretch(1);
    connect(findEdge_, &QCheckBox::clicked, this, [this](bool on) {
        ToolOptions changed = options_;
        changed.findEdge = on;
        change(changed);
    });
    return page;
}

QWidget* ArtworkToolOptions::brushPage() {
    auto* page = new QWidget;
    brush_ = new QSlider(Qt::Horizontal);
    brush_->setRange(2, 120);
    brush_->setFixedWidth(140);
    brush_->setAccessibleName(tr("Brush size"));
    brush_->setToolTip(tr("Radius of the brush on the screen ([ and ])"));
    letters_ = textButton(tr("Find letters"), tr("Marks printed letters and leader lines; paint to add, Alt to erase"));
    clear_ = textButton(tr("Clear"), tr("Takes all of this painting away"));
    auto* line = lineOf(page);
    auto* label = new QLabel(tr("Brush"));
    label->setBuddy(brush_);
    line->addWidget(label);
    line->addWidget(brush_);
    line->addWidget(letters_);
    line->addWidget(clear_);
    line->addStretch(1);
    connect(brush_, &QSlider::valueChanged, this, [this](int radius) {
        ToolOptions changed = options_;
        changed.brushRadius = radius;
        change(changed);
    });
    connect(letters_, &QToolButton::clicked, this, &ArtworkToolOptions::lettersWanted);
    connect(clear_, &QToolButton::clicked, this, &ArtworkToolOptions::removeWanted);
    return page;
}

QWidget* ArtworkToolOptions::markPage() {
    auto* page = new QWidget;
    remove_ = textButton(tr("Remove"), tr("Removes the chosen mark (Delete)"));
    auto* line = lineOf(page);
    line->addWidget(remove_);
    line->addStretch(1);
    connect(remove_, &QToolButton::clicked, this, &ArtworkToolOptions::removeWanted);
    return page;
}

QWidget* ArtworkToolOptions::pickerPage() {
    auto* page = new QWidget;
    auto* line = lineOf(page);
    auto* group = new QButtonGroup(this);
    const QString tips[kSwatchRoles] = {
        tr("Where the light falls"), tr("Between light and shadow"), tr("Turned away from the light"),
        tr("Along the edge: reflected light, an ink line"), tr("The small bright spot of something shiny")};
    for (std::size_t i = 0; i < kSwatchRoles; ++i) {
        const auto role = static_cast<SwatchRole>(i);
        chips_[i] = textButton(roleName(role), tips[i]);
        chips_[i]->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        chips_[i]->setIconSize({kChip, kChip});
        showWhenChosen(chips_[i]);
        group->addButton(chips_[i], static_cast<int>(i));
        line->addWidget(chips_[i]);
    }
    auto* none = textButton(tr("Remove"), tr("Takes the chosen colour away (Delete)"));
    line->addWidget(none);
    line->addStretch(1);
    connect(none, &QToolButton::clicked, this, &ArtworkToolOptions::removeWanted);
    connect(group, &QButtonGroup::idClicked, this, [this](int id) {
        ToolOptions changed = options_;
        changed.role = static_cast<SwatchRole>(id);
        change(changed);
    });
    return page;
}

void ArtworkToolOptions::change(const ToolOptions& options) {
    if (options == options_)
        return;
    setOptions(options);
    Q_EMIT optionsChanged(options);
}

void ArtworkToolOptions::setTool(ToolKind kind) {
    kind_ = kind;
    int page = 0;
    switch (kind) {
    case ToolKind::circle:
    case ToolKind::ellipse: page = 0; break;
    case ToolKind::region: page = 1; break;
    case ToolKind::brush:
    case ToolKind::ignore: page = 2; break;
    case ToolKind::normal:
    case ToolKind::crease:
    case ToolKind::open: page = 3; break;
    case ToolKind::picker: page = 4; break;
    }
    letters_->setVisible(kind == ToolKind::ignore);
    pages_->setCurrentIndex(page);
}

void ArtworkToolOptions::setOptions(const ToolOptions& options) {
    options_ = options;
    const QSignalBlocker quiet(brush_);
    fromCentre_->setChecked(options.fromCentre);
    findEdge_->setChecked(options.findEdge);
    brush_->setValue(static_cast<int>(std::lround(options.brushRadius)));
    chips_[static_cast<std::size_t>(options.role)]->setChecked(true);
}

void ArtworkToolOptions::setDraft(const ExtractionDraft& draft) {
    draft_ = draft;
    snap_->setEnabled(draft.form == FormKind::ellipse && draft.ellipse);
    letters_->setEnabled(draft.plate != nullptr);
    showChips();
}

void ArtworkToolOptions::showChips() {
    for (std::size_t i = 0; i < kSwatchRoles; ++i)
        chips_[i]->setIcon(chipIcon(draft_.swatches.picked[i], palette(), devicePixelRatioF()));
}

} // namespace limner
