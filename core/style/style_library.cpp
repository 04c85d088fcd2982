#include "core/style/style_library.h"

#include "core/base/error.h"
#include "core/base/user_folder.h"
#include "core/style/png_writing.h"
#include "core/style/slug.h"
#include "core/style/style_files.h"
#include "core/style/style_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFavourites = ".favourites.json"; // hidden: an id never begins with a dot
constexpr const char* kTextureEnding = "-texture";
constexpr std::uintmax_t kLargestFavourites = 1U << 20U; // thousands of ids

[[noreturn]] void refuse(const std::string& what, const fs::path& where, const std::string& why,
                         const std::string& remedy) {
    throw Error(ErrorKind::badInput, {what, where.string(), why, remedy});
}

bool endsWithTexture(const std::string& word) {
    return word.ends_with(kTextureEnding) && word.size() > std::string(kTextureEnding).size();
}

/// Whether files of that name lie in the folder itself and can be seen there.
bool isPlain(const std::string& id) {
    constexpr std::size_t kLongest = 200; // with an ending still legal everywhere
    const auto forbidden = [](unsigned char c) { return c < ' ' || c == '/' || c == 0x7F; };
    return !id.empty() && id.size() <= kLongest && id.front() != '.' && std::none_of(id.begin(), id.end(), forbidden);
}

/// Card of a style in the folder: its id is its file's name, whatever the card says.
StyleCard cardOf(const fs::path& picture) {
    StyleCard card = loadStyleCard(cardFileOf(picture));
    card.id = picture.stem().string();
    return card;
}

/// Ids and names that a new style may not have.
class Taken {
  public:
    explicit Taken(const StyleLibrary& library) : folder_(library.folder()) {
        const StyleLibrary::Listing listing = library.list();
        for (const StyleCard& card : listing.cards) {
            names_.insert(card.name);
        }
        try {
            for (const StyleCard& card : bundledStyleCards()) {
                ids_.insert(card.id);
                names_.insert(card.name);
            }
        } catch (const Error&) { // none come with this copy of Limner
        }
    }
    [[nodiscard]] bool id(const std::string& id) const { return ids_.contains(id) || isTaken(folder_, id); }
    [[nodiscard]] bool name(const std::string& name) const { return names_.contains(name); }

  private:
    fs::path folder_;
    std::set<std::string> ids_;
    std::set<std::string> names_;
};

std::string freshId(const Taken& taken, const std::string& word) {
    std::string slug = slugOf(word);
    if (endsWithTexture(slug)) { // would be taken for the texture of another style
        slug += "-style";
    }
    return numbered(slug, "-", [&](const std::string& id) { return taken.id(id); });
}

std::string freshName(const Taken& taken, const std::string& name) {
    return numbered(name, " ", [&](const std::string& word) { return taken.name(word); });
}

/// Nothing where the file cannot be read as what it should be.
std::optional<std::set<std::string>> readFavourites(const fs::path& file) {
    std::error_code missing;
    const auto size = fs::file_size(file, missing);
    if (missing) {
        return std::set<std::string>{};
    }
    std::ifstream stream(file, std::ios::binary);
    if (size > kLargestFavourites || !stream) {
        return std::nullopt;
    }
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    try {
        return nlohmann::json::parse(text).get<std::set<std::string>>();
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

void writeFavourites(const fs::path& file, const std::set<std::string>& ids) {
    writeWholeFile(file, nlohmann::json(ids).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
                             std::string("\n"));
}

/// Inside a change of the folder.
void markFavourite(const fs::path& folder, const std::string& id, bool favourite) {
    std::set<std::string> ids = readFavourites(folder / kFavourites).value_or(std::set<std::string>{});
    const bool changes = favourite ? ids.insert(id).second : ids.erase(id) > 0;
    if (changes) {
        writeFavourites(folder / kFavourites, ids);
    }
}

/// What one entry of the folder is: a card where it is a style's picture, a problem where it is none of a style's
/// files.
class Sorting {
  public:
    explicit Sorting(StyleLibrary::Listing& listing) : listing_(listing) {}

    void sort(const fs::path& file) {
        const std::string name = file.filename().string();
        if (name.front() == '.' || name == kRemovedStyles) {
            return;
        }
        std::error_code unknown;
        if (!fs::is_regular_file(file, unknown)) {
            problem(file, fs::is_directory(file, unknown) ? "it is a folder" : "it is not a readable file",
                    "styles are pictures in the folder itself");
        } else if (file.extension() == ".json") {
            if (!isThere(fs::path(file).replace_extension(".png"))) {
                problem(file, "its picture is missing", "put it back or remove the card");
            }
        } else if (file.extension() == ".png") {
            sortPicture(file);
        } else {
            problem(file, "it is no style", "bring pictures in by `limner style add`");
        }
    }

  private:
    void sortPicture(const fs::path& file) {
        const std::string stem = file.stem().string();
        const std::string owner = stem.substr(0, stem.size() - std::min(stem.size(), std::strlen(kTextureEnding)));
        if (endsWithTexture(stem) && isThere(file.parent_path() / (owner + ".png"))) {
            return; // that style's own
        }
        try {
            if (!isPlain(stem)) {
                refuse("cannot use the style", file, "its name is no id", "give it a shorter name");
            }
            checkStyleFiles(file);
            listing_.cards.push_back(cardOf(file));
        } catch (const Error& error) {
            listing_.problems.emplace_back(error.what());
        }
    }
    void problem(const fs::path& file, const std::string& why, const std::string& remedy) {
        listing_.problems.push_back(oneLine({"cannot use the file", file.string(), why, remedy}));
    }

    StyleLibrary::Listing& listing_;
};

fs::path existingPicture(const fs::path& folder, const std::string& id) {
    const fs::path picture = pictureOf(folder, id);
    if (!isPlain(id) || !isThere(picture)) {
        refuse("cannot find the style", isPlain(id) ? picture : folder,
               "there is no style \"" + id.substr(0, 60) + "\"", "`limner style list --mine` shows them");
    }
    return picture;
}

} // namespace

StyleLibrary::StyleLibrary(fs::path folder) : folder_(std::move(folder)) {}

fs::path StyleLibrary::userFolder() { return limner::userFolder("LIMNER_STYLES", "styles"); }

StyleLibrary::Listing StyleLibrary::list() const {
    Listing listing;
    std::error_code failure;
    std::vector<fs::path> files;
    for (fs::directory_iterator at(folder_, failure), end; !failure && at != end; at.increment(failure)) {
        files.push_back(at->path());
    }
    if (failure && failure != std::errc::no_such_file_or_directory) {
        listing.problems.push_back(
            oneLine({"cannot read the styles in", folder_.string(), failure.message(), "allow it to be read"}));
    }
    std::sort(files.begin(), files.end()); // problems in the same order every time
    Sorting sorting(listing);
    std::for_each(files.begin(), files.end(), [&](const fs::path& file) { sorting.sort(file); });
    if (!readFavourites(folder_ / kFavourites)) {
        listing.problems.push_back(oneLine({"cannot read the list of favourites", (folder_ / kFavourites).string(),
                                            "it is no JSON list", "mend it or remove it"}));
    }
    std::sort(listing.cards.begin(), listing.cards.end(),
              [](const StyleCard& a, const StyleCard& b) { return std::pair(a.name, a.id) < std::pair(b.name, b.id); });
    return listing;
}

Style StyleLibrary::load(const std::string& id) const {
    Style style = loadWholeStyle(existingPicture(folder_, id));
    style.card.id = id;
    return style;
}

StyleCard StyleLibrary::add(const Style& style) const {
    return changingStyles(folder_, [&] {
        const Taken taken(*this);
        Style fresh = style;
        std::string name = tidyName(style.card.name.empty() ? style.card.id : style.card.name);
        name = name.empty() ? "Style" : name;
        fresh.card.name = freshName(taken, name);
        fresh.card.id = freshId(taken, style.card.id.empty() ? name : style.card.id);
        markFavourite(folder_, fresh.card.id, false); // one that had this id may have been, before it was removed
        writeStyle(fresh, pictureOf(folder_, fresh.card.id));
        return fresh.card;
    });
}

void StyleLibrary::change(const StyleCard& card) const {
    const fs::path file = cardFileOf(existingPicture(folder_, card.id));
    changingStyles(folder_, [&] {
        std::ifstream stream(file, std::ios::binary);
        const std::string old((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
        StyleCard tidy = card;
        tidy.name = tidyName(card.name);
        writeWholeFile(file, cardText(tidy, old, file.string()));
    });
}

void StyleLibrary::remove(const std::string& id) const {
    const fs::path picture = existingPicture(folder_, id);
    changingStyles(folder_, [&] {
        const fs::path place = nextRemoval(folder_, id);
        std::error_code failure;
        fs::create_directories(place, failure);
        if (failure) {
            failStyleWriting(folder_, failure.message());
        }
        try {
            moveStyle(picture, pictureOf(place, id), PictureTurn::first);
        } catch (const Error&) {
            fs::remove(place, failure);
            throw;
        }
        forgetOldRemovals(folder_);
    });
}

StyleCard StyleLibrary::restore(const std::string& id) const {
    const auto newestOf = [&] {
        const std::vector<fs::path> removals = styleRemovals(folder_);
        const auto newest = std::find_if(removals.rbegin(), removals.rend(),
                                         [&](const fs::path& removal) { return idOfRemoval(removal) == id; });
        if (newest == removals.rend()) {
            refuse("cannot bring the style back", folder_, "no style \"" + id.substr(0, 60) + "\" was removed of late",
                   "the last twenty that were removed are kept");
        }
        return *newest;
    };
    newestOf(); // before the folder is made where there is none
    return changingStyles(folder_, [&] {
        const fs::path removal = newestOf();
        const fs::path picture =
            pictureOf(folder_, numbered(id, "-", [&](const std::string& word) { return isTaken(folder_, word); }));
        moveStyle(pictureOf(removal, id), picture, PictureTurn::last);
        std::error_code ignored;
        fs::remove(removal, ignored);
        return cardOf(picture);
    });
}

std::set<std::string> StyleLibrary::favourites() const {
    return readFavourites(folder_ / kFavourites).value_or(std::set<std::string>{});
}

void StyleLibrary::setFavourite(const std::string& id, bool favourite) const {
    if (favourites().contains(id) != favourite) {
        changingStyles(folder_, [&] { markFavourite(folder_, id, favourite); });
    }
}

} // namespace limner
