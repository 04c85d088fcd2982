#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limner {

/// A glyph's outline in ems, y up: closed contours of lines and curves.
struct GlyphOutline {
    enum class Step : std::uint8_t { move, line, conic, cubic }; ///< of 1, 1, 2 and 3 points
    std::vector<Step> steps;
    std::vector<glm::dvec2> points;
};

/// A glyph of shaped text, in ems from the text's beginning on the baseline, y up.
struct ShapedGlyph {
    std::uint32_t id = 0;
    glm::dvec2 place{0};
    double advance = 0;
    std::size_t cluster = 0; ///< the byte of the text that it begins to show
};

struct FaceMetrics {
    double capHeight = 0.7; ///< all in ems
    double xHeight = 0.5;
    double ascent = 0.9;
    double descent = 0.25; ///< positive
    glm::dvec2 lowest{0};  ///< the box of all glyphs
    glm::dvec2 highest{1};
};

/// One face of a font file. Thread-safe: what is computed is kept behind a lock.
class FontFace {
  public:
    struct Source {
        std::string file;
        int index = 0;
        std::string family;
        bool bold = false;
        bool slanted = false; ///< upright letters stand in for italic ones: they are sheared
    };

    /// Throws Error(badInput) where the file is no font with outlines.
    explicit FontFace(const Source& source);
    ~FontFace();
    FontFace(const FontFace&) = delete;
    FontFace& operator=(const FontFace&) = delete;

    [[nodiscard]] const Source& source() const { return source_; }
    [[nodiscard]] const FaceMetrics& metrics() const { return metrics_; }
    /// For PDF: letters, digits and hyphens only.
    [[nodiscard]] const std::string& postScriptName() const { return name_; }
    /// Whether outlines are TrueType's quadratic ones.
    [[nodiscard]] bool trueType() const { return trueType_; }
    [[nodiscard]] bool has(char32_t letter) const;
    [[nodiscard]] std::vector<ShapedGlyph> shape(std::string_view text) const;
    /// Advance of a glyph alone, in ems.
    [[nodiscard]] double advance(std::uint32_t glyph) const;
    /// Stays valid as long as the face.
    [[nodiscard]] const GlyphOutline& outline(std::uint32_t glyph) const;
    /// The face as a font file that holds these glyphs only, under their old numbers. Empty where that fails.
    [[nodiscard]] std::string subset(std::span<const std::uint32_t> glyphs) const;

    /// How far a sheared letter leans: x per y.
    static constexpr double kShear = 0.2;

  private:
    struct Libraries;
    Source source_;
    FaceMetrics metrics_;
    std::string name_;
    bool trueType_ = true;
    std::unique_ptr<Libraries> libraries_;
};

} // namespace limner
