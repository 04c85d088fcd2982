#include "core/figure/style_edits.h"

#include "core/figure/layer_edits.h"
#include "core/style/find_style.h"
#include "core/style/slug.h"
#include "core/style/style_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <span>

namespace limner {
namespace {

namespace fs = std::filesystem;

bool isBundled(const std::string& file) { return file.starts_with("bundled:"); }

bool isAbsolute(const std::string& file) { return fs::path(file).is_absolute(); }

/// To a step of 16 bits, which is what the files hold.
bool samePixels(std::span<const Rgba> a, std::span<const Rgba> b) {
    constexpr float kStep = 1.0F / 65535;
    const auto near = [](float x, float y) { return std::abs(x - y) <= kStep; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Rgba& x, const Rgba& y) {
        return near(x.r, y.r) && near(x.g, y.g) && near(x.b, y.b) && near(x.a, y.a);
    });
}

/// A texture that only one of them has may have been laid on or taken off in the figure.
bool looksAs(const StyleEntry& entry, const Style& style) {
    if (entry.sphere == nullptr || style.sphere == nullptr) {
        return false;
    }
    const bool sphere = entry.sphere == style.sphere || samePixels(entry.sphere->pixels(), style.sphere->pixels());
    const TextureTile* tile = entry.texture ? entry.texture->tile.get() : nullptr;
    const bool texture = tile == nullptr || style.texture == nullptr || tile == style.texture.get() ||
                         samePixels(tile->pixels(), style.texture->pixels());
    return sphere && texture;
}

/// The entry that stands for the style already; the one of its own id before others.
StyleEntry* entryOf(Figure& figure, const Style& style) {
    StyleEntry* found = nullptr;
    for (StyleEntry& entry : figure.styles) {
        const bool same =
            isBundled(style.file) ? entry.file == style.file : !isBundled(entry.file) && looksAs(entry, style);
        if (same && (found == nullptr || entry.id == style.card.id)) {
            found = &entry;
        }
    }
    return found;
}

StyleEntry entryFor(const Style& style) {
    StyleEntry entry{style.card.id, style.file, style.card.name, style.card.credit, style.card.licence, style.sphere};
    if (style.texture != nullptr) {
        StyleTexture& texture = entry.texture.emplace();
        texture.file = isAbsolute(style.file) ? textureFileOf(style.file).string() : "";
        texture.tile = style.texture;
    }
    return entry;
}

void exchangeEverywhere(Figure& figure, const std::string& from, const std::string& to) {
    for (Layer& layer : figure.layers) {
        exchangeStyle(layer, from, to);
    }
    if (figure.clip.face && figure.clip.face->style == from) {
        figure.clip.face->style = to;
    }
}

std::set<std::string> usedStyles(const Figure& figure) {
    std::set<std::string> used;
    for (const Layer& layer : figure.layers) {
        used.merge(stylesOf(layer));
    }
    if (figure.clip.face) {
        used.insert(figure.clip.face->style);
    }
    used.erase("");
    return used;
}

} // namespace

std::string joinStyle(Figure& figure, const Style& style) {
    if (StyleEntry* entry = entryOf(figure, style)) {
        if (isAbsolute(style.file) && entry->file == style.file) { // what is said of it may have changed since
            entry->name = style.card.name;
            entry->credit = style.card.credit;
            entry->licence = style.card.licence;
        }
        return entry->id;
    }
    StyleEntry entry = entryFor(style);
    const std::string id = style.card.id.empty() ? slugOf(style.card.name) : style.card.id;
    entry.id = numbered(id, "-", [&](const std::string& word) { return figure.findStyle(word) != nullptr; });
    figure.styles.push_back(std::move(entry));
    return figure.styles.back().id;
}

std::vector<Style> projectStyles(const Figure& figure) {
    std::vector<Style> styles;
    for (const StyleEntry& entry : figure.styles) {
        if (isBundled(entry.file) || entry.sphere == nullptr) {
            continue;
        }
        Style& style = styles.emplace_back();
        style.card.id = entry.id;
        style.card.name = entry.name.empty() ? entry.id : entry.name;
        style.card.credit = entry.credit;
        style.card.licence = entry.licence;
        style.sphere = entry.sphere;
        style.file = entry.file;
        style.texture = entry.texture ? entry.texture->tile : nullptr;
    }
    return styles;
}

void dropUnusedStyles(Figure& figure) {
    const std::set<std::string> used = usedStyles(figure);
    std::erase_if(figure.styles, [&](const StyleEntry& entry) {
        return (isBundled(entry.file) || isAbsolute(entry.file)) && !used.contains(entry.id);
    });
}

void joinNamedStyles(Figure& figure, const StyleLibrary& mine) {
    for (const std::string& word : usedStyles(figure)) {
        const bool isColour = word.starts_with('#'); // in grids
        if (isColour || figure.findStyle(word) != nullptr) {
            continue;
        }
        if (const std::optional<Style> style = findStyle(word, mine)) {
            exchangeEverywhere(figure, word, joinStyle(figure, *style));
        }
    }
}

} // namespace limner
