#include "core/figure/presets.h"
#include "core/optics/contour.h"
#include "core/volume/import.h"
#include "renderer/accuracy/analytic_scenes.h"
#include "renderer/reference/field.h"
#include "renderer/reference/layer_optics.h"
#include "support/rendering.h"
#include "support/test_data.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

// How far the contours of the two measures of curvature speckle a skull's smooth vault on real scans, from the left.

namespace limner {
namespace {

constexpr int kPixels = 300;

struct Scan {
    const char* file;
    double bone;      ///< its surface's value
    double vaultFrom; ///< slice above which the skull is smooth
};

/// Of each pixel, NaN where it shows nothing.
struct Measures {
    std::vector<double> bend;
    std::vector<double> turn;
    std::vector<double> facing;
    std::vector<double> slice;
    double thicknessMm = 0;
};

/// Where a ray first meets a value.
std::optional<double> firstHit(const RenderPlan& plan, const reference::Ray& ray, double value) {
    const double stepMm = 0.4 * plan.referenceLengthMm;
    const auto inside = [&](double mm) { return reference::valueAt(plan, ray.positionVoxel(mm)) >= value; };
    for (double mm = ray.visible.inMm + stepMm; mm < ray.visible.outMm; mm += stepMm) {
        if (inside(mm)) {
            double before = mm - stepMm;
            for (int halving = 0; halving < 10; ++halving) {
                const double middle = 0.5 * (before + mm);
                (inside(middle) ? mm : before) = middle;
            }
            return mm;
        }
    }
    return std::nullopt;
}

Measures measure(const Scan& scan, const std::shared_ptr<const Volume>& volume) {
    Figure figure = accuracy::plainFigure(volume, standardView(*volume, StandardView::left, 0));
    figure.camera.targetMm.z += 0.25 * volume->grid().sizeMm().z; // the vault
    figure.camera.heightMm = 0.4 * kPixels;                       // some 0.4 voxels a pixel
    figure.output.heightMm = figure.camera.heightMm;
    Layer& layer = figure.layers.front();
    layer.transfer.nodes = {{scan.bone, "", glm::dvec3(1)}};
    layer.transfer.opacity = {{scan.bone, 0}, {scan.bone, 1}};
    layer.contours.emplace();
    Layer byNormals = layer;
    byNormals.contours->curvature = CurvatureEstimator::normals;
    figure.layers.push_back(byNormals);
    PlanRequest request;
    request.size = {kPixels, kPixels};
    const auto plan = testing::planOf(figure, request);
    const std::vector<double> nothing(kPixels * kPixels, std::numeric_limits<double>::quiet_NaN());
    Measures measures{nothing, nothing, nothing, nothing, plan->layers.front().contours->thicknessMm};
    tbb::parallel_for(0, kPixels * kPixels, [&](int i) {
        const auto ray = reference::rayThrough(*plan, {i % kPixels + 0.5, i / kPixels + 0.5});
        const auto hit = ray ? firstHit(*plan, *ray, scan.bone) : std::nullopt;
        if (!hit) {
            return;
        }
        const auto facts = reference::sampleFacts(*plan, *ray, {*hit, 0}, scan.bone);
        const auto at = static_cast<std::size_t>(i);
        measures.bend[at] = facts.surface.bend;
        measures.turn[at] = facts.turns.front().second;
        measures.facing[at] = std::abs(facts.surface.normalRay.z);
        measures.slice[at] = ray->positionVoxel(*hit).z;
    });
    return measures;
}

struct Speckle {
    double onVault = 0;  ///< share of the vault's pixels that are contours
    double isolated = 0; ///< share of the vault's pixels that are contours with at most one neighbour
};

Speckle speckleOf(const Measures& measures, const std::vector<double>& curvature, double vaultFrom) {
    const auto drawn = [&](std::size_t i) {
        return measures.facing[i] <= optics::contourWidth(measures.thicknessMm * curvature[i]);
    };
    double vault = 0, isolated = 0, onVault = 0;
    for (int p = 0; p < kPixels * kPixels; ++p) {
        const int x = p % kPixels;
        const int y = p / kPixels;
        const auto i = static_cast<std::size_t>(p);
        if (x == 0 || y == 0 || x == kPixels - 1 || y == kPixels - 1 || !(measures.slice[i] > vaultFrom)) {
            continue;
        }
        double sum = 0;
        int neighbours = 0;
        for (int k = 0; k < 9; ++k) {
            const auto j = static_cast<std::size_t>(p + k % 3 - 1 + (k / 3 - 1) * kPixels);
            sum += curvature[j];
            neighbours += j != i && drawn(j) ? 1 : 0;
        }
        if (!std::isfinite(sum)) {
            continue; // at the rim
        }
        ++vault;
        onVault += drawn(i) ? 1 : 0;
        isolated += drawn(i) && neighbours <= 1 ? 1 : 0;
    }
    EXPECT_GT(vault, 10000);
    return {onVault / vault, isolated / vault};
}

TEST(CurvatureOnScans, SpecklesLessByTheHessianThanByNormals) {
    for (const Scan& scan : {Scan{"volumes/cthead_unc.nrrd", 1250, 60}, Scan{"volumes/cranium_ct.nrrd", 250, 60}}) {
        const auto path = testing::testData(scan.file);
        if (!path) {
            continue;
        }
        Task task;
        const Measures measures = measure(scan, importVolume(*path, {}, task).volume);
        const Speckle hessian = speckleOf(measures, measures.bend, scan.vaultFrom);
        const Speckle normals = speckleOf(measures, measures.turn, scan.vaultFrom);
        EXPECT_LT(hessian.isolated, 0.6 * normals.isolated) << scan.file;
        EXPECT_LT(hessian.onVault, 0.3 * normals.onVault) << scan.file;
    }
}

} // namespace
} // namespace limner
