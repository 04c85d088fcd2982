// Textures laid on the object, apart from its lighting (the open problem of paper 000, section 6).
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace limner {
namespace {

using testing::BackendTest;
using testing::largestDifference;
using testing::planOf;
using testing::renderWhole;
using testing::sameBits;

/// Factors around 1 that repeat without a seam.
std::shared_ptr<const TextureTile> wavyTile(float swing) {
    constexpr int size = 32;
    std::vector<Rgba> pixels;
    for (int i = 0; i < size * size; ++i) {
        const double across = 2 * 3.14159265358979 * (i % size) / size;
        const double down = 2 * 3.14159265358979 * (i / size) / size;
        const auto wave = static_cast<float>(1 + swing * std::sin(across) * std::cos(2 * down));
        pixels.push_back({wave, wave * 0.9F, 1, 1});
    }
    return std::make_shared<const TextureTile>(size, std::move(pixels));
}

Figure texturedFigure(Projection projection, std::shared_ptr<const TextureTile> tile, double strength = 0.7) {
    testing::SmoothScene scene;
    scene.projection = projection;
    Figure figure = testing::smoothFigure(scene);
    figure.layers.front().shading = Shading::style;
    testing::makeLine(figure.layers.front(), "value");
    for (StyleEntry& style : figure.styles) {
        style.texture = StyleTexture{"", 9, strength, tile};
    }
    return figure;
}

class Texture : public BackendTest {
  protected:
    [[nodiscard]] Picture draw(const Figure& figure) const {
        PlanRequest request;
        request.size = {48, 48};
        return renderWhole(backend(), *planOf(figure, request));
    }
};
LIMNER_ON_EVERY_BACKEND(Texture);

TEST_P(Texture, OfStrengthZeroIsAbsent) {
    Figure figure = texturedFigure(Projection::orthographic, wavyTile(0.5F), 0);
    const Picture clear = draw(figure);
    for (StyleEntry& style : figure.styles) {
        style.texture.reset();
    }
    EXPECT_TRUE(sameBits(clear, draw(figure)));
    PlanRequest request;
    request.size = {8, 8};
    EXPECT_TRUE(planOf(figure, request)->layers.front().textures.empty());
}

TEST_P(Texture, OfMidGreyChangesNothing) {
    const auto grey = std::make_shared<const TextureTile>(16, std::vector<Rgba>(16 * 16, Rgba{1, 1, 1, 1}));
    Figure figure = texturedFigure(Projection::perspective, grey, 1);
    const Picture laid = draw(figure);
    for (StyleEntry& style : figure.styles) {
        style.texture.reset();
    }
    EXPECT_LT(largestDifference(laid, draw(figure)), rounding(1e-12, 1e-6));
}

/// How far a picture's red is from that of the same figure without its texture, on average where there is matter.
double seen(const Picture& textured, const Picture& plain) {
    double sum = 0;
    for (std::size_t i = 0; i < plain.rgba().size(); i += 4) {
        sum += std::abs(static_cast<double>(textured.rgba()[i]) - static_cast<double>(plain.rgba()[i]));
    }
    return sum / (static_cast<double>(plain.rgba().size()) / 4);
}

TEST_P(Texture, IsSeenAndGrowsWithItsStrength) {
    Figure figure = texturedFigure(Projection::orthographic, wavyTile(0.5F), 0);
    const Picture plain = draw(figure);
    double last = 1e-4; // far above rounding
    for (const double strength : {0.25, 0.5, 1.0}) {
        const double now = seen(draw(texturedFigure(Projection::orthographic, wavyTile(0.5F), strength)), plain);
        EXPECT_GT(now, 1.5 * last);
        last = now;
    }
}

TEST(TextureAgreement, CpuDrawsWhatTheReferenceDraws) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        PlanRequest request;
        request.size = {48, 48};
        const auto plan = planOf(texturedFigure(projection, wavyTile(0.4F)), request);
        const Picture exact = renderWhole(*makeReferenceBackend(), *plan);
        const Picture fast = renderWhole(*makeCpuBackend(), *plan);
        // As styles alone: the tables and the atlas are what differs, the texture adds float rounding.
        EXPECT_LT(testing::rootMeanSquare(exact, fast), 2e-3);
    }
}

TEST(TextureAgreement, StaysOnTheObjectWhenTheCameraTurns) {
    // A plain grey sphere as style has no lighting: a face of a box shows the tile itself, from any side. Seen along z
    // and along -z the same place of the volume lies mirrored in the picture.
    Figure figure = texturedFigure(Projection::orthographic, wavyTile(0.5F), 1);
    const auto grey = std::make_shared<const LitSphere>(16, std::vector<Rgba>(16 * 16, Rgba{0.5F, 0.5F, 0.5F, 1}));
    for (StyleEntry& style : figure.styles) {
        style.sphere = grey;
    }
    const Grid& grid = figure.volume->data->grid();
    const glm::dvec3 middle = grid.mmFromVoxel(glm::dvec3(grid.dims - 1) / 2.0);
    PlanRequest request;
    request.size = {3, 3};
    const auto red = [&](const glm::dvec3& direction) {
        figure.camera.targetMm = middle;
        figure.camera.direction = direction;
        figure.camera.up = {0.3, 1, 0.2};
        figure.camera.heightMm = 1e-3; // all nine rays hit one place
        figure.quality.earlyTermination = 0;
        const Picture picture = renderWhole(*makeReferenceBackend(), *planOf(figure, request));
        const float* p = picture.pixel(1, 1);
        return p[3] > 0 ? p[0] / p[3] : 0.0F;
    };
    // The line through the middle is the same matter from both ends; without lighting only the order of composition
    // differs, and the texture's swing is far larger than that where it would swim.
    figure.layers.front().transfer.opacity = {{-1e9, 0.001}, {1e9, 0.001}};
    EXPECT_NEAR(red({0.4, 0.5, 0.77}), red({-0.4, -0.5, -0.77}), 2e-3);
    EXPECT_GT(std::abs(red({0.4, 0.5, 0.77}) - red({0.77, -0.5, 0.4})), 5e-3);
}

} // namespace
} // namespace limner
