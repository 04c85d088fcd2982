#include "core/base/error.h"
#include "core/volume/import.h"
#include "core/volume/phantom.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace limner {
namespace {

TEST(ImportBuiltin, headIsThePhantomWithItsGridAndUnit) {
    Task task;
    const ImportedVolume imported = importVolume("builtin:head", {}, task);
    const auto phantom = makeHeadPhantom(256);
    ASSERT_EQ(imported.volume->grid().dims, phantom->grid().dims);
    const glm::ivec3 middle = phantom->grid().dims / 2;
    for (int x = 0; x < phantom->grid().dims.x; ++x) {
        const glm::ivec3 voxel{x, middle.y, middle.z};
        ASSERT_EQ(imported.volume->valueAt(voxel), phantom->valueAt(voxel)) << x;
    }
    // 1e-9 mm: only the rounding of axes to directions and spacings and back
    EXPECT_NEAR(glm::length(imported.volume->grid().mmFromVoxel({0, 0, 0}) - phantom->grid().mmFromVoxel({0, 0, 0})), 0,
                1e-9);
    EXPECT_EQ(imported.volume->contents().modality, Modality::ct);
    EXPECT_EQ(imported.report.format, "built-in head");
    EXPECT_FALSE(imported.report.sha256Values.empty());
    EXPECT_TRUE(task.warnings().empty());
}

TEST(ImportBuiltin, anotherNameIsRefused) {
    Task task;
    try {
        importVolume("builtin:foot", {}, task);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        EXPECT_NE(std::string(error.what()).find("builtin:head"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace limner
