#pragma once

#include "core/style/lit_sphere.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace limner {

/// The user's own styles on disk: `ID.png` (RGBA, 16 bits) with `ID.json`, and `ID-texture.png` where there is one.
/// Every write is whole or not at all. Nothing is held in memory: several programs may use one folder. Any thread.
class StyleLibrary {
  public:
    /// The folder is made on the first write.
    explicit StyleLibrary(std::filesystem::path folder);
    /// LIMNER_STYLES, else $XDG_DATA_HOME/limner/styles, else ~/.local/share/limner/styles.
    static std::filesystem::path userFolder();

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    struct Listing {
        std::vector<StyleCard> cards;      ///< sorted by name
        std::vector<std::string> problems; ///< a line for each file that cannot be used; the others are listed
    };
    [[nodiscard]] Listing list() const;
    /// With picture and texture; `Style::file` is the picture's path. Throws Error(badInput), also where there is none.
    [[nodiscard]] Style load(const std::string& id) const;
    /// Writes a style; id (of the name where the card has none) and name get a number where they are taken (here, or by
    /// a bundled style). Gives the card as written. Throws Error(noResources) for a folder that cannot be written.
    StyleCard add(const Style& style) const;
    /// Name, tags, origin, credit, licence of the style with that id; what else its card says stays. Throws as `add`,
    /// and Error(badInput) for a card that cannot be read.
    void change(const StyleCard& card) const;

    /// Puts the files aside, in the folder's `removed`; the last twenty are kept there.
    void remove(const std::string& id) const;
    /// Brings back what `remove` put aside last under that id; where another style has it by now, with a number. Gives
    /// the card. Throws Error(badInput) where nothing of that id is kept.
    StyleCard restore(const std::string& id) const;

    /// Ids of favourites, bundled ones as "bundled:ID".
    [[nodiscard]] std::set<std::string> favourites() const;
    void setFavourite(const std::string& id, bool favourite) const;

  private:
    std::filesystem::path folder_;
};

} // namespace limner
