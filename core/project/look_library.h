#pragma once

#include "core/base/task.h"
#include "core/figure/figure.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace limner {

/// A look of the user's own (core/figure/look.h) as it stands in lists.
struct LookCard {
    std::string id; ///< its file is ID.limner
    std::string name;
    std::vector<std::byte> thumbnailPng; ///< of the scan it was made on; may be empty
};

/// The user's own looks on disk: a `.limner` file each, with its styles and a thumbnail, that can be given to others.
/// Nothing is held in memory. Any thread; writes are whole or not at all.
class LookLibrary {
  public:
    /// The folder is made on the first write.
    explicit LookLibrary(std::filesystem::path folder);
    /// LIMNER_LOOKS, else $XDG_DATA_HOME/limner/looks, else ~/.local/share/limner/looks.
    static std::filesystem::path standardFolder();

    struct Listing {
        std::vector<LookCard> cards;       ///< sorted by name
        std::vector<std::string> problems; ///< a line for each file that cannot be used
    };
    [[nodiscard]] Listing list() const;
    /// The look of a figure under a name, which gets a number where it is taken. Throws Error(noResources).
    LookCard add(const Figure& figure, const std::string& name, std::vector<std::byte> thumbnailPng, Task& task) const;
    /// Takes a look's file, or any project's look, into the library under its own title or file name. Throws Error.
    LookCard import(const std::filesystem::path& file, Task& task) const;
    /// With its styles. Throws Error(badInput), also where there is none of that id.
    [[nodiscard]] Figure load(const std::string& id, Task& task) const;
    void remove(const std::string& id) const;

  private:
    [[nodiscard]] std::filesystem::path fileOf(const std::string& id) const;
    [[nodiscard]] LookCard write(Figure look, const std::string& name, std::vector<std::byte> thumbnailPng,
                                 Task& task) const;

    std::filesystem::path folder_;
};

} // namespace limner
