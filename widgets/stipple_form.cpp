#include "widgets/stipple_form.h"

#include "core/figure/stipple_presets.h"
#include "widgets/core_words.h"
#include "widgets/stipple_parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {

/// The stipples as one part of the figure, with the parts that they have themselves among its rows.
class StipplePart : public PartFormOf<Stipple> {
    Q_DECLARE_TR_FUNCTIONS(limner::StipplePart)

  public:
    StipplePart();
    [[nodiscard]] const std::vector<PartForm*>& parts() const { return parts_; }

    ColourButton* ink = nullptr;
    QCheckBox* fromStyle = nullptr;
    QSpinBox* seed = nullptr;
    QMenu* presets = nullptr;

  private:
    void addPresets();
    void addInk();
    void addTone();
    void addLines();
    void addPlace();
    void addFinePoints();
    void addSeed();
    void addHeading(const QString& text);
    void addParts(const std::vector<PartForm*>& parts);

    std::vector<PartForm*> parts_;
};

namespace {

PartFormOf<Stipple>::Access stipples() {
    return {[](const Figure& figure, std::size_t) { return figure.stipple; },
            [](Figure& figure, std::size_t, std::optional<Stipple> stipple) { figure.stipple = std::move(stipple); },
            [](const Figure&) { return stipplePresets().front().part; }};
}

bool hasFactor(const Stipple& s) {
    return s.boundary || s.silhouette || s.resolution || s.distance || s.interior || s.lighting;
}

} // namespace

StipplePart::StipplePart() : PartFormOf<Stipple>("/stipple", stipples()) {
    rows()->setContentsMargins(0, 4, 0, 0); // the whole panel is this part: nothing to stand under
    addPresets();
    addInk();
    addTone();
    addLines();
    addPlace();
    addFinePoints();
}

void StipplePart::addPresets() {
    presets = new QMenu(this);
    presets->setToolTipsVisible(true);
    for (const PartPreset<Stipple>& preset : stipplePresets()) {
        const QString name = coreWord(preset.name);
        QAction* action = presets->addAction(name);
        action->setObjectName("stipple." + QString::fromStdString(preset.id));
        action->setToolTip(coreWord(preset.help));
        connect(action, &QAction::triggered, this, [this, name, &preset] {
            submit(tr("Stipple “%1”").arg(name), {}, false,
                   [&](Figure& changed) { changed.stipple = stippleInLook(changed.stipple, preset.part); });
        });
    }
    QToolButton* button =
        textButton(tr("Preset  "), tr("Take a ready-made look; ink, dot size and how the dots stand to the layers "
                                      "stay"));
    button->setMenu(presets);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setFocusPolicy(Qt::StrongFocus);
    addBeside(button);
}

void StipplePart::addInk() {
    ink = addColour("/stipple/ink_rgb", [](Stipple& s) -> glm::dvec3& { return s.inkRgb; });
    fromStyle = new QCheckBox(labelOfSetting("/stipple/from_style"));
    fromStyle->setToolTip(helpOfSetting("/stipple/from_style"));
    rows()->addRow(QString(), fromStyle);
    onShow([this](const Stipple& s) { fromStyle->setChecked(s.fromStyle); });
    connect(fromStyle, &QCheckBox::clicked, this, [this](bool on) {
        change(on ? tr("Take ink from style") : tr("Use one ink"), {}, false, [=](Stipple& s) { s.fromStyle = on; });
    });
    addNumber("/stipple/size_mm", {0, 2, 2, 2}, [](Stipple& s) -> double& { return s.sizeMm; });
    addNumber("/stipple/k_max", {0, 8, 2, 2}, [](Stipple& s) -> double& { return s.kMax; });
}

void StipplePart::addTone() {
    addHeading(tr("What the tone follows"));
    auto* dark = new QLabel(tr("Nothing yet: all surfaces are as dark as dots can make them."));
    dark->setWordWrap(true);
    rows()->addRow(dark);
    onShow([this, dark](const Stipple& s) { rows()->setRowVisible(dark, !hasFactor(s)); });
    addParts(stippleFactorForms());
}

void StipplePart::addLines() {
    addHeading(tr("Lines and strokes"));
    addParts(stippleLineForms());
}

void StipplePart::addPlace() {
    addHeading(tr("Dots and layers"));
    addChoice("/stipple/layer_opacity",
              {{"under", tr("Dots under the layers")},
               {"over", tr("Dots over the layers")},
               {"alone", tr("Dots alone: no layers")}},
              [](Stipple& s) -> std::string& { return s.layerOpacity; });
    addChoice("/stipple/matter", {{"data", tr("The data as they are")}, {"layers", tr("What the layers show")}},
              [](Stipple& s) -> std::string& { return s.matter; });
    addChoice("/stipple/hidden", {{"remove", tr("Removed")}, {"show", tr("Shown")}},
              [](Stipple& s) -> std::string& { return s.hidden; });
}

void StipplePart::addFinePoints() {
    addHeading(tr("Fine points"));
    addChoice("/stipple/placing", {{"paper", tr("Evenly on paper")}, {"volume", tr("Evenly on the volume")}},
              [](Stipple& s) -> std::string& { return s.placing; });
    addChoice("/stipple/tone", {{"ink", tr("Share of inked paper")}, {"count", tr("Share of the most dots")}},
              [](Stipple& s) -> std::string& { return s.tone; });
    addChoice("/stipple/gradient", {{"neumann", tr("Regression (Neumann)")}, {"central", tr("Central differences")}},
              [](Stipple& s) -> std::string& { return s.gradient; });
    addNumber("/stipple/threshold", {0, 1, 3, 2}, [](Stipple& s) -> double& { return s.threshold; });
    addNumber("/stipple/spread_voxels", {0, 4, 2, 2}, [](Stipple& s) -> double& { return s.spreadVoxels; });
    addSeed();
}

void StipplePart::addSeed() {
    constexpr int kMost = 1000000000; // that a figure may have
    seed = new QSpinBox;
    seed->setRange(0, kMost);
    seed->setKeyboardTracking(false);
    seed->setAccessibleName(labelOfSetting("/stipple/seed"));
    seed->setToolTip(helpOfSetting("/stipple/seed"));
    leaveWheelToPanel(seed);
    addLabelled(rows(), labelOfSetting("/stipple/seed"), seed);
    onShow([this](const Stipple& s) {
        const QSignalBlocker quiet(seed);
        seed->setValue(s.seed);
    });
    connect(seed, &QSpinBox::valueChanged, this,
            [this](int value) { change(tr("Change seed"), "seed", false, [=](Stipple& s) { s.seed = value; }); });
}

void StipplePart::addHeading(const QString& text) {
    QLabel* label = heading(text);
    label->setContentsMargins(0, 8, 0, 0);
    rows()->addRow(label);
}

void StipplePart::addParts(const std::vector<PartForm*>& parts) {
    for (PartForm* part : parts) {
        parts_.push_back(part);
        rows()->addRow(part);
    }
}

StippleForm::StippleForm(QWidget* parent)
    : QWidget(parent), whole_(new StipplePart),
      none_(new QLabel(tr("The figure has no marks of ink. Switch them on, or take a ready-made look, to draw with "
                          "dots, lines and strokes."))) {
    none_->setWordWrap(true);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(whole_);
    column->addWidget(none_);
    column->addStretch(1);
    QScrollArea* scroll = scrolling(content);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    scrollToOpened(scroll);
    connect(whole_, &PartForm::edited, this, &StippleForm::edited);
    for (PartForm* part : whole_->parts())
        connect(part, &PartForm::edited, this, &StippleForm::edited);
    setFigure(nullptr);
}

void StippleForm::setFigure(const std::shared_ptr<const Figure>& figure) {
    whole_->setFigure(figure, 0);
    for (PartForm* part : whole_->parts())
        part->setFigure(figure, 0);
    none_->setVisible(figure && !figure->stipple);
}

QCheckBox* StippleForm::inked() const { return whole_->present(); }
QMenu* StippleForm::presets() const { return whole_->presets; }
ColourButton* StippleForm::ink() const { return whole_->ink; }
QCheckBox* StippleForm::fromStyle() const { return whole_->fromStyle; }
QSpinBox* StippleForm::seed() const { return whole_->seed; }

PartForm* StippleForm::part(std::string_view pointer) const {
    const auto found =
        std::ranges::find(whole_->parts(), pointer, [](const PartForm* p) -> std::string_view { return p->pointer(); });
    return found == whole_->parts().end() ? nullptr : *found;
}

ParameterRow* StippleForm::row(std::string_view pointer) const {
    ParameterRow* row = whole_->row(pointer);
    for (const PartForm* part : whole_->parts())
        row = row ? row : part->row(pointer);
    return row;
}

QComboBox* StippleForm::choice(std::string_view pointer) const {
    QComboBox* box = whole_->choice(pointer);
    for (const PartForm* part : whole_->parts())
        box = box ? box : part->choice(pointer);
    return box;
}

} // namespace limner
