#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace limner {

class TextureTile;

/// An RGBA value, sRGB-encoded, not premultiplied, 0..1.
struct Rgba {
    float r = 0;
    float g = 0;
    float b = 0;
    float a = 1;
    friend bool operator==(const Rgba&, const Rgba&) = default;
};

/// A lit-sphere style: the picture of a shaded ball, looked up by the eye-space normal (paper 000 section 4; spec
/// style-transfer-functions.md 1). Only the inscribed disk means anything; outside it the rim is continued outward, so
/// that filtering never reads a foreign texel. `uv = 1/2 + 1/2 (n_x, n_y)` with n_y = +1 in the top row.
/// Alpha is the directional opacity. Averages are taken over the encoded values, weighted with the share of a texel
/// that the disk covers and, for the colour, with alpha. Immutable, thread-safe.
class LitSphere {
  public:
    /// `pixels`: size*size, row-major, top row first. The rim is continued outward here: texels that the disk does not
    /// cover wholly (below size 8: whose centre lies outside) take the value of the next inner one along the radius.
    LitSphere(int size, std::vector<Rgba> pixels);

    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] std::span<const Rgba> pixels() const { return pixels_; }
    /// Bilinear lookup at full resolution; (x, y) is the normal's eye-space part, clamped to the unit disk.
    [[nodiscard]] Rgba at(double x, double y) const;
    /// Mean over the disk: what a sample without a normal takes.
    [[nodiscard]] const Rgba& mean() const { return mean_; }
    /// Whether any texel of the disk has alpha < 1, so that a renderer can leave the alpha channel out.
    [[nodiscard]] bool hasDirectionalOpacity() const { return directionalOpacity_; }
    /// The next coarser picture, filtered inside the disk only; null at size 1.
    [[nodiscard]] std::shared_ptr<const LitSphere> half() const;

  private:
    /// Finds the mean and whether all is opaque; with `filtered` texels the rim is in order already.
    struct Filtered {};
    LitSphere(Filtered, int size, std::vector<Rgba> pixels);
    void summarise();

    int size_;
    std::vector<Rgba> pixels_;
    Rgba mean_;
    bool directionalOpacity_ = false;
};

/// Where a style comes from: what the gallery shows and a project keeps.
struct StyleCard {
    std::string id;   ///< unique, lower case with hyphens: "ivory-bone"
    std::string name; ///< for people: "Ivory bone"
    std::vector<std::string> tags;
    std::string origin;
    std::string credit;
    std::string licence;
};

struct Style {
    StyleCard card;
    std::shared_ptr<const LitSphere> sphere;
    std::string file = {};                           ///< the picture: "bundled:ID" or a path; empty: not on disk
    std::shared_ptr<const TextureTile> texture = {}; ///< null: none
};

/// Reads a style picture (any format OpenImageIO reads; grey or colour, with or without alpha, linear pictures are
/// sRGB-encoded; must be square, at least 4 pixels and at most 8192) and the JSON card beside it (same name, .json),
/// where there is one; without one the card has the file's name only. Throws Error(badInput).
Style loadStyle(const std::filesystem::path& picture);

/// The JSON card alone; where the file is absent, a card with the file's name only. Throws Error(badInput).
StyleCard loadStyleCard(const std::filesystem::path& card);

/// Cards of all bundled styles, sorted by name; reads no picture. The folder is `resourcesFolder()/styles`; throws
/// Error(badInput) where there is none.
const std::vector<StyleCard>& bundledStyleCards();

/// All bundled styles in the order of their cards, read in parallel on the first call (a fraction of a second): lists
/// want `bundledStyleCards`. Thread-safe, as is `findBundledStyle`.
const std::vector<Style>& bundledStyles();

/// The bundled style of that id, its picture read on first use; null where there is none of that id.
const Style* findBundledStyle(const std::string& id);

} // namespace limner
