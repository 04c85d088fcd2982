#include "core/volume/phantom.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

namespace limner {
namespace {

double huAt(const Volume& volume, const glm::dvec3& mm) { return trilinear(volume, volume.grid().voxelFromMm(mm)); }

TEST(HeadPhantom, HasTheTissuesWhereTheyBelong) {
    const auto head = makeHeadPhantom(128);
    EXPECT_EQ(head->contents().modality, Modality::ct);
    EXPECT_EQ(head->contents().unit, "HU");
    EXPECT_NEAR(head->grid().sizeMm().x, 240, 1e-9);
    EXPECT_NEAR(glm::length(head->grid().centreMm()), 0, 1e-9);
    EXPECT_EQ(huAt(*head, {110, 0, 100}), -1000);        // the room
    EXPECT_NEAR(huAt(*head, {0, -30, 80}), 33, 12);      // brain: grey or white matter
    EXPECT_GT(huAt(*head, {0, 94, 31}), 400);            // back of the skull
    EXPECT_GT(huAt(*head, {0, -79.5, -86}), 300);        // chin bone
    EXPECT_NEAR(huAt(*head, {30, -72, 5}), 12, 5);       // vitreous of the left eye
    EXPECT_NEAR(huAt(*head, {-30, -72, 5}), 12, 5);      // and of the right
    EXPECT_NEAR(huAt(*head, {27.6, 3.2, -85}), 340, 60); // left carotid artery
    EXPECT_LT(huAt(*head, {0, 3.5, -85}), -900);         // airway
    EXPECT_GT(head->range().high, 2000);                 // enamel
    EXPECT_EQ(head->range().low, -1000);
}

TEST(HeadPhantom, FaceLooksAnteriorAndIsSymmetric) {
    const auto head = makeHeadPhantom(96);
    EXPECT_LT(huAt(*head, {0, 112, -20}), -900);  // no nose at the back
    EXPECT_GT(huAt(*head, {0, -108, -22}), -200); // the nose's tip
    const glm::ivec3 n = head->grid().dims;
    for (const glm::ivec3 v : {glm::ivec3(20, 40, 50), glm::ivec3(35, 12, 40), glm::ivec3(10, 55, 47)}) {
        EXPECT_EQ(head->storedAt(v), head->storedAt({n.x - 1 - v.x, v.y, v.z}));
    }
}

TEST(HeadPhantom, SkinIsBlurredOverAboutOneVoxel) {
    const auto head = makeHeadPhantom(120); // 2 mm
    int between = 0;
    for (int y = 0; y < 60; ++y) { // along the middle line above the brows, into the forehead
        const double hu = head->valueAt({60, y, 85});
        between += hu > -950 && hu < -100 ? 1 : 0;
        if (hu > -100) {
            break;
        }
    }
    EXPECT_GE(between, 1);
    EXPECT_LE(between, 3);
}

TEST(HeadPhantom, IsDeterministicAndTakesAnySize) {
    const auto a = makeHeadPhantom(37);
    const auto b = makeHeadPhantom(37);
    for (int z = 0; z < 37; ++z) {
        for (int y = 0; y < 37; ++y) {
            for (int x = 0; x < 37; ++x) {
                ASSERT_EQ(a->storedAt({x, y, z}), b->storedAt({x, y, z}));
            }
        }
    }
    EXPECT_EQ(makeHeadPhantom(1)->grid().voxelCount(), 1U);
}

} // namespace
} // namespace limner
