#include "core/base/error.h"
#include "core/style/lit_sphere.h"
#include "core/style/square_picture.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>

namespace limner {
namespace {

namespace fs = std::filesystem;

/// Below 4 there is no disk to speak of; above 8192 a style holds nothing a figure could show.
constexpr PictureRules kSpheres{"cannot read the style",
                                {4, 8192},
                                "crop it to the square around the ball",
                                "bring it to a width from 4 to 8192, 512 is plenty",
                                "use a PNG, TIFF, JPEG or EXR picture of a shaded ball"};
/// A card is a few hundred bytes; a file past this is something else.
constexpr std::uintmax_t kLargestCard = 1U << 20U;

[[noreturn]] void fail(const fs::path& file, const std::string& why, const std::string& remedy) {
    throw Error(ErrorKind::badInput, {kSpheres.what, file.string(), why, remedy});
}

} // namespace

StyleCard loadStyleCard(const fs::path& file) {
    StyleCard card;
    card.id = file.stem().string();
    card.name = card.id;
    std::error_code unknown;
    const auto size = fs::file_size(file, unknown);
    if (unknown) {
        return card;
    }
    if (size > kLargestCard) {
        fail(file, "a style's card is a small JSON file", "remove it or write a new one");
    }
    std::ifstream stream(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    try {
        const auto json = nlohmann::json::parse(text);
        card.id = json.value("id", card.id);
        card.name = json.value("name", card.id);
        card.tags = json.value("tags", card.tags);
        card.origin = json.value("origin", card.origin);
        card.credit = json.value("credit", card.credit);
        card.licence = json.value("licence", card.licence);
    } catch (const nlohmann::json::exception& problem) {
        fail(file, problem.what(), "mend the card or remove it");
    }
    return card;
}

Style loadStyle(const fs::path& picture) {
    fs::path card = picture;
    card.replace_extension(".json");
    StyleCard read = loadStyleCard(card);
    SquarePicture square = readSquarePicture(picture, kSpheres);
    try {
        return {std::move(read), std::make_shared<const LitSphere>(square.size, std::move(square.pixels))};
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources,
                    {"cannot read the style", picture.string(), "out of memory", "use a smaller picture"});
    }
}

} // namespace limner
