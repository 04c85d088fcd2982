#include "renderer/gl/gl_backend.h"

#include "renderer/backend_choice.h"
#include "renderer/gl/device.h"
#include "renderer/gl/program.h"
#include "support/gl_backend.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

// What the OpenGL backend does beside drawing a whole small volume at once.

namespace limner {
namespace {

using testing::renderWhole;
using testing::sameBits;

std::shared_ptr<const RenderPlan> planOf(const std::string& feature, int pixels) {
    testing::SmoothScene scene;
    scene.type = VoxelType::int16;
    Figure figure = testing::smoothFigure(scene);
    const auto& all = testing::transferFeatures();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == feature; });
    EXPECT_NE(found, all.end()) << feature;
    found->apply(figure);
    PlanRequest request;
    request.size = {pixels, pixels};
    return testing::planOf(figure, request);
}

class GlBackends : public testing::GlTest {
  protected:
    void TearDown() override {
        if (!IsSkipped()) {
            gl().setRoom(kRoom);
        }
        GlTest::TearDown();
    }
    static constexpr std::uint64_t kRoom = std::uint64_t{1} << 31U;
};

TEST_F(GlBackends, TilesOfAnyKindGiveTheSameBits) {
    for (const char* feature : {"contoursHessianStyle", "importanceSilhouette"}) {
        const auto plan = planOf(feature, 600); // over several of the backend's own tiles
        const Picture whole = renderWhole(gl(), *plan);
        for (const glm::ivec2 tiles : {glm::ivec2(3, 2), glm::ivec2(1, 7)}) {
            EXPECT_TRUE(sameBits(testing::renderTiles(gl(), *plan, tiles), whole)) << feature << ' ' << tiles.x;
        }
    }
}

/// Bytes of what all parts of a volume read.
std::uint64_t sharedBytes(const RenderPlan& plan) {
    std::uint64_t bytes = plan.skip->distance.size() + (plan.atlas ? 2 * plan.atlas->texels.size() : 0);
    if (plan.cues) {
        for (const auto& cue : {plan.cues->ambient, plan.cues->shadow, plan.cues->halo}) {
            bytes += cue ? 4 * cue->values.size() : 0;
        }
    }
    return bytes;
}

TEST_F(GlBackends, VolumesBeyondTheCardsMemoryComeInParts) {
    const auto& all = testing::transferFeatures();
    std::vector<std::string> names = {"slabsStyle", "slabsLongSteps"};         // slabs reach from part to part
    for (std::size_t i = 0; i < all.size(); i += i + 3 < all.size() ? 6 : 1) { // each makes a shader of its own
        names.push_back(all[i].name);
    }
    for (const std::string& name : names) {
        const auto plan = planOf(name, 40);
        gl().setRoom(kRoom);
        const Picture whole = renderWhole(gl(), *plan);
        // 30 x 34 x 32 voxels of two bytes are 65 KB: several parts, each with its margins.
        gl().setRoom(sharedBytes(*plan) + 100'000);
        const Picture inParts = renderWhole(gl(), *plan);
        EXPECT_LT(testing::rootMeanSquare(inParts, whole), 1e-5) << name;
        EXPECT_LT(testing::largestDifference(inParts, whole), 1e-3) << name;
    }
}

TEST_F(GlBackends, ARoomForNothingIsSaid) {
    const auto plan = planOf("contoursHessianStyle", 40);
    gl().setRoom(1000);
    try {
        renderWhole(gl(), *plan);
        FAIL() << "drawn without memory";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::noResources);
    }
}

TEST_F(GlBackends, AHundredLostContextsChangeNoPicture) {
    const auto plan = planOf("contoursHessianStyle", 40);
    const Picture before = renderWhole(gl(), *plan);
    for (int i = 0; i < 100; ++i) {
        gl().loseContext();
        ASSERT_TRUE(sameBits(renderWhole(gl(), *plan), before)) << i;
    }
}

TEST_F(GlBackends, DrawsOnAnyThread) {
    const auto plan = planOf("contoursHessianStyle", 40);
    const Picture here = renderWhole(gl(), *plan);
    Picture there;
    std::thread other([&] { there = renderWhole(gl(), *plan); });
    other.join();
    EXPECT_TRUE(sameBits(here, there));
    EXPECT_TRUE(sameBits(here, renderWhole(gl(), *plan)));
}

TEST_F(GlBackends, CountsItsSamples) {
    const auto plan = planOf("contoursHessianStyle", 64);
    Task task;
    const RenderResult drawn = gl().render(*plan, {{0, 0}, plan->size}, task);
    const RenderResult expected = makeCpuBackend()->render(*plan, {{0, 0}, plan->size}, task);
    EXPECT_GT(drawn.samples, drawn.shaded);
    EXPECT_NEAR(static_cast<double>(drawn.shaded), static_cast<double>(expected.shaded),
                0.01 * static_cast<double>(expected.shaded));
}

TEST_F(GlBackends, ACancelledPictureEnds) {
    const auto plan = planOf("contoursHessianStyle", 64);
    Task task;
    task.cancel();
    EXPECT_THROW(gl().render(*plan, {{0, 0}, plan->size}, task), Error);
}

TEST(GlPrograms, ErrorsAreToldByFileAndLine) {
    if (testing::sharedGl() == nullptr) {
        GTEST_SKIP() << "no OpenGL here";
    }
    gl::Device device(gl::contextFactory(testing::sharedGl()->facts().library)());
    gl::ProgramSource vertex;
    vertex.add("whole_target.vert");
    gl::ProgramSource fragment;
    fragment.add("math.glsl").add("compose.glsl"); // what compose.glsl reads of others is missing
    fragment.define("IMPORTANCE", 0);
    try {
        device.program(vertex, fragment);
        FAIL() << "half a shader was linked";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("fragment"), std::string::npos) << error.what();
    }
    gl::ProgramSource broken;
    broken.define("IMPORTANCE", 1).define("LENSES", 0).define("UNOCCLUSION", 0).add("math.glsl").add("compose.glsl");
    try {
        device.program(vertex, broken);
        FAIL() << "a shader without its formulas was linked";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("compose.glsl:"), std::string::npos) << error.what();
    }
}

TEST(BackendChoices, ProgramsThatDrawOnTheProcessorAreNoCards) {
    EXPECT_TRUE(gl::isSoftware("llvmpipe (LLVM 15.0.6, 256 bits)"));
    EXPECT_TRUE(gl::isSoftware("softpipe"));
    EXPECT_TRUE(gl::isSoftware("Google SwiftShader"));
    EXPECT_FALSE(gl::isSoftware("NVIDIA H100 80GB HBM3/PCIe/SSE2"));
    EXPECT_FALSE(gl::isSoftware("AMD Radeon RX 6800 (radeonsi, navi21, LLVM 15.0.6)"));
    EXPECT_FALSE(gl::isSoftware("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"));
}

TEST(BackendChoices, AutomaticIsTheProcessorWithoutACard) {
    const BackendChoice& choice = automaticBackend("osmesa"); // draws on the processor wherever it runs
    EXPECT_EQ(choice.name, "cpu");
    EXPECT_FALSE(choice.reason.empty());
    EXPECT_EQ(makeBackend("auto", "osmesa")->name(), "cpu");
    EXPECT_EQ(makeBackend("reference")->name(), "reference");
    EXPECT_THROW(makeBackend("vulkan"), Error);
    EXPECT_THROW(makeBackend("gl", "vulkan"), Error);
}

} // namespace
} // namespace limner
