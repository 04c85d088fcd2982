#include "renderer/marks/hatching.h"

#include "mark_shapes.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

namespace limner {
namespace {

using testing::ball;
using testing::cylinder;
using testing::fieldOf;
using testing::strokesIn;
using testing::viewOf;

/// The asked tone of voxels that face the viewer, 0 for the others.
std::vector<float> toneOf(const MarkField& field, const MarkView& view,
                          const std::function<float(const PlaceOnPaper&)>& tone) {
    std::vector<float> all;
    for (const MarkVoxel& voxel : field.voxels) {
        const glm::dvec3 mm = field.placeMm(voxel);
        all.push_back(glm::dot(voxel.normalMm, view.towardsEye(mm)) > 0 ? tone(view.place(mm)) : 0);
    }
    return all;
}

std::vector<MarkGroup> hatch(const MarkField& field, const MarkView& view, std::span<const float> tone,
                             const StippleHatching& settings = {}, bool moving = false) {
    const MarkDepth depth(field, view, false);
    return drawHatching({field, view, depth, InkColour(0), moving}, settings, tone, {}, 1);
}

/// Paper in fine squares, inked where a stroke covers their middles.
class Print {
  public:
    Print(const std::vector<MarkGroup>& groups, float paperMm)
        : size_(static_cast<int>(paperMm / kSquareMm)), inked_(static_cast<std::size_t>(size_) * size_, 0) {
        for (const MarkGroup& group : groups) {
            for (const Stroke& stroke : group.strokes) {
                for (std::uint32_t i = stroke.first; i + 1 < stroke.first + stroke.count; ++i) {
                    lay(group.points[i], group.points[i + 1]);
                }
            }
        }
    }

    /// Share of inked squares between two corners, mm.
    [[nodiscard]] double share(glm::vec2 low, glm::vec2 high) const {
        const glm::ivec2 from(low / kSquareMm);
        const glm::ivec2 to(high / kSquareMm);
        double ink = 0;
        for (int y = from.y; y < to.y; ++y) {
            for (int x = from.x; x < to.x; ++x) {
                ink += inked_[static_cast<std::size_t>(y * size_ + x)];
            }
        }
        return ink / ((to.x - from.x) * (to.y - from.y));
    }

  private:
    static constexpr float kSquareMm = 0.03F;

    void lay(const StrokePoint& a, const StrokePoint& b) {
        const float reach = std::max(a.widthMm, b.widthMm) / 2;
        const glm::ivec2 from((glm::min(a.placeMm, b.placeMm) - reach) / kSquareMm);
        const glm::ivec2 to((glm::max(a.placeMm, b.placeMm) + reach) / kSquareMm);
        const glm::vec2 way = b.placeMm - a.placeMm;
        for (int y = std::max(from.y, 0); y <= std::min(to.y, size_ - 1); ++y) {
            for (int x = std::max(from.x, 0); x <= std::min(to.x, size_ - 1); ++x) {
                const glm::vec2 mm = (glm::vec2(x, y) + 0.5F) * kSquareMm;
                const float t = std::clamp(glm::dot(mm - a.placeMm, way) / glm::dot(way, way), 0.0F, 1.0F);
                if (glm::distance(a.placeMm + t * way, mm) < 0.5F * glm::mix(a.widthMm, b.widthMm, t)) {
                    inked_[static_cast<std::size_t>(y * size_ + x)] = 1;
                }
            }
        }
    }

    int size_;
    std::vector<std::uint8_t> inked_;
};

TEST(Hatching, RunsAroundACylinder) {
    const MarkField field = fieldOf(cylinder(14), 48, 1);
    const MarkView view = viewOf({0, 1, 0}, 50, 75);
    const std::vector<float> tone = toneOf(field, view, [](const PlaceOnPaper&) { return 0.3F; });
    for (const bool moving : {false, true}) {
        const std::vector<MarkGroup> groups = hatch(field, view, tone, {}, moving);
        ASSERT_EQ(groups.size(), 1U);
        EXPECT_EQ(groups[0].name, "Hatching");
        EXPECT_GT(groups[0].strokes.size(), 100U);
        for (const Stroke& stroke : groups[0].strokes) {
            const glm::vec2 way =
                groups[0].points[stroke.first + stroke.count - 1].placeMm - groups[0].points[stroke.first].placeMm;
            // The axis is upright on paper: strokes lie across it, on the outline too.
            ASSERT_LT(std::abs(way.y), 0.15F * glm::length(way));
        }
    }
    // Seen along a slope they are arcs of ellipses: steeper towards the outline, the same way on either side.
    const MarkView slanted = viewOf({0, 1, -0.5}, 50, 75);
    const std::vector<MarkGroup> arcs =
        hatch(field, slanted, toneOf(field, slanted, [](const PlaceOnPaper&) { return 0.3F; }));
    const double tilt = std::sin(std::atan(0.5));
    for (const Stroke& stroke : arcs[0].strokes) {
        const StrokePoint& middle = arcs[0].points[stroke.first + stroke.count / 2];
        const StrokePoint& before = arcs[0].points[stroke.first + stroke.count / 2 - 1];
        const double x = (middle.placeMm.x - 37.5) / 1.5 / 14;
        if (std::abs(x) < 0.8) {
            const glm::dvec2 way(middle.placeMm - before.placeMm);
            EXPECT_NEAR(way.y / way.x, -tilt * x / std::sqrt(1 - x * x), 0.12);
        }
    }
}

TEST(Hatching, CoversAsMuchPaperAsAsked) {
    const MarkField field = fieldOf([](const glm::dvec3& p) { return -p.y + 0.3; }, 44, 1);
    const MarkView view = viewOf({0, 1, 0}, 44, 60);
    for (const double cross : {0.55, 1.0}) {
        for (const float asked : {0.1F, 0.25F, 0.4F, 0.55F, 0.7F}) {
            const std::vector<float> tone = toneOf(field, view, [&](const PlaceOnPaper&) { return asked; });
            StippleHatching settings;
            settings.cross = cross;
            const std::vector<MarkGroup> groups = hatch(field, view, tone, settings);
            const double ink = Print(groups, 60).share({8, 8}, {52, 52});
            EXPECT_NEAR(ink, asked, 0.02) << "cross " << cross;
            RecordProperty("ink of " + std::to_string(asked) + " cross " + std::to_string(cross), std::to_string(ink));
        }
    }
}

TEST(Hatching, FollowsARampOfTone) {
    const MarkField field = fieldOf([](const glm::dvec3& p) { return -p.y + 0.3; }, 44, 1);
    const MarkView view = viewOf({0, 1, 0}, 44, 60);
    const std::vector<float> tone =
        toneOf(field, view, [](const PlaceOnPaper& at) { return std::clamp(at.mm.x / 60, 0.0F, 1.0F); });
    const std::vector<MarkGroup> groups = hatch(field, view, tone);
    const Print print(groups, 60);
    for (float x = 6; x < 42; x += 6) {
        EXPECT_NEAR(print.share({x, 8}, {x + 6, 52}), (x + 3) / 60, 0.05) << x;
    }
}

TEST(Hatching, StrokesAreAsLongAndWideAsAsked) {
    const MarkField field = fieldOf([](const glm::dvec3& p) { return -p.y + 0.3; }, 44, 1);
    for (const double paper : {40.0, 80.0}) {
        const MarkView view = viewOf({0, 1, 0}, 44, paper);
        const std::vector<float> tone = toneOf(field, view, [](const PlaceOnPaper&) { return 0.4F; });
        const StippleHatching settings{3, 0.15, 1};
        const std::vector<MarkGroup> groups = hatch(field, view, tone, settings);
        double length = 0;
        double width = 0;
        double end = 0;
        for (const Stroke& stroke : groups[0].strokes) {
            double own = 0;
            for (std::uint32_t i = stroke.first + 1; i < stroke.first + stroke.count; ++i) {
                own += glm::distance(groups[0].points[i - 1].placeMm, groups[0].points[i].placeMm);
            }
            EXPECT_LT(own, 3 * 1.25 + 0.2);
            end += groups[0].points[stroke.first].widthMm;
            length += own;
            width += groups[0].points[stroke.first + stroke.count / 2].widthMm;
        }
        const auto count = static_cast<double>(groups[0].strokes.size());
        EXPECT_NEAR(length / count, 3, 0.9);
        EXPECT_NEAR(width / count, 0.15, 0.05);
        EXPECT_LT(end, 0.6 * width);
    }
}

TEST(Hatching, CrossesOnlyInTheDark) {
    const MarkField field = fieldOf(cylinder(14), 48, 1);
    const MarkView view = viewOf({0, 1, 0}, 50, 75);
    const std::vector<float> tone =
        toneOf(field, view, [](const PlaceOnPaper& at) { return at.mm.y > 37.5F ? 0.8F : 0.3F; });
    int upright = 0;
    for (const MarkGroup& group : hatch(field, view, tone)) {
        for (const Stroke& stroke : group.strokes) {
            const glm::vec2 from = group.points[stroke.first].placeMm;
            const glm::vec2 way = group.points[stroke.first + stroke.count - 1].placeMm - from;
            if (std::abs(way.y) > std::abs(way.x)) {
                ++upright;
                EXPECT_GT(std::max(from.y, from.y + way.y), 36) << "crossing where it is light";
            }
        }
    }
    EXPECT_GT(upright, 50);
    StippleHatching never;
    never.cross = 1;
    for (const MarkGroup& group : hatch(field, view, tone, never)) {
        for (const Stroke& stroke : group.strokes) {
            const glm::vec2 way =
                group.points[stroke.first + stroke.count - 1].placeMm - group.points[stroke.first].placeMm;
            EXPECT_LT(std::abs(way.y), std::abs(way.x));
        }
    }
}

TEST(Hatching, StaysOnWhatIsSeen) {
    // The ball's curvature has no direction: strokes follow the view's vertical, and none leaves the ball.
    const MarkField field = fieldOf(ball(15), 40, 1);
    const MarkView view = viewOf({0, 1, 0}, 44, 66);
    const std::vector<float> tone = toneOf(field, view, [](const PlaceOnPaper&) { return 0.4F; });
    const std::vector<MarkGroup> groups = hatch(field, view, tone);
    ASSERT_EQ(groups.size(), 1U);
    for (const StrokePoint& p : groups[0].points) {
        EXPECT_LT(glm::distance(p.placeMm, glm::vec2(33)), (15 + 0.6) * 1.5);
    }
    EXPECT_TRUE(hatch(field, view, std::vector<float>(field.voxels.size(), 0)).empty());
    EXPECT_TRUE(hatch(field, view, std::vector<float>(3, 0.5F)).empty()) << "tones of something else";
}

TEST(Hatching, IsTheSameForAnyNumberOfThreads) {
    const MarkField field = fieldOf(testing::torus(14, 6), 48, 1);
    const MarkView view = viewOf({0.3, 1, 0.5}, 48, 80);
    const std::vector<float> tone = toneOf(field, view, [](const PlaceOnPaper& at) { return at.mm.x / 80; });
    for (const bool moving : {false, true}) {
        const std::vector<MarkGroup> many = hatch(field, view, tone, {}, moving);
        EXPECT_GT(strokesIn(many), 100U);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_TRUE(testing::sameMarks(many, hatch(field, view, tone, {}, moving)));
    }
}

TEST(Hatching, OfPoorFieldsIsSound) {
    const MarkView view = viewOf({0, 1, 0}, 10, 50);
    for (const int voxels : {0, 1, 9}) {
        MarkField field;
        field.grid.dims = glm::ivec3(3);
        field.rowStart = {0};
        for (int row = 0; row < 9; ++row) {
            for (int x = 0; x < 3 && static_cast<int>(field.voxels.size()) < voxels; ++x) {
                field.voxels.push_back(testing::voxelAt({x, row % 3, row / 3}, 0, glm::dvec3(0), 1));
                field.curvatures.push_back({glm::vec3(0), std::numeric_limits<float>::quiet_NaN(), 0});
            }
            field.rowStart.push_back(static_cast<std::uint32_t>(field.voxels.size()));
        }
        for (const bool moving : {false, true}) {
            const std::vector<float> tone(field.voxels.size(), 0.5F);
            for (const MarkGroup& group : hatch(field, view, tone, {}, moving)) {
                for (const StrokePoint& p : group.points) {
                    EXPECT_TRUE(std::isfinite(p.placeMm.x) && std::isfinite(p.placeMm.y) && std::isfinite(p.widthMm));
                }
            }
        }
    }
}

} // namespace
} // namespace limner
