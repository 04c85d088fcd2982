#include "renderer/plan/leave_out.h"

#include "core/volume/widened.h"
#include "renderer/marks/marked_picture.h"
#include "support/gl_backend.h"
#include "support/mark_scenes.h"
#include "support/rendering.h"
#include "support/transfer_scenes.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

// Each rule of leaving out, on against off: where its condition holds the picture is the same to within what the table
// states, and where it does not hold the rule is not at work.

namespace limner {
namespace {

/// Single precision, a few dozen samples of at most 1 each in another order or form.
constexpr double kRounding = 4e-6;

Figure smooth(VoxelType type = VoxelType::int16) {
    testing::SmoothScene scene;
    scene.type = type;
    Figure figure = testing::smoothFigure(scene);
    figure.quality.earlyTermination = 0; // or rays end a sample sooner or later
    Layer& layer = figure.layers.front();
    layer.shading = Shading::flat;
    testing::makeLine(layer, "value");
    return figure;
}

Layer& only(Figure& figure) { return figure.layers.front(); }

Figure styled(VoxelType type = VoxelType::int16) {
    Figure figure = smooth(type);
    only(figure).shading = Shading::style;
    testing::makeLine(only(figure), "value"); // its nodes are styles then
    return figure;
}

Figure weighed(const std::function<void(Importance&)>& change) {
    Figure figure = styled();
    figure.importance.emplace().global = 2;
    change(*figure.importance);
    return figure;
}

Lens lensAt(double radius, double outside) {
    Lens lens;
    lens.kind = "circular";
    lens.center = {0.3, 0.3};
    lens.radius = radius;
    lens.outside = outside;
    return lens;
}

Figure changed(Figure figure, const std::function<void(Figure&)>& change) {
    change(figure);
    return figure;
}

void setColours(Figure& figure, const glm::dvec3& first, const glm::dvec3& last) {
    for (TransferNode& node : only(figure).transfer.nodes) {
        node.style.clear();
        node.rgb = first;
    }
    only(figure).transfer.nodes.back().rgb = last;
}

void setStyles(Figure& figure, const std::string& first, const std::string& last) {
    for (TransferNode& node : only(figure).transfer.nodes) {
        node.style = first;
        node.rgb.reset();
    }
    only(figure).transfer.nodes.back().style = last;
}

void makeGrid(Figure& figure, const std::string& style) {
    testing::makePlane(only(figure), "value", "gradient");
    for (auto& row : only(figure).transfer.grid->styles) {
        std::fill(row.begin(), row.end(), style);
    }
}

/// Seen from so near that voxels are wider than rays, or not.
void lookFrom(Figure& figure, double heightMm) {
    figure.camera.projection = Projection::perspective;
    figure.camera.heightMm = heightMm;
}

Figure inked(double distance, double interior) {
    Figure figure =
        testing::inkFigure(testing::bodyVolume(40, [](const glm::dvec3& p) { return glm::length(p) - 14; }), 40, 44);
    figure.stipple->lighting.emplace();
    figure.stipple->distance.emplace().kde = distance;
    figure.stipple->interior.emplace().kte = interior;
    return figure;
}

/// A figure to which a rule applies, or one to which it does not by a hair.
struct Case {
    std::string name;
    LeaveOut rule;
    bool applies;
    std::function<Figure()> figure;
};

void addLayerCases(std::vector<Case>& all) {
    const auto twoLayers = [](double opacity) {
        return [opacity] {
            Figure figure = smooth();
            figure.layers.push_back(only(figure));
            figure.layers.back().opacity = opacity;
            return figure;
        };
    };
    all.push_back({"layerOfNoOpacity", LeaveOut::layers, true, twoLayers(0)});
    all.push_back({"layerOfLittleOpacity", LeaveOut::layers, false, twoLayers(0.01)});
    all.push_back({"flat", LeaveOut::normals, true, [] { return smooth(); }});
    all.push_back({"phong", LeaveOut::normals, false,
                   [] { return changed(smooth(), [](Figure& f) { only(f).shading = Shading::phong; }); }});
    const auto lit = [](double diffuse) {
        return [diffuse] {
            return changed(smooth(), [&](Figure& f) {
                only(f).shading = Shading::phong;
                only(f).phong = PhongLight{1, diffuse};
                only(f).specular.emplace().strength = 0;
            });
        };
    };
    all.push_back({"phongUnlit", LeaveOut::normals, true, lit(0)});
    all.push_back({"phongHardlyLit", LeaveOut::normals, false, lit(0.01)});
    for (const Shading shading : {Shading::flat, Shading::style, Shading::phong}) {
        const auto contoured = [shading](double thickness) {
            return [=] {
                return changed(styled(), [&](Figure& f) {
                    only(f).shading = shading;
                    only(f).contours = Contours{thickness, true, CurvatureEstimator::hessian, 1.3};
                });
            };
        };
        const std::string suffix = std::to_string(static_cast<int>(shading));
        all.push_back({"contoursOfNoWidth" + suffix, LeaveOut::curvature, true, contoured(0)});
        all.push_back({"contours" + suffix, LeaveOut::curvature, false, contoured(0.01)});
    }
}

void addImportanceCases(std::vector<Case>& all) {
    const auto add = [&](const std::string& name, LeaveOut rule, bool applies, auto change) {
        all.push_back({name, rule, applies, [change] { return weighed(change); }});
    };
    const auto object = [](int label) {
        return [label](Importance& i) {
            i.weights.object = 1;
            i.objects = {{label, 1.5}};
        };
    };
    add("noWeights", LeaveOut::importance, true, [](Importance&) {});
    add("noGlobalWeight", LeaveOut::importance, true, [](Importance& i) {
        i.global = 0;
        i.weights.silhouette = 1;
    });
    add("objectThatIsNowhere", LeaveOut::importance, true, object(5));
    add("object", LeaveOut::importance, false, object(3));
    add("background", LeaveOut::importance, false, [](Importance& i) { i.background = 0.5; });
    const auto layerOf = [](double weight, double silhouette) {
        return [=] {
            Figure figure = weighed([&](Importance& i) {
                i.weights.intensity = 2;
                i.weights.silhouette = silhouette;
            });
            only(figure).importanceWeight = weight;
            return figure;
        };
    };
    all.push_back({"layerThatDoesNotMatter", LeaveOut::importance, true, layerOf(0, 0)});
    all.push_back({"layerThatHardlyMatters", LeaveOut::importance, false, layerOf(0.01, 0)});
    all.push_back({"darkenedOutlines", LeaveOut::importance, false, layerOf(0, 1)});
    const auto lens = [](double radius, double outside) {
        return [=](Importance& i) {
            i.weights.intensity = 2;
            i.lenses = {lensAt(radius, outside)};
        };
    };
    add("smallLens", LeaveOut::importanceOutsideLenses, true, lens(0.1, 0));
    add("lensThatDims", LeaveOut::importanceOutsideLenses, false, lens(0.1, 0.2));
    add("lensOverAll", LeaveOut::importanceOutsideLenses, false, lens(2, 0));
    add("objectOnTheRay", LeaveOut::importanceOfRest, true, object(3));
    add("objectAmongMeasures", LeaveOut::importanceOfRest, true, [object](Importance& i) {
        object(7)(i);
        i.weights.silhouette = 0.2;
        i.weights.extinction = 0.1;
    });
    add("unocclusion", LeaveOut::importanceOfRest, false, [](Importance& i) { i.weights.unocclusion = 0.1; });
}

void addSampleCases(std::vector<Case>& all) {
    const auto add = [&](const std::string& name, LeaveOut rule, bool applies, const Figure& figure) {
        all.push_back({name, rule, applies, [figure] { return figure; }});
    };
    add("emptySpace", LeaveOut::emptySpace, true, styled());
    add("nothingEmpty", LeaveOut::emptySpace, false, changed(smooth(), [](Figure& f) {
            only(f).transfer.opacity = {{-10, 0.1}, {10, 0.1}};
        }));
    add("emptySpaceByImportance", LeaveOut::emptySpace, true, weighed([](Importance& i) { i.weights.intensity = 2; }));
    const auto ended = [](double early) {
        return changed(styled(), [&](Figure& f) {
            only(f).transfer.opacity = {{0.1, 0}, {0.3, 0.9}, {2, 0.9}};
            f.quality.earlyTermination = early;
        });
    };
    add("raysThatEnd", LeaveOut::restOfRay, true, ended(0.01));
    add("raysThatGoOn", LeaveOut::restOfRay, false, ended(0));
    for (const GradientEstimator gradient : {GradientEstimator::central, GradientEstimator::sobel,
                                             GradientEstimator::fourthOrder, GradientEstimator::bspline}) {
        const auto estimated = [gradient](VoxelType type) {
            return changed(styled(type), [&](Figure& f) {
                f.quality.gradient = gradient;
                only(f).contours.emplace();
            });
        };
        const std::string suffix = std::to_string(static_cast<int>(gradient));
        add("eightBits" + suffix, LeaveOut::wideVoxels, true, estimated(VoxelType::uint8));
        add("sixteenBits" + suffix, LeaveOut::wideVoxels, false, estimated(VoxelType::int16));
    }
    add("eightBitsTricubic", LeaveOut::wideVoxels, false,
        changed(styled(VoxelType::uint8), [](Figure& f) { f.quality.interpolation = Interpolation::tricubic; }));
    add("near", LeaveOut::mipLevels, true, changed(styled(), [](Figure& f) { lookFrom(f, 20); }));
    add("far", LeaveOut::mipLevels, false, changed(styled(), [](Figure& f) { lookFrom(f, 200); }));
    add("oneLevelServesAll", LeaveOut::mipLevels, false, styled());
    const glm::dvec3 red(0.9, 0.2, 0.1);
    add("onePlainColour", LeaveOut::colourLookups, true,
        changed(smooth(), [&](Figure& f) { setColours(f, red, red); }));
    add("twoPlainColours", LeaveOut::colourLookups, false,
        changed(smooth(), [&](Figure& f) { setColours(f, red, red * 0.99); }));
    add("oneStyle", LeaveOut::colourLookups, true, changed(styled(), [](Figure& f) { setStyles(f, "a", "a"); }));
    add("twoStyles", LeaveOut::colourLookups, false, changed(styled(), [](Figure& f) { setStyles(f, "a", "b"); }));
    add("gridOfOneColour", LeaveOut::colourLookups, true, changed(smooth(), [](Figure& f) { makeGrid(f, "#e04020"); }));
    add("gridOfOneStyle", LeaveOut::colourLookups, true, changed(styled(), [](Figure& f) { makeGrid(f, "a"); }));
    add("idleFactors", LeaveOut::dotFactors, true, inked(0, 0));
    add("dotsByDistance", LeaveOut::dotFactors, false, inked(0.5, 0.01));
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = [] {
        std::vector<Case> made;
        addLayerCases(made);
        addImportanceCases(made);
        addSampleCases(made);
        return made;
    }();
    return all;
}

class LeaveOutRules : public ::testing::TestWithParam<std::size_t> {
  protected:
    [[nodiscard]] const Case& one() const { return cases()[GetParam()]; }

    static std::shared_ptr<const RenderPlan> planKeeping(const Figure& figure, const KeptIn& kept, int pixels = 96) {
        PlanRequest request;
        request.size = glm::ivec2(pixels); // three blocks of rays an edge
        request.kept = kept;
        return testing::planOf(figure, request);
    }

    static bool atWork(const RenderPlan& plan, LeaveOut rule) {
        return std::any_of(plan.leftOut.begin(), plan.leftOut.end(), [&](const LeftOut& o) { return o.rule == rule; });
    }

    static RenderResult drawn(const RenderPlan& plan, const Backend& backend) {
        Task task;
        return MarkedPicture(plan, backend, task).render({{0, 0}, plan.size}, task);
    }

    void expectSame(const Picture& lean, const Picture& kept, double earlyTermination, double rounding) const {
        switch (ruleOf(one().rule).equality) {
        case LeaveOutEquality::sameBits: EXPECT_TRUE(testing::sameBits(lean, kept)); break;
        case LeaveOutEquality::rounding: EXPECT_LE(testing::largestDifference(lean, kept), rounding); break;
        case LeaveOutEquality::tolerance:
            EXPECT_LE(testing::largestDifference(lean, kept), earlyTermination + rounding);
            break;
        }
        RecordProperty("difference", std::to_string(testing::largestDifference(lean, kept)));
    }
};

INSTANTIATE_TEST_SUITE_P(Of, LeaveOutRules, ::testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& tested) { return cases()[tested.param].name; });

TEST_P(LeaveOutRules, ApplyWhereTheirConditionHoldsAlone) {
    const Figure figure = one().figure();
    EXPECT_EQ(atWork(*planKeeping(figure, {}), one().rule), one().applies);
    EXPECT_FALSE(atWork(*planKeeping(figure, {one().rule}), one().rule));
}

TEST_P(LeaveOutRules, ChangeNoPicture) {
    const Figure figure = one().figure();
    const auto backend = makeCpuBackend();
    const RenderResult lean = drawn(*planKeeping(figure, {}), *backend);
    const RenderResult kept = drawn(*planKeeping(figure, {one().rule}), *backend);
    EXPECT_EQ(testing::unsoundPixels(lean.picture), 0);
    EXPECT_GT(testing::largestDifference(lean.picture, Picture(lean.picture.size())), 0.1) << "nothing is drawn";
    expectSame(lean.picture, kept.picture, figure.quality.earlyTermination, kRounding);
    if (one().rule == LeaveOut::emptySpace || one().rule == LeaveOut::restOfRay) {
        EXPECT_EQ(lean.samples < kept.samples, one().applies);
    }
}

TEST_P(LeaveOutRules, ChangeNoReferencePicture) {
    const Figure figure = one().figure();
    const auto backend = makeReferenceBackend();
    constexpr int kPixels = 20; // double precision, every sample
    const Picture lean = drawn(*planKeeping(figure, {}, kPixels), *backend).picture;
    const Picture kept = drawn(*planKeeping(figure, {one().rule}, kPixels), *backend).picture;
    expectSame(lean, kept, figure.quality.earlyTermination, 1e-7); // of the picture's single precision
}

class LeaveOutOnGl : public LeaveOutRules {};

/// Cases of the rules that are at work on a card too. It composes and lays dots in its own way, and blends widened
/// numbers in fewer of its steps than those of the texture that it makes of eight bits.
std::vector<std::size_t> casesOfCards() {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < cases().size(); ++i) {
        const LeaveOut rule = cases()[i].rule;
        if (cases()[i].applies && rule != LeaveOut::importanceOfRest && rule != LeaveOut::dotFactors &&
            rule != LeaveOut::wideVoxels) {
            indices.push_back(i);
        }
    }
    return indices;
}

INSTANTIATE_TEST_SUITE_P(Of, LeaveOutOnGl, ::testing::ValuesIn(casesOfCards()),
                         [](const auto& tested) { return cases()[tested.param].name; });

TEST_P(LeaveOutOnGl, ChangeNoPicture) {
    if (testing::sharedGl() == nullptr) {
        GTEST_SKIP() << "no OpenGL here";
    }
    const Figure figure = one().figure();
    const Picture lean = drawn(*planKeeping(figure, {}), *testing::sharedGl()).picture;
    const Picture kept = drawn(*planKeeping(figure, {one().rule}), *testing::sharedGl()).picture;
    // Another shader may be another order of the same sum.
    EXPECT_LE(testing::largestDifference(lean, kept), figure.quality.earlyTermination + 2e-5);
}

TEST(LeaveOut, RulesAreATableInOrder) {
    std::set<std::string> ids;
    for (std::size_t i = 0; i < kLeaveOutRules; ++i) {
        const LeaveOutRule& rule = leaveOutRules()[i];
        EXPECT_EQ(static_cast<std::size_t>(rule.what), i);
        EXPECT_TRUE(ids.insert(rule.id).second) << rule.id;
        EXPECT_TRUE(std::any_of(cases().begin(), cases().end(), [&](const Case& c) {
            return c.rule == rule.what && c.applies;
        })) << rule.id;
        EXPECT_TRUE(std::any_of(cases().begin(), cases().end(), [&](const Case& c) {
            return c.rule == rule.what && !c.applies;
        })) << rule.id;
    }
}

TEST(LeaveOut, KeepingEverythingLeavesNothingOut) {
    PlanRequest request;
    request.size = {48, 48};
    request.omit = false;
    for (const Case& one : cases()) {
        EXPECT_TRUE(testing::planOf(one.figure(), request)->leftOut.empty()) << one.name;
    }
}

TEST(LeaveOut, WhatWasNotAskedForIsNotLeftOut) {
    PlanRequest request;
    request.size = {48, 48};
    for (const Case& one : cases()) {
        const auto plan = testing::planOf(one.figure(), request);
        for (const LeftOut& out : plan->leftOut) {
            EXPECT_TRUE(std::none_of(plan->featuresNotAsked.begin(), plan->featuresNotAsked.end(), [&](const auto& f) {
                return f.name == ruleOf(out.rule).name;
            })) << one.name;
        }
    }
}

TEST(LeaveOut, WidenedVoxelsAreTheSameNumbers) {
    testing::SmoothScene scene;
    scene.type = VoxelType::uint8;
    scene.falling = true;
    const auto narrow = testing::smoothFigure(scene).volume->data;
    const auto wide = widenedToInt16(*narrow);
    EXPECT_EQ(wide->type(), VoxelType::int16);
    EXPECT_EQ(wide->range(), narrow->range());
    const glm::ivec3 dims = narrow->grid().dims;
    for (int i = 0; i < dims.x * dims.y * dims.z; ++i) {
        const glm::ivec3 voxel(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y));
        ASSERT_EQ(wide->valueAt(voxel), narrow->valueAt(voxel));
    }
}

} // namespace
} // namespace limner
