#include "core/style/style_files.h"

#include "core/base/error.h"
#include "core/base/pending_file.h"
#include "core/style/png_writing.h"
#include "core/style/square_picture.h"
#include "core/style/texture_tile.h"

#include <nlohmann/json.hpp>

#include <deque>
#include <fstream>
#include <iterator>
#include <new>
#include <optional>
#include <vector>

namespace limner {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

/// A card is a few hundred bytes; a file past this is something else.
constexpr std::uintmax_t kLargestCard = 1U << 20U;

[[noreturn]] void refuseCard(const std::string& where, const std::string& why, const std::string& remedy) {
    throw Error(ErrorKind::badInput, {"cannot read the style's card", where, why, remedy});
}

/// Nothing where there is no such file.
std::optional<std::string> textOfCard(const fs::path& file) {
    std::error_code unknown;
    const auto size = fs::file_size(file, unknown);
    if (unknown) {
        return std::nullopt;
    }
    if (size > kLargestCard) {
        refuseCard(file.string(), "a style's card is a small JSON file", "remove it or write a new one");
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (!stream) {
        refuseCard(file.string(), "it cannot be opened", "allow it to be read");
    }
    return text;
}

Json parsedCard(const std::string& text, const std::string& where) {
    constexpr const char* kRemedy = "mend the card or remove it";
    try {
        Json json = Json::parse(text);
        if (!json.is_object()) {
            refuseCard(where, "it is no JSON object", kRemedy);
        }
        return json;
    } catch (const Json::exception& problem) {
        refuseCard(where, problem.what(), kRemedy);
    }
}

/// Another JSON file of the same name, a figure's say, is never replaced by a card.
void checkReplaceable(const fs::path& card) {
    const std::optional<std::string> text = textOfCard(card);
    if (!text) {
        return;
    }
    const Json json = Json::parse(*text, nullptr, false);
    if (!json.is_object() || !json.contains("name") || json.contains("limner")) {
        throw Error(ErrorKind::badInput, {"cannot write the style's card", card.string(),
                                          "another JSON file has that name", "give the style another name"});
    }
}

/// Files that come into being together: all are on disk before the first gets its name.
class FileSet {
  public:
    void add(const fs::path& file, const std::string& bytes) {
        std::error_code ignored;
        const bool isNew = !fs::exists(file, ignored);
        Part& part = parts_.emplace_back(file, isNew);
        std::fwrite(bytes.data(), 1, bytes.size(), part.pending.stream());
        std::fflush(part.pending.stream());
        part.pending.check();
    }
    void commit() {
        std::size_t done = 0;
        try {
            for (; done < parts_.size(); ++done) {
                parts_[done].pending.commit();
            }
        } catch (const Error&) {
            for (std::size_t i = 0; i < done; ++i) {
                if (parts_[i].isNew) {
                    std::error_code ignored;
                    fs::remove(parts_[i].file, ignored);
                }
            }
            throw;
        }
    }

  private:
    struct Part {
        Part(const fs::path& path, bool absent) : file(path), isNew(absent), pending(path) {}
        fs::path file;
        bool isNew;
        PendingFile pending;
    };
    std::deque<Part> parts_; // pending files cannot move
};

} // namespace

fs::path cardFileOf(const fs::path& picture) { return fs::path(picture).replace_extension(".json"); }

fs::path textureFileOf(const fs::path& picture) {
    return picture.parent_path() / (picture.stem().string() + "-texture.png");
}

StyleCard loadStyleCard(const fs::path& file) {
    StyleCard card;
    card.id = file.stem().string();
    card.name = card.id;
    const std::optional<std::string> text = textOfCard(file);
    if (!text) {
        return card;
    }
    const Json json = parsedCard(*text, file.string());
    try {
        card.id = json.value("id", card.id);
        card.name = json.value("name", card.id);
        card.tags = json.value("tags", card.tags);
        card.origin = json.value("origin", card.origin);
        card.credit = json.value("credit", card.credit);
        card.licence = json.value("licence", card.licence);
    } catch (const Json::exception& problem) {
        refuseCard(file.string(), problem.what(), "mend the card or remove it");
    }
    return card;
}

Style loadStyle(const fs::path& picture) {
    StyleCard card = loadStyleCard(cardFileOf(picture));
    SquarePicture square = readSquarePicture(picture, kSphereRules);
    std::error_code unknown;
    const fs::path whole = fs::absolute(picture, unknown);
    try {
        return {std::move(card), std::make_shared<const LitSphere>(square.size, std::move(square.pixels)),
                unknown ? picture.string() : whole.lexically_normal().string()};
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources,
                    {kSphereRules.what, picture.string(), "out of memory", "use a smaller picture"});
    }
}

Style loadWholeStyle(const fs::path& picture) {
    Style style = loadStyle(picture);
    const fs::path texture = textureFileOf(picture);
    std::error_code ignored;
    if (fs::exists(texture, ignored)) {
        style.texture = loadTextureTile(texture);
    }
    return style;
}

void checkStyleFiles(const fs::path& picture) {
    checkSquarePicture(picture, kSphereRules);
    loadStyleCard(cardFileOf(picture));
    const fs::path texture = textureFileOf(picture);
    std::error_code ignored;
    if (fs::exists(texture, ignored)) {
        checkSquarePicture(texture, kTileRules);
    }
}

std::string cardText(const StyleCard& card, const std::string& old, const std::string& where) {
    Json json = old.empty() ? Json::object() : parsedCard(old, where);
    json["id"] = card.id;
    json["name"] = card.name.empty() ? card.id : card.name;
    json["tags"] = card.tags;
    json["origin"] = card.origin;
    json["credit"] = card.credit;
    json["licence"] = card.licence;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void writeStyle(const Style& style, const fs::path& picture) {
    checkReplaceable(cardFileOf(picture));
    FileSet files;
    if (style.texture != nullptr) {
        files.add(textureFileOf(picture), pngBytes(*style.texture));
    }
    files.add(cardFileOf(picture), cardText(style.card));
    files.add(picture, pngBytes(*style.sphere));
    files.commit();
}

} // namespace limner
