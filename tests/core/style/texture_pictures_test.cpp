// The bundled texture tiles: the pictures in the folder, read apart from the program, and that the program finds them.
#include "core/base/resources.h"
#include "core/style/texture_tile.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace limner {
namespace {

namespace fs = std::filesystem;

/// Grey values, top row first.
struct Tile {
    int width = 0;
    int height = 0;
    std::vector<float> grey;
    [[nodiscard]] float at(int x, int y) const { return grey[static_cast<std::size_t>(y * width + x)]; }
};

std::vector<fs::path> cards() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(resourcesFolder() / "textures")) {
        if (entry.path().extension() == ".json") {
            found.push_back(entry.path());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

Tile readTile(fs::path path) {
    const auto input = OIIO::ImageInput::open(path.replace_extension(".png").string());
    if (input == nullptr) {
        ADD_FAILURE() << path << ": " << OIIO::geterror();
        return {};
    }
    EXPECT_EQ(input->spec().format, OIIO::TypeDesc::UINT16) << path;
    Tile tile{input->spec().width, input->spec().height, {}};
    tile.grey.resize(static_cast<std::size_t>(tile.width * tile.height));
    EXPECT_TRUE(input->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, tile.grey.data()));
    return tile;
}

Tile cropped(const Tile& tile, int edge) {
    Tile part{edge, edge, {}};
    for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
            part.grey.push_back(tile.at(x, y));
        }
    }
    return part;
}

/// Mean difference across the tile's joint over that between neighbours inside; the worse of both directions.
double seam(const Tile& tile) {
    double worst = 0;
    for (const bool across : {true, false}) {
        double joint = 0;
        double inside = 0;
        const int lines = across ? tile.height : tile.width;
        const int length = across ? tile.width : tile.height;
        for (int line = 0; line < lines; ++line) {
            const auto value = [&](int i) { return across ? tile.at(i, line) : tile.at(line, i); };
            joint += std::abs(value(length - 1) - value(0));
            for (int i = 1; i < length; ++i) {
                inside += std::abs(value(i) - value(i - 1)) / (length - 1);
            }
        }
        worst = std::max(worst, joint / inside);
    }
    return worst;
}

TEST(TexturePictures, RepeatWithoutASeamAndLeaveAColourAsItIsOnAverage) {
    ASSERT_GE(cards().size(), 8U);
    for (const fs::path& card : cards()) {
        const Tile tile = readTile(card);
        ASSERT_EQ(tile.width, 256) << card;
        ASSERT_EQ(tile.height, 256) << card;
        // The joint is one row of 256: it may be somewhat above the mean, a cut is far above.
        EXPECT_LT(seam(tile), 1.5) << card;
        EXPECT_GT(seam(cropped(tile, 200)), 1.5) << card << ": the measure misses a cut";
        double sum = 0;
        for (const float grey : tile.grey) {
            sum += grey;
        }
        EXPECT_NEAR(sum / static_cast<double>(tile.grey.size()), 0.5, 0.03) << card;
        const auto [low, high] = std::minmax_element(tile.grey.begin(), tile.grey.end());
        EXPECT_GT(*high - *low, 0.2F) << card << " shows nothing";
    }
}

TEST(TexturePictures, CardsSayWhatTheyAreAndWhoseTheyAre) {
    for (const fs::path& path : cards()) {
        std::ifstream file(path);
        const auto card = nlohmann::json::parse(file);
        EXPECT_EQ(card.at("id"), path.stem().string());
        for (const char* key : {"name", "origin", "credit", "licence"}) {
            EXPECT_FALSE(card.at(key).get<std::string>().empty()) << path << " " << key;
        }
        EXPECT_FALSE(card.at("tags").empty()) << path;
        EXPECT_GT(card.at("size_mm"), 0) << path;
    }
}

TEST(TexturePictures, AreFoundByTheirIds) {
    const std::vector<std::string> ids{"canvas", "hatching",   "laid-paper", "leather", "marble",
                                       "paper",  "skin-pores", "spongiosa",  "stipple", "wood"};
    EXPECT_EQ(cards().size(), ids.size());
    for (const std::string& id : ids) {
        const auto found = findBundledTexture(id);
        ASSERT_NE(found, nullptr) << id;
        const Tile tile = readTile(resourcesFolder() / "textures" / (id + ".json"));
        ASSERT_EQ(found->pixels().size(), tile.grey.size()) << id;
        for (std::size_t i = 0; i < tile.grey.size(); ++i) {
            ASSERT_NEAR(found->pixels()[i].r, 2 * tile.grey[i], 1e-6) << id << " " << i;
        }
    }
    EXPECT_EQ(findBundledTexture("none"), nullptr);
}

} // namespace
} // namespace limner
