#include "widgets/ramp_editor.h"

#include "widgets/colour_button.h"
#include "widgets/form_parts.h"

#include <glm/common.hpp>

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {
namespace {

constexpr std::size_t kMostKeys = 256; // that a ramp may have
constexpr double kBrightest = 16;      // factor that a tint may have

double largest(const glm::dvec4& rgba) { return std::max({rgba.r, rgba.g, rgba.b}); }

/// The colour that a key shows at full strength, and the factor that makes the key of it.
glm::dvec3 shownColour(const glm::dvec4& rgba) { return glm::dvec3(rgba) / std::max(1.0, largest(rgba)); }

void setBrightness(glm::dvec4& rgba, double brightness) {
    const double now = largest(rgba);
    const glm::dvec3 rgb = now > 0 ? glm::dvec3(rgba) * (brightness / now) : glm::dvec3(brightness);
    rgba = glm::dvec4(glm::min(rgb, glm::dvec3(kBrightest)), rgba.a);
}

} // namespace

RampEditor::RampEditor(Kind kind, QWidget* parent)
    : QWidget(parent), canvas_(new RampCanvas), colour_(new ColourButton(tr("Colour of the key"))),
      place_(new QDoubleSpinBox), opacity_(new QDoubleSpinBox), brightness_(new QDoubleSpinBox),
      add_(textButton(tr("Add"), tr("Add a key half way to the next one"))),
      step_(textButton(tr("Step"), tr("Let the ramp jump at the selected key instead of running towards it"))),
      remove_(textButton(tr("Remove"), tr("Remove the selected key (Delete)"))), presets_(new QMenu(this)) {
    buildFields();
    layOut(kind);
    connectParts();
    showSelection();
}

void RampEditor::buildFields() {
    constexpr double kPercent = 100;
    colour_->setToolTip(tr("Colour of the selected key"));
    place_->setRange(0, 1);
    place_->setDecimals(3);
    place_->setSingleStep(0.01);
    place_->setAccessibleName(tr("Place of the key"));
    place_->setToolTip(tr("Where the selected key lies on the ramp, from 0 to 1"));
    opacity_->setRange(0, kPercent * kBrightest);
    opacity_->setAccessibleName(tr("Opacity at the key"));
    opacity_->setToolTip(tr("Factor of the layer's opacity at the selected key, in percent"));
    brightness_->setRange(0, kPercent * kBrightest);
    brightness_->setAccessibleName(tr("Brightness at the key"));
    brightness_->setToolTip(tr("Strongest factor of the layer's colours at the selected key; above 100 % brightens"));
    for (QDoubleSpinBox* box : {opacity_, brightness_}) {
        box->setDecimals(0);
        box->setSingleStep(5);
        box->setSuffix(tr(" %"));
    }
    for (QDoubleSpinBox* box : {place_, opacity_, brightness_}) {
        box->setKeyboardTracking(false);
        leaveWheelToPanel(box);
    }
    presets_->setToolTipsVisible(true);
}

void RampEditor::layOut(Kind kind) {
    auto* presets = textButton(tr("Preset  "), tr("Take a ready-made ramp"));
    presets->setMenu(presets_);
    presets->setPopupMode(QToolButton::InstantPopup);
    auto* fields = new QGridLayout;
    fields->setHorizontalSpacing(6);
    fields->setVerticalSpacing(1);
    auto add = [&, column = 0](QWidget* field, const QString& name) mutable {
        auto* label = new QLabel(name);
        label->setBuddy(field);
        label->setToolTip(field->toolTip());
        label->setForegroundRole(QPalette::PlaceholderText);
        fields->addWidget(label, 0, column);
        fields->addWidget(field, 1, column);
        fields->setColumnStretch(column++, field == colour_ ? 0 : 1);
    };
    add(colour_, tr("Colour"));
    add(place_, tr("Place"));
    if (kind == Kind::tints) {
        add(brightness_, tr("Brightness"));
        add(opacity_, tr("Opacity"));
    } else {
        brightness_->setParent(this);
        opacity_->setParent(this);
        brightness_->hide();
        opacity_->hide();
    }
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    for (QToolButton* button : {add_, step_, remove_})
        buttons->addWidget(button);
    buttons->addStretch(1);
    buttons->addWidget(presets);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(canvas_);
    column->addLayout(fields);
    column->addLayout(buttons);
}

void RampEditor::connectParts() {
    connect(canvas_, &RampCanvas::changed, this, &RampEditor::changed);
    connect(canvas_, &RampCanvas::selectionChanged, this, &RampEditor::showSelection);
    connect(canvas_, &RampCanvas::colourWanted, colour_, &ColourButton::ask);
    connect(colour_, &ColourButton::chosen, this, [this](const glm::dvec3& rgb) {
        editSelected(tr("Change colour of key"), "", [&](RampKey& key) {
            const double strength = std::max(1.0, largest(key.rgba)); // a key that brightens goes on brightening
            key.rgba = glm::dvec4(rgb * strength, key.rgba.a);
        });
    });
    connect(place_, &QDoubleSpinBox::valueChanged, this, [this](double at) {
        Q_EMIT changed(withKeyMoved(canvas_->keys(), canvas_->selected(), at), tr("Move key"),
                       gesture_.again("ramp/place"), false);
    });
    connect(opacity_, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
        editSelected(tr("Change opacity of key"), "ramp/opacity", [&](RampKey& key) { key.rgba.a = percent / 100; });
    });
    connect(brightness_, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
        editSelected(tr("Change brightness of key"), "ramp/brightness",
                     [&](RampKey& key) { setBrightness(key.rgba, percent / 100); });
    });
    connect(add_, &QToolButton::clicked, this, [this] {
        const RampKeys& keys = canvas_->keys();
        const std::size_t key = canvas_->selected();
        const double here = key < keys.size() ? keys[key].at : 0;
        const double next = key + 1 < keys.size() ? keys[key + 1].at : key > 0 ? keys[key - 1].at : 1;
        canvas_->addKeyAt((here + next) / 2);
    });
    connect(step_, &QToolButton::clicked, this, [this] {
        const std::size_t key = canvas_->selected();
        const std::size_t before = canvas_->keys().size();
        Q_EMIT changed(withKeyStep(canvas_->keys(), key), tr("Make step"), {}, false);
        if (canvas_->keys().size() > before)
            canvas_->select(key + 1); // the same key, behind its new edge
    });
    connect(remove_, &QToolButton::clicked, canvas_, &RampCanvas::removeSelected);
}

void RampEditor::addPreset(const QString& name, const QString& help, const std::function<void()>& use) {
    QAction* action = presets_->addAction(name, this, use);
    action->setToolTip(help);
    action->setStatusTip(help);
}

void RampEditor::setKeys(const RampKeys& keys) {
    canvas_->setKeys(keys);
    showSelection();
}

void RampEditor::showSelection() {
    const QSignalBlocker quiet[] = {QSignalBlocker(place_), QSignalBlocker(opacity_), QSignalBlocker(brightness_)};
    const RampKeys& keys = canvas_->keys();
    const std::size_t selected = canvas_->selected();
    const bool any = selected < keys.size();
    for (QWidget* field : std::initializer_list<QWidget*>{colour_, place_, opacity_, brightness_})
        field->setEnabled(any);
    const RampKey key = any ? keys[selected] : RampKey{};
    colour_->setColour(shownColour(key.rgba));
    place_->setValue(key.at);
    opacity_->setValue(key.rgba.a * 100);
    brightness_->setValue(largest(key.rgba) * 100);
    const bool full = keys.size() >= kMostKeys;
    add_->setEnabled(!full);
    step_->setEnabled(any && selected > 0 && !full);
    remove_->setEnabled(any && keys.size() > 1);
}

void RampEditor::editSelected(const QString& what, const char* key, const std::function<void(RampKey&)>& change) {
    RampKeys keys = canvas_->keys();
    if (canvas_->selected() >= keys.size())
        return;
    change(keys[canvas_->selected()]);
    Q_EMIT changed(keys, what, *key ? gesture_.again(key) : std::string(), false);
}

} // namespace limner
