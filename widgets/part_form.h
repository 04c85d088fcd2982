#pragma once

#include "core/figure/layer_edits.h"
#include "core/project/history.h"
#include "widgets/colour_button.h"
#include "widgets/core_words.h"
#include "widgets/form_parts.h"
#include "widgets/light_form.h"
#include "widgets/parameter_row.h"

#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QScrollArea;

namespace limner {

/// A part of the figure, or of one of its layers, that may be absent: a check box that adds and removes it, and its
/// rows, which show only while it is there. Leaves a part of a locked layer as it is.
class PartForm : public QWidget {
    Q_OBJECT

  public:
    /// `pointer`: of the part in the parameter table, "/layers/*/tone" or "/depth_cues/halo".
    explicit PartForm(std::string pointer, QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer);
    [[nodiscard]] const std::string& pointer() const { return pointer_; }
    [[nodiscard]] QCheckBox* present() const { return present_; }
    /// Null for a pointer that has no row.
    [[nodiscard]] ParameterRow* row(std::string_view pointer) const;
    [[nodiscard]] QComboBox* choice(std::string_view pointer) const;
    /// A widget at the end of the check box's line; there whether the part is or not.
    void addBeside(QWidget* widget);
    /// Whether the part is there.
    [[nodiscard]] bool on() const;

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    /// The user has switched the part on: its rows are there now.
    void opened();

  protected:
    [[nodiscard]] virtual bool has(const Figure& figure, std::size_t layer) const = 0;
    virtual void put(Figure& figure, std::size_t layer, bool on) = 0;
    virtual void showPart() = 0;
    /// Another layer or another scan: what was remembered is forgotten.
    virtual void forget() = 0;

    [[nodiscard]] const Figure* figure() const { return figure_.get(); }
    [[nodiscard]] std::size_t layer() const { return layer_; }
    [[nodiscard]] QFormLayout* rows() const { return form_; }
    ParameterRow* addRow(const std::string& pointer, const ParameterRow::Useful& useful, const QString& label);
    ColourButton* addColourRow(const std::string& pointer);
    LightForm* addLightRow(const std::string& pointer);
    QComboBox* addChoiceRow(const std::string& pointer, const ChoiceWords& words);
    void onChosen(QComboBox* box, const std::function<void()>& then);
    [[nodiscard]] bool mayEdit() const;
    /// Emits the edit, unless the layer is locked. `key` is made this layer's own.
    void submit(const QString& label, const std::string& key, bool ongoing, const std::function<void(Figure&)>& change);

  private:
    void setPresent(bool on);

    std::string pointer_;
    QCheckBox* present_;
    QHBoxLayout* head_;
    QWidget* body_;
    QFormLayout* form_;
    std::vector<ParameterRow*> numbers_;
    std::vector<std::pair<std::string, QComboBox*>> choices_;
    std::shared_ptr<const Figure> figure_;
    std::size_t layer_ = 0;
};

/// The same for a part of a known type.
template <class Part>
class PartFormOf : public PartForm {
  public:
    struct Access {
        std::optional<Part> (*get)(const Figure& figure, std::size_t layer);
        void (*set)(Figure& figure, std::size_t layer, std::optional<Part> part);
        Part (*first)(const Figure& figure); ///< what the part is when it is switched on
    };
    using Change = std::function<void(Part&)>;

    PartFormOf(std::string pointer, const Access& access) : PartForm(std::move(pointer)), access_(access) {}

    /// A row for a number of the part, under its name in the parameter table or another.
    void addNumber(const std::string& pointer, const ParameterRow::Useful& useful, double& (*of)(Part&),
                   const QString& label = {}) {
        ParameterRow* row = addRow(pointer, useful, label);
        onShow([=](Part part) { row->setValue(of(part)); });
        const QString what = PartForm::tr("Change %1").arg(inSentence(label.isEmpty() ? row->label() : label));
        connect(row, &ParameterRow::changed, this, [=, this](double value, const std::string& key, bool ongoing) {
            change(what, key, ongoing, [=](Part& part) { of(part) = value; });
        });
    }
    ColourButton* addColour(const std::string& pointer, glm::dvec3& (*of)(Part&)) {
        ColourButton* button = addColourRow(pointer);
        onShow([=](Part part) { button->setColour(of(part)); });
        connect(button, &ColourButton::chosen, this, [=, this](const glm::dvec3& rgb) {
            change(PartForm::tr("Change colour"), {}, false, [=](Part& part) { of(part) = rgb; });
        });
        return button;
    }
    LightForm* addLight(const std::string& pointer, Light& (*of)(Part&)) {
        LightForm* light = addLightRow(pointer);
        onShow([=, this](Part part) { light->setLight(of(part), figure()->camera); });
        connect(light, &LightForm::changed, this, [=, this](const Light& to, const std::string& key, bool ongoing) {
            change(PartForm::tr("Move light"), key, ongoing, [=](Part& part) { of(part) = to; });
        });
        return light;
    }
    QComboBox* addChoice(const std::string& pointer, const ChoiceWords& words, std::string& (*of)(Part&)) {
        QComboBox* box = addChoiceRow(pointer, words);
        onShow([=](Part part) { choose(box, of(part)); });
        onChosen(box, [=, this] {
            change(PartForm::tr("Change %1").arg(inSentence(labelOfSetting(pointer))), {}, false,
                   [=](Part& part) { of(part) = chosenWord(box); });
        });
        return box;
    }

    /// Called whenever the part is to be shown.
    void onShow(std::function<void(const Part&)> show) { shows_.push_back(std::move(show)); }
    /// Emits the edit that changes the part.
    void change(const QString& label, const std::string& key, bool ongoing, const Change& by) {
        if (!on())
            return;
        submit(label, key, ongoing, [&](Figure& changed) {
            std::optional<Part> part = access_.get(changed, layer());
            by(*part);
            access_.set(changed, layer(), std::move(part));
        });
    }
    using PartForm::figure;
    using PartForm::layer;
    using PartForm::rows;

  protected:
    bool has(const Figure& figure, std::size_t layer) const override { return access_.get(figure, layer).has_value(); }
    void put(Figure& figure, std::size_t layer, bool on) override {
        if (!on)
            last_ = access_.get(figure, layer);
        access_.set(figure, layer, on ? std::optional(last_ ? *last_ : access_.first(figure)) : std::nullopt);
    }
    void showPart() override {
        const std::optional<Part> part = access_.get(*figure(), layer());
        for (const auto& show : shows_)
            show(*part);
    }
    void forget() override { last_.reset(); }

  private:
    Access access_;
    std::vector<std::function<void(const Part&)>> shows_;
    std::optional<Part> last_; ///< comes back when the check box is set again
};

/// How a form reaches a part of a layer: `layerPart<&Layer::tone>(first)`.
template <auto Member,
          class Part = typename std::remove_reference_t<decltype(std::declval<Layer>().*Member)>::value_type>
typename PartFormOf<Part>::Access layerPart(Part (*first)(const Figure&) = [](const Figure&) { return Part{}; }) {
    return {[](const Figure& figure, std::size_t layer) {
                return layer < figure.layers.size() ? figure.layers[layer].*Member : std::optional<Part>();
            },
            [](Figure& figure, std::size_t layer, std::optional<Part> part) {
                figure.layers[layer].*Member = std::move(part);
            },
            first};
}

/// Scrolls to a part of the area's content once the user has switched it on.
void scrollToOpened(QScrollArea* area);

} // namespace limner
