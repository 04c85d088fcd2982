#include "core/base/error.h"
#include "core/base/task.h"
#include "core/style/extraction/find.h"
#include "support/artworks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limner {
namespace {

using namespace limner::testing;

ArtPath circle(glm::dvec2 centre, double radius) {
    ArtPath path;
    for (int i = 0; i < 24; ++i) {
        path.push_back(centre + radius * glm::dvec2(std::cos(i * 0.2618), std::sin(i * 0.2618)));
    }
    return path;
}

/// Share of the pixels of either that both have.
double agreement(const Mask& a, const Mask& b) {
    int both = 0;
    int either = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        both += a.values[i] >= 128 && b.values[i] >= 128 ? 1 : 0;
        either += a.values[i] >= 128 || b.values[i] >= 128 ? 1 : 0;
    }
    return either > 0 ? static_cast<double>(both) / either : 0;
}

TEST(RefineRegion, ARoughLassoFindsTheForm) {
    const SyntheticArt art = drawn(320, 300, blobForm({160, 150}), plainStyle());
    const ArtCut cut{withNoise(art.picture, 0.02), {0, 0}, 1};
    Task task;
    const Mask form = refineRegion(cut, circle({160, 145}, 125), task);
    ASSERT_EQ(form.values.size(), art.form.values.size());
    EXPECT_GT(agreement(form, art.form), 0.95);
    // The same lasso gives the same form.
    EXPECT_EQ(refineRegion(cut, circle({160, 145}, 125), task).values, form.values);
}

TEST(RefineRegion, ACutsPlaceAndScaleCount) {
    const SyntheticArt art = drawn(160, 150, ballForm({{80, 75}, {50, 50}, 0}), plainStyle());
    const ArtCut cut{art.picture, {1000, 500}, 4};
    Task task;
    const Mask form = refineRegion(cut, circle({1000 + 4 * 80, 500 + 4 * 75}, 4 * 58), task);
    ASSERT_FALSE(form.empty());
    EXPECT_GT(agreement(form, art.form), 0.94);
}

TEST(RefineRegion, NothingToFindIsEmpty) {
    const ArtCut cut{drawn(64, 64, ballForm({{32, 32}, {20, 20}, 0}), plainStyle()).picture, {0, 0}, 1};
    Task task;
    EXPECT_TRUE(refineRegion(cut, {}, task).empty());
    EXPECT_TRUE(refineRegion(cut, {{1, 1}, {2, 2}}, task).empty());
    EXPECT_TRUE(refineRegion(cut, circle({900, 900}, 30), task).empty());
    EXPECT_TRUE(refineRegion(cut, circle({32, 32}, 1), task).empty());
    EXPECT_TRUE(refineRegion({}, circle({32, 32}, 10), task).empty());
    EXPECT_NO_THROW(refineRegion(cut, {{NAN, 0}, {1e300, 5}, {3, -1e300}}, task));
}

TEST(RefineRegion, ALassoAroundThePictureIsAllRight) {
    const ArtCut cut{drawn(80, 80, ballForm({{40, 40}, {60, 60}, 0}), plainStyle()).picture, {0, 0}, 1};
    Task task;
    const Mask form = refineRegion(cut, {{-10, -10}, {100, -10}, {100, 100}, {-10, 100}}, task);
    ASSERT_FALSE(form.empty());
    EXPECT_TRUE(form.has(40, 40));
}

TEST(RefineRegion, StopsWhenToldTo) {
    const ArtCut cut{drawn(160, 150, ballForm({{80, 75}, {50, 50}, 0}), plainStyle()).picture, {0, 0}, 1};
    Task task;
    task.cancel();
    EXPECT_THROW(refineRegion(cut, circle({80, 75}, 60), task), Error);
}

} // namespace
} // namespace limner
