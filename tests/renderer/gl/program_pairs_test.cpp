#include "renderer/gl/device.h"
#include "renderer/gl/scene_program.h"
#include "renderer/scene/scene_builder.h"
#include "support/gl_backend.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <chrono>
#include <set>

// Any two features of a figure make a shader that compiles and links, in all the ways that it can be drawn.

namespace limner {
namespace {

/// A part of the pairs each, so that a run on several processors shares the work.
class GlPrograms : public testing::GlTest, public ::testing::WithParamInterface<std::size_t> {};
constexpr std::size_t kParts = 8;
INSTANTIATE_TEST_SUITE_P(Pairs, GlPrograms, ::testing::Range(std::size_t{0}, kParts));

std::shared_ptr<const RenderPlan> planOfPair(std::size_t a, std::size_t b) {
    testing::SmoothScene scene;
    scene.dims = {8, 9, 10}; // what is compiled does not depend on the size
    scene.projection = (a + b) % 2 == 0 ? Projection::perspective : Projection::orthographic;
    Figure figure = testing::smoothFigure(scene);
    testing::transferFeatures()[a].apply(figure);
    testing::transferFeatures()[b].apply(figure);
    PlanRequest request;
    request.size = {8, 8};
    return testing::planOf(figure, request);
}

TEST_P(GlPrograms, OfAnyTwoFeaturesLink) {
    gl::Device device(gl::contextFactory(gl().facts().library)());
    const gl::ProgramSource vertex = gl::wholeTarget();
    const std::size_t features = testing::transferFeatures().size();
    std::set<std::string> seen;
    std::size_t figures = 0;
    double seconds = 0;
    for (std::size_t pair = GetParam(); pair < features * features; pair += kParts) {
        const std::size_t a = pair / features;
        const std::size_t b = pair % features;
        if (a >= b) {
            continue;
        }
        const auto plan = planOfPair(a, b);
        if (plan->layers.empty()) {
            continue;
        }
        ++figures;
        const BuiltScene built(*plan);
        const bool lenses = plan->importance && !plan->importance->lenses.empty();
        const gl::ProgramChoices choices{pair % 3 == 0, plan->importance.has_value(), pair % 2 == 0, lenses};
        const gl::ProgramSource source = gl::castingProgram(*plan, built.scene(), choices);
        if (!seen.insert(source.text()).second) {
            continue;
        }
        const auto begin = std::chrono::steady_clock::now();
        try {
            const gl::Program program(device.gl(), vertex, source);
        } catch (const Error& error) {
            ADD_FAILURE() << testing::transferFeatures()[a].name << " with " << testing::transferFeatures()[b].name
                          << ": " << error.what();
        }
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    std::cout << figures << " pairs, " << seen.size() << " shaders, "
              << 1000 * seconds / static_cast<double>(seen.size()) << " ms to compile and link each\n";
    EXPECT_GT(seen.size(), 100U);
}

} // namespace
} // namespace limner
