#pragma once

#include "widgets/artwork_tool.h"

#include <optional>

namespace limner {

/// Picks the colours of which a sphere is made: a click takes the chosen one and goes to the next.
class PickerTool : public ArtworkTool {
    Q_DECLARE_TR_FUNCTIONS(limner::PickerTool)

  public:
    using ArtworkTool::ArtworkTool;

    void press(const ToolPointer& pointer) override;
    void drag(const ToolPointer& pointer) override;
    void release(const ToolPointer& pointer) override;
    void hover(const ToolPointer& pointer) override;
    bool nudge(glm::dvec2 by) override;
    void remove() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QString hint() const override;

  private:
    [[nodiscard]] std::optional<Rgba> colourUnder(glm::dvec2 place) const;
    void pick(glm::dvec2 place, bool ongoing);

    bool picking_ = false;
    std::optional<ToolPointer> over_;
};

/// "Light", "Mid", ...
QString roleName(SwatchRole role);

} // namespace limner
