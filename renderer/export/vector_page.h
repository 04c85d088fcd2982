#pragma once

#include "renderer/annotations.h"
#include "renderer/marks/marks.h"
#include "renderer/marks/stroke_outline.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace limner {

struct PageHeader {
    glm::dvec2 paperMm{0};
    std::string title;
    std::string description;
    std::string name; ///< of the file, for messages
};

/// A page of a vector file that is written as it is drawn, in named layers one over the other. Lengths are mm from the
/// page's top left corner, y down. One thread at a time. The stream remembers failures.
class VectorPage {
  public:
    virtual ~VectorPage() = default;
    virtual void beginLayer(const std::string& name) = 0;
    virtual void endLayer() = 0;
    /// The whole page in one colour, sRGB.
    virtual void fill(const glm::dvec3& rgb) = 0;
    /// A picture over the whole page, top row first: RGBA, 8 bits, alpha not multiplied in.
    virtual void beginPicture(glm::ivec2 size, double dpi) = 0;
    virtual void pictureRows(std::span<const std::byte> rgba, int rows) = 0;
    virtual void endPicture() = 0;
    virtual void dot(const Dot& dot) = 0;
    /// A line of one width.
    virtual void line(std::span<const OutlinePoint> points, const Stroke& stroke) = 0;
    /// A line of changing width: its outline, filled.
    virtual void outline(std::span<const OutlinePoint> points, const Stroke& stroke) = 0;
    /// Letters that stay letters: they can be searched, copied and, in SVG, edited.
    virtual void text(const PaperText& text) = 0;
    virtual void bar(const PaperBar& bar) = 0;
    virtual void ball(const PaperBall& ball) = 0;
    /// Completes the file; nothing can be drawn after it.
    virtual void finish() = 0;
};

/// A style's ball as a vector file embeds it: RGBA, 8 bits, alpha not multiplied in, `kBallPixels` square.
constexpr int kBallPixels = 128;
std::vector<std::uint8_t> ballBytes(const LitSphere& sphere);

/// For drawing programs: Inkscape's layers, real circles and strokes.
std::unique_ptr<VectorPage> makeSvgPage(const PageHeader& header, std::FILE* stream);
/// For printing: layers that a reader can switch.
std::unique_ptr<VectorPage> makePdfPage(const PageHeader& header, std::FILE* stream);

} // namespace limner
