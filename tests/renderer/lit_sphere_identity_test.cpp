#include "renderer/accuracy/analytic_scenes.h"
#include "support/rendering.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <vector>

// An opaque ball drawn with a style gives the style back (accuracy.md 1.5, A4), and what follows from it.

namespace limner {
namespace {

using testing::BackendTest;
using testing::renderWhole;

class LitSphereIdentity : public BackendTest {};
LIMNER_ON_EVERY_BACKEND(LitSphereIdentity);

/// The same picture with every texel opaque: what an opaque ball can show of a style.
std::shared_ptr<const LitSphere> opaqueCopy(const LitSphere& sphere) {
    std::vector<Rgba> pixels(sphere.pixels().begin(), sphere.pixels().end());
    for (Rgba& pixel : pixels) {
        pixel.a = 1;
    }
    return std::make_shared<const LitSphere>(sphere.size(), std::move(pixels));
}

/// A style whose colour is its normal: r = (1 + n_x) / 2, g = (1 + n_y) / 2.
std::shared_ptr<const LitSphere> normalSphere() {
    constexpr int size = 512;
    std::vector<Rgba> pixels;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            pixels.push_back({(column + 0.5F) / size, 1 - (row + 0.5F) / size, 0.25F, 1});
        }
    }
    return std::make_shared<const LitSphere>(size, std::move(pixels));
}

/// RMSE between the ball's picture and the style's own, inside 0.98 of the radius.
double identityError(const Backend& backend, const std::shared_ptr<const LitSphere>& style, int pixels) {
    const auto scene = accuracy::LitBall().scene(style, pixels);
    const Picture picture = renderWhole(backend, scene);
    const double radius = accuracy::LitBall().radiusVoxels;
    double sum = 0;
    int count = 0;
    for (int y = 0; y < pixels; ++y) {
        for (int x = 0; x < pixels; ++x) {
            const glm::dvec2 n = accuracy::pixelCentreMm(scene, {x, y}) / radius;
            if (glm::length(n) > 0.98) {
                continue;
            }
            const Rgba expected = style->at(n.x, -n.y); // rows go down, n_y goes up
            const float* pixel = picture.pixel(x, y);
            for (const double difference : {pixel[0] - expected.r, pixel[1] - expected.g, pixel[2] - expected.b}) {
                sum += difference * difference;
                ++count;
            }
            EXPECT_EQ(pixel[3], 1);
        }
    }
    return std::sqrt(sum / count);
}

TEST_P(LitSphereIdentity, HoldsForEveryBundledStyle) {
    ASSERT_GE(bundledStyles().size(), 20U);
    for (const Style& style : bundledStyles()) {
        const double error = identityError(backend(), opaqueCopy(*style.sphere), isReference() ? 40 : 256);
        EXPECT_LT(error, 0.01) << style.card.id;
        RecordProperty(style.card.id, std::to_string(error));
    }
}

TEST_P(LitSphereIdentity, HoldsForTheNormalItself) {
    // Half a step of depth turns the normal by 1/2000; packing to 11 bits adds a quarter of a thousandth.
    EXPECT_LT(identityError(backend(), normalSphere(), 96), rounding(5e-4, 8e-4));
}

TEST_P(LitSphereIdentity, HoldsFromEveryStandardView) {
    // Light and style turn with the viewer, so a ball looks the same from everywhere.
    auto scene = accuracy::LitBall().scene(normalSphere(), 48);
    const Picture first = renderWhole(backend(), scene);
    for (const glm::dvec3 direction :
         {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(1, 2, -3)}) {
        scene.figure.camera.direction = direction;
        scene.figure.camera.up = {0.1, -1, 0.2};
        const Picture turned = renderWhole(backend(), scene);
        double sum = 0;
        int count = 0;
        for (int i = 0; i < 48 * 48; ++i) {
            const glm::dvec2 at = accuracy::pixelCentreMm(scene, {i % 48, i / 48}) / accuracy::LitBall().radiusVoxels;
            if (glm::length(at) < 0.95) { // nearer to the rim the hit's place along the ray moves fast
                for (int c = 0; c < 2; ++c) {
                    sum += std::pow(first.pixel(i % 48, i / 48)[c] - turned.pixel(i % 48, i / 48)[c], 2);
                    ++count;
                }
            }
        }
        EXPECT_LT(std::sqrt(sum / count), 2e-3);
    }
}

TEST_P(LitSphereIdentity, HoldsInPerspectiveInTheFrameOfTheRay) {
    // In perspective a ball's outline is where the rays touch it: the style's rim must reach it all around. A point
    // whose normal makes the angle a with the ray back to the eye reads the style at sin(a) from its middle.
    auto scene = accuracy::LitBall().scene(normalSphere(), 96);
    scene.figure.camera.projection = Projection::perspective;
    scene.figure.camera.fovDeg = 60;
    scene.figure.camera.heightMm = 120;
    const Picture picture = renderWhole(backend(), scene);
    const double radius = accuracy::LitBall().radiusVoxels;
    const double eye = 60 / std::tan(glm::radians(30.0));
    int count = 0;
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) {
            const glm::dvec2 at = accuracy::pixelCentreMm(scene, {x, y});
            const double offAxis = std::atan(glm::length(at) / eye);
            const double sine = eye * std::sin(offAxis) / radius; // of the angle of incidence
            if (sine > 0.97) {
                continue;
            }
            const glm::dvec2 n = glm::normalize(at) * sine;
            EXPECT_NEAR(picture.pixel(x, y)[0], (1 + n.x) / 2, 3e-3) << x << ' ' << y;
            EXPECT_NEAR(picture.pixel(x, y)[1], (1 - n.y) / 2, 3e-3) << x << ' ' << y;
            ++count;
        }
    }
    EXPECT_GT(count, 1000);
}

/// A slab of tilted planes: the field rises along `normal`, the slab is `thickness` deep along the view.
accuracy::AnalyticScene tiltedSlab(const glm::dvec3& normal, std::shared_ptr<const LitSphere> style) {
    const auto volume = accuracy::sampleField(accuracy::centredGrid(24, 1),
                                              [&](const glm::dvec3& mm) { return 100 - glm::dot(normal, mm); });
    accuracy::AnalyticScene scene{"slab", accuracy::plainFigure(volume, accuracy::viewAlongZ(glm::dvec3(0), 1)), {}};
    scene.request.size = {1, 1};
    scene.request.lattice = SampleLattice{0.5, 0.5, 0};
    scene.figure.clip.planes = {{{0, 0, 1}, 1}, {{0, 0, -1}, 1}}; // two reference lengths
    StyleEntry entry;
    entry.id = "style";
    entry.sphere = std::move(style);
    scene.figure.styles = {entry};
    Layer& layer = scene.figure.layers.front();
    layer.shading = Shading::style;
    layer.transfer.nodes = {{100, "style", std::nullopt}};
    layer.transfer.opacity = {{100, 0.4}};
    return scene;
}

TEST_P(LitSphereIdentity, DirectionalOpacityMultipliesTheCurve) {
    // alpha of the style = (1 + n_x) / 2; of two reference lengths: 1 - (1 - a_d a_u)^2.
    constexpr int size = 256;
    std::vector<Rgba> pixels;
    for (int i = 0; i < size * size; ++i) {
        pixels.push_back({0.5F, 0.75F, 1, (i % size + 0.5F) / size});
    }
    const auto style = std::make_shared<const LitSphere>(size, std::move(pixels));
    for (const double x : {-0.9, -0.5, 0.0, 0.3, 0.8}) {
        const glm::dvec3 normal(x, 0, -std::sqrt(1 - x * x)); // towards the viewer, who looks along +z
        const Picture picture = renderWhole(backend(), tiltedSlab(normal, style));
        const double directional = (1 + x) / 2;
        const double expected = 1 - std::pow(1 - 0.4 * directional, 2);
        EXPECT_NEAR(picture.pixel(0, 0)[3], expected, rounding(1e-6, 1e-4)) << x;
        EXPECT_NEAR(picture.pixel(0, 0)[1], 0.75 * expected, rounding(1e-6, 1e-3)) << x; // 11 bits of colour
    }
}

TEST_P(LitSphereIdentity, TwoSidedLightsTheInsideLikeTheOutside) {
    const glm::dvec3 away(0.6, 0, 0.8); // points away from the viewer
    auto scene = tiltedSlab(away, normalSphere());
    const double alpha = 1 - std::pow(0.6, 2);
    EXPECT_NEAR(renderWhole(backend(), scene).pixel(0, 0)[0], alpha * 0.2, 2e-3); // flipped: n_x = -0.6
    scene.figure.layers.front().twoSided = false;
    EXPECT_NEAR(renderWhole(backend(), scene).pixel(0, 0)[0], alpha * 0.8, 2e-3);
}

TEST_P(LitSphereIdentity, StylesMixBetweenNodes) {
    const glm::dvec3 normal(0.6, 0, -0.8);
    auto scene = tiltedSlab(normal, normalSphere());
    scene.figure.clip.planes = {{{0, 0, 1}, 0.01}, {{0, 0, -1}, 0.01}}; // value 100 but for a hundredth
    Layer& layer = scene.figure.layers.front();
    layer.transfer.opacity = {{0, 1}};
    layer.transfer.nodes = {{99, "style", std::nullopt}, {103, "", glm::dvec3(1, 0, 0)}};
    const Picture picture = renderWhole(backend(), scene);
    EXPECT_NEAR(picture.pixel(0, 0)[0], 0.75 * 0.8 + 0.25 * 1, 4e-3);
    EXPECT_NEAR(picture.pixel(0, 0)[1], 0.75 * 0.5, 4e-3);
}

} // namespace
} // namespace limner
