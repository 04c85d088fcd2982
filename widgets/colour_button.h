#pragma once

#include <glm/vec3.hpp>

#include <QColor>
#include <QToolButton>

namespace limner {

/// sRGB 0..1, and back; what lies outside is held at the ends.
QColor colourOf(const glm::dvec3& rgb);
glm::dvec3 rgbOf(const QColor& colour);

/// A swatch; a click asks for another colour.
class ColourButton : public QToolButton {
    Q_OBJECT

  public:
    /// `what`: the dialog's title and the accessible name.
    explicit ColourButton(const QString& what, QWidget* parent = nullptr);

    /// Shows a colour without a signal.
    void setColour(const glm::dvec3& rgb);
    [[nodiscard]] const glm::dvec3& colour() const { return rgb_; }
    void ask();
    /// As if the user had chosen it.
    void choose(const QColor& colour);

  Q_SIGNALS:
    void chosen(const glm::dvec3& rgb);

  private:
    glm::dvec3 rgb_{0};
};

} // namespace limner
