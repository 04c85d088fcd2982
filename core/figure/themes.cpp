#include "core/figure/themes.h"

#include "core/base/error.h"
#include "core/base/resources.h"
#include "core/figure/layer_edits.h"
#include "core/style/lit_sphere.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAnyRole = "any";

struct Theme {
    ThemeCard card;
    int rank = 0; ///< order in lists
    glm::dvec3 paper{1};
    std::optional<Contours> contours;
    std::map<std::string, std::string> styles; ///< role -> id of a bundled style
};

[[noreturn]] void badTheme(const fs::path& path, const std::string& why) {
    throw Error(ErrorKind::badInput, {"cannot read the theme", path.string(), why, "install Limner anew"});
}

Theme loadTheme(const fs::path& path) {
    std::ifstream file(path);
    try {
        const auto json = nlohmann::json::parse(file);
        Theme theme;
        theme.card = {path.stem().string(), json.at("name"), json.at("help")};
        theme.rank = json.at("rank");
        const auto paper = json.at("paper").get<std::array<double, 3>>();
        theme.paper = {paper[0], paper[1], paper[2]};
        if (const auto& contours = json.at("contours"); !contours.is_null()) { // every theme says whether it has them
            theme.contours.emplace().thicknessMm = contours.at("thickness_mm");
        }
        theme.styles = json.at("styles").get<std::map<std::string, std::string>>();
        return theme;
    } catch (const nlohmann::json::exception& e) {
        badTheme(path, e.what());
    }
}

std::vector<Theme> loadThemes() {
    const fs::path folder = resourcesFolder() / "themes";
    std::vector<Theme> themes;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(folder, missing)) {
        if (entry.path().extension() == ".json") {
            themes.push_back(loadTheme(entry.path()));
        }
    }
    if (themes.empty()) {
        badTheme(folder, missing ? missing.message() : "no theme in this folder");
    }
    std::sort(themes.begin(), themes.end(), [](const Theme& a, const Theme& b) {
        return std::pair(a.rank, a.card.id) < std::pair(b.rank, b.card.id);
    });
    return themes;
}

const std::vector<Theme>& allThemes() {
    static const std::vector<Theme> themes = loadThemes();
    return themes;
}

const Theme& findTheme(const std::string& id) {
    std::string known;
    for (const Theme& theme : allThemes()) {
        if (theme.card.id == id) {
            return theme;
        }
        known += (known.empty() ? "known are: " : ", ") + theme.card.id;
    }
    throw Error(ErrorKind::usage, {"there is no such theme", id, "", known});
}

/// Null where the theme has nothing for the role, or names a style that is not there.
const Style* styleFor(const Theme& theme, const std::string& role) {
    auto found = theme.styles.find(role);
    if (found == theme.styles.end()) {
        found = theme.styles.find(kAnyRole);
    }
    return found == theme.styles.end() ? nullptr : findBundledStyle(found->second);
}

bool drawsARole(const Figure& figure, const Layer& layer) {
    const auto hasRole = [&](const std::string& id) {
        const StyleEntry* entry = figure.findStyle(id);
        return entry != nullptr && !entry->role.empty();
    };
    if (layer.shading != Shading::style) {
        return false;
    }
    if (layer.transfer.kind == TransferKind::oneDimensional) {
        return std::any_of(layer.transfer.nodes.begin(), layer.transfer.nodes.end(),
                           [&](const TransferNode& node) { return !node.rgb && hasRole(node.style); });
    }
    const auto rows = layer.transfer.grid.value_or(TransferGrid{}).styles;
    return std::any_of(rows.begin(), rows.end(),
                       [&](const auto& row) { return std::any_of(row.begin(), row.end(), hasRole); });
}

bool drawsWith(const Layer& layer, const std::string& style) { return stylesOf(layer).contains(style); }

/// Styles that locked layers draw with, apart from those of the others: where a layer that is not locked, or the
/// figure's cut faces, share such a style, they get a copy of it.
std::set<std::string> setLockedStylesApart(Figure& figure) {
    std::set<std::string> kept;
    for (const Layer& layer : figure.layers) {
        if (layer.locked) {
            kept.merge(stylesOf(layer));
        }
    }
    for (const std::string& id : kept) {
        const StyleEntry* entry = figure.findStyle(id);
        const bool facesShare = figure.clip.face && figure.clip.face->style == id;
        const bool shared = facesShare || std::any_of(figure.layers.begin(), figure.layers.end(),
                                                      [&](const Layer& l) { return !l.locked && drawsWith(l, id); });
        if (entry == nullptr || entry->role.empty() || !shared) {
            continue;
        }
        StyleEntry copy = *entry;
        for (int n = 2; figure.findStyle(copy.id) != nullptr; ++n) {
            copy.id = id + "-" + std::to_string(n);
        }
        for (Layer& layer : figure.layers) {
            if (!layer.locked) {
                exchangeStyle(layer, id, copy.id);
            }
        }
        if (facesShare) {
            figure.clip.face->style = copy.id;
        }
        figure.styles.push_back(copy);
    }
    return kept;
}

} // namespace

const std::vector<ThemeCard>& bundledThemes() {
    static const std::vector<ThemeCard> cards = [] {
        std::vector<ThemeCard> list;
        for (const Theme& theme : allThemes()) {
            list.push_back(theme.card);
        }
        return list;
    }();
    return cards;
}

Figure withTheme(const Figure& figure, const std::string& theme, std::vector<std::string>& notes) {
    const Theme& chosen = findTheme(theme);
    Figure changed = figure;
    const std::set<std::string> locked = setLockedStylesApart(changed);
    for (StyleEntry& entry : changed.styles) {
        if (locked.contains(entry.id)) {
            continue;
        }
        if (entry.role.empty()) {
            notes.push_back("The style \"" + entry.id + "\" has no role: the theme leaves it as it is.");
            continue;
        }
        const Style* style = styleFor(chosen, entry.role);
        if (style == nullptr) {
            notes.push_back("The theme has no style for the role \"" + entry.role + "\": \"" + entry.id +
                            "\" stays as it is.");
            continue;
        }
        entry.file = "bundled:" + style->card.id;
        entry.name = style->card.name;
        entry.credit = style->card.credit;
        entry.licence = style->card.licence;
        entry.sphere = style->sphere;
    }
    for (Layer& layer : changed.layers) {
        if (layer.locked) {
            notes.push_back("The layer \"" + layer.name + "\" is locked: the theme leaves it as it is.");
        } else if (drawsARole(changed, layer)) {
            layer.contours = chosen.contours;
        }
    }
    changed.background.rgba = {chosen.paper, 1};
    if (changed.background.kind == "image") {
        notes.push_back("The picture in the background stays; the theme's paper shows where there is none.");
    }
    return changed;
}

} // namespace limner
