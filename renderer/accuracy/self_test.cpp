#include "renderer/accuracy/self_test.h"

#include "renderer/accuracy/analytic_scenes.h"
#include "renderer/accuracy/importance_scenes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <utility>

namespace limner::accuracy {

namespace {

/// Of a pixel: pictures are float32, whatever the backend computes in.
constexpr double kPixelUlp = 1.2e-7;
/// Some 50 ulp of a pixel near 1: single precision along a ray of a hundred samples.
constexpr double kSingle = 6e-6;

struct Bound {
    double value;
    std::string reason;
};

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string atStep(const std::string& what, double stepMm) { return what + ", step " + number(stepMm) + " mm"; }

/// The greater of the two, or what is no number of them.
double worse(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

double orderOf(double coarse, double fine) { return std::log2(coarse / fine); }

/// Slope of a straight line through errors at steps that halve, over logarithms.
double fittedOrder(const std::vector<double>& errors) {
    const auto n = static_cast<double>(errors.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double x = -static_cast<double>(i);
        const double y = std::log2(errors[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double waveAt(const glm::dvec3& mm) {
    return std::sin(1.1 * mm.x + 0.3) * std::cos(0.9 * mm.y - 0.2) + 0.5 * std::sin(0.8 * mm.z + 0.7);
}

glm::dvec3 waveGradient(const glm::dvec3& mm) {
    return {1.1 * std::cos(1.1 * mm.x + 0.3) * std::cos(0.9 * mm.y - 0.2),
            -0.9 * std::sin(1.1 * mm.x + 0.3) * std::sin(0.9 * mm.y - 0.2), 0.4 * std::cos(0.8 * mm.z + 0.7)};
}

/// Reads a field off a picture: two planes around a depth leave one sample a ray, which is opaque and has the colour of
/// its value (from black to white over the data's range).
AnalyticScene probe(std::shared_ptr<const Volume> volume, double depthMm, double heightMm, int pixels) {
    const ValueRange range = volume->range();
    AnalyticScene scene{"A6", plainFigure(std::move(volume), viewAlongZ(glm::dvec3(0), heightMm)), {}};
    scene.request.size = {pixels, pixels};
    scene.request.lattice = SampleLattice{100, 0.5, 0}; // longer than the box: the whole slab is one sample
    scene.figure.clip.planes = {{{0, 0, 1}, depthMm + 1e-3}, {{0, 0, -1}, -(depthMm - 1e-3)}};
    Transfer& transfer = scene.figure.layers.front().transfer;
    transfer.nodes = {{range.low, "", glm::dvec3(0)}, {range.high, "", glm::dvec3(1)}};
    transfer.opacity = {{range.low, 1}};
    return scene;
}

class SelfTest {
  public:
    SelfTest(const Backend& backend, Task& task)
        : backend_(backend), task_(task), inDouble_(backend.name() == "reference") {}

    std::vector<SceneReport> run();

  private:
    void constantMedium();
    void linearRamp();
    void earlyTermination();
    void stepInterface();
    void ball();
    void ballsMean();
    void importancePair();
    void risingImportance();
    void interpolation();
    void splineGradient();
    void gaussianBlob();
    void thinSheet();

    [[nodiscard]] RenderPlan planOf(const AnalyticScene& scene) const {
        Task still(task_, done_, done_); // a scene's pictures move no bar
        return *Planner().plan(scene.figure, scene.request, still);
    }
    [[nodiscard]] Picture draw(const RenderPlan& plan) const {
        Task still(task_, done_, done_);
        return backend_.render(plan, {{0, 0}, plan.size}, still).picture;
    }
    [[nodiscard]] Picture draw(const AnalyticScene& scene) const { return draw(planOf(scene)); }

    /// What pixels are rounded to here.
    [[nodiscard]] Bound rounding() const {
        return inDouble_ ? Bound{kPixelUlp, "a pixel is float32"}
                         : Bound{kSingle, "single precision along the ray: 50 ulp"};
    }

    void add(const std::string& scene, const std::string& quantity, double expected, double observed,
             const Bound& bound) {
        addRow({scene, quantity, expected, observed, std::abs(observed - expected), bound.value, bound.reason, false});
    }
    void addAtLeast(const std::string& scene, const std::string& quantity, double least, double observed,
                    const std::string& reason) {
        addRow({scene, quantity, least, observed, observed >= least ? 0 : least - observed, 0, reason, false});
    }
    void addAtMost(const std::string& scene, const std::string& quantity, double observed, const Bound& most) {
        addRow({scene, quantity, 0, observed, observed, most.value, most.reason, false});
    }
    void addRow(SceneReport row) {
        row.passed = row.error <= row.bound; // what is no number does not pass
        rows_.push_back(std::move(row));
    }

    const Backend& backend_;
    Task& task_;
    bool inDouble_;
    double done_ = 0; ///< share of the scenes
    std::vector<SceneReport> rows_;
};

void SelfTest::constantMedium() {
    const ConstantMedium medium;
    for (const double step : {0.0625, 0.3, 1.0, 5.0}) {
        const Picture picture = draw(medium.scene(step));
        const Bound bound = rounding();
        add("A1", atStep("opacity", step), medium.opacity(), picture.pixel(1, 0)[3], bound);
        add("A1", atStep("colour", step), medium.premultiplied(), picture.pixel(1, 0)[0], bound);
    }
}

void SelfTest::linearRamp() {
    const LinearRamp ramp;
    const auto errorAt = [&](double step, double phase) {
        return draw(ramp.scene({step, phase, 0.5})).pixel(0, 0)[0] - ramp.premultiplied();
    };
    const Picture picture = draw(ramp.scene({0.01, 0.5, 0.5}));
    add("A2", atStep("opacity", 0.01), ramp.opacity(), picture.pixel(0, 0)[3], rounding());
    // The midpoint rule's own error: (s0 h)^2 / 24 of the curve at most.
    add("A2", atStep("colour", 0.01), ramp.premultiplied(), picture.pixel(0, 0)[0],
        {rounding().value + std::pow(ramp.extinctionPerMm * 0.01, 2) / 24, "error of the midpoint rule, (s h)^2 / 24"});
    double coarse = errorAt(0.5, 0.5);
    for (double step = 0.25; step > 1.0 / 64; step /= 2) {
        const double fine = errorAt(step, 0.5);
        add("A2", atStep("order of midpoints", step), 2, orderOf(std::abs(coarse), std::abs(fine)),
            {0.15, "smooth along the ray: accuracy 1.6"});
        coarse = fine;
    }
    add("A2", atStep("order of left ends", 1.0 / 64), 1,
        orderOf(std::abs(errorAt(1.0 / 32, 0)), std::abs(errorAt(1.0 / 64, 0))), {0.15, "no midpoints: order 1"});
}

void SelfTest::earlyTermination() {
    const LinearRamp ramp{30}; // dense enough that every threshold ends the ray
    AnalyticScene scene = ramp.scene({1.0 / 200, 0.5, 0.5});
    const Picture full = draw(scene);
    for (const double threshold : {1e-4, 1e-3, 1e-2, 5e-2}) {
        scene.figure.quality.earlyTermination = threshold;
        const Picture cut = draw(scene);
        double most = 0;
        for (std::size_t i = 0; i < cut.rgba().size(); ++i) {
            most = worse(most, std::abs(static_cast<double>(cut.rgba()[i]) - full.rgba()[i]));
        }
        addAtMost("A2", "rays that end at a transmittance of " + number(threshold), most,
                  {threshold + kPixelUlp, "what is left behind is no more than the threshold"});
    }
}

void SelfTest::stepInterface() {
    const StepInterface interface;
    constexpr int phases = 8;
    std::vector<double> envelope;
    for (double step = 1.0 / 8; step >= 1.0 / 128; step /= 2) {
        double worst = 0;
        for (int phase = 0; phase < phases; ++phase) {
            const Picture picture = draw(interface.scene({step, (phase + 0.5) / phases, 0.5}));
            worst = worse(worst, std::abs(picture.pixel(0, 0)[0] - interface.premultiplied()));
        }
        addAtMost("A3", atStep("greatest error over 8 phases", step), worst,
                  {6.38 * step, "envelope of the saw tooth, 6.38 h"});
        envelope.push_back(worst);
    }
    addAtLeast("A3", "order of the envelope", 0.9, fittedOrder(envelope), "a jump along the ray: accuracy 1.6");
}

void SelfTest::ball() {
    const Ball ball;
    const double step = ball.spacingMm / 20;
    for (const double pixelMm : {0.2, 0.33}) {
        AnalyticScene scene = ball.scene(step, 1);
        scene.request.size = {13, 1}; // a strip through the middle, a pixel's middle on it
        scene.figure.camera.heightMm = pixelMm;
        const Picture picture = draw(scene);
        for (const int pixel : pixelMm < 0.3 ? std::vector<int>{6, 9, 10} : std::vector<int>{9}) {
            const double impact = (pixel - 6) * pixelMm;
            const double cosine = std::sqrt(1 - impact * impact);
            // Each end of the chord is found to within a step, the trilinear distance field is short by at most
            // spacing^2 / (4 r), and tables may smear a step over 1/4096 of the range; over the cosine of incidence.
            const double shift = ball.spacingMm * ball.spacingMm / (4 * cosine);
            const double table = inDouble_ ? 0 : 3.0 / 4096 / cosine;
            const double slope = ball.extinctionPerMm * (1 - ball.opacity(impact));
            add("A4", "opacity at " + number(impact) + " of the radius", ball.opacity(impact),
                picture.pixel(pixel, 0)[3],
                {2 * slope * (step + shift + table) + kSingle, "a step and the trilinear field's error at either end"});
        }
    }
}

void SelfTest::ballsMean() {
    const Ball ball;
    constexpr int pixels = 40;
    const Picture picture = draw(ball.scene(ball.spacingMm / 5, pixels));
    double mean = 0;
    for (std::size_t i = 3; i < picture.rgba().size(); i += 4) {
        mean += picture.rgba()[i] / (pixels * pixels) * 4 / std::numbers::pi;
    }
    add("A4", "mean opacity over the disc", ball.meanOpacity(), mean,
        {0.005, "the rim's staircase at 40 pixels, and a fifth of a voxel a step"});
}

void SelfTest::importancePair() {
    for (const ImportanceRow& row : importanceTable()) {
        const glm::dvec3 expected = row.pair.weights();
        const std::string at = ", a0 = " + number(row.pair.frontOpacity) + ", D = " + number(row.pair.importance) +
                               ", tau = " + number(row.pair.depth);
        glm::dvec3 observed = expected;
        for (const int steps : {2, 14, 50}) { // the gap is whole steps, too
            const Picture picture = draw(row.pair.scene(steps));
            for (int c = 0; c < 3; ++c) {
                const double drawn = picture.pixel(0, 0)[c < 2 ? c : 3];
                const double off = std::abs(observed[c] - expected[c]);
                observed[c] = worse(off, std::abs(drawn - expected[c])) == off ? observed[c] : drawn;
            }
        }
        const Bound bound = inDouble_ ? rounding() : Bound{2e-5, "single precision of e^I over fifty samples"};
        add("A5", "share of what is in front" + at, expected.x, observed.x, bound);
        add("A5", "share of what matters" + at, expected.y, observed.y, bound);
        add("A5", "opacity" + at, expected.z, observed.z, bound);
    }
}

void SelfTest::risingImportance() {
    const RisingImportance rising;
    std::vector<double> errors;
    for (double step = 0.25; step >= 1.0 / 256; step /= 2) {
        errors.push_back(std::abs(draw(rising.scene(step)).pixel(0, 0)[0] - rising.premultiplied()));
    }
    addAtLeast("A5", "order of rising importance", 1.7, fittedOrder(errors), "smooth importance: accuracy 1.6");
    addAtMost("A5", atStep("error of rising importance", 1.0 / 256), errors.back(),
              {rounding().value + std::pow(rising.slope / 256, 2) / 24, "error of the midpoint rule, (g h)^2 / 24"});
}

/// Root of the mean square of `error` over a picture's pixels.
double meanSquare(const AnalyticScene& scene, const Picture& picture,
                  const std::function<double(const glm::dvec2&, const float*)>& error) {
    double sum = 0;
    for (int y = 0; y < picture.size().y; ++y) {
        for (int x = 0; x < picture.size().x; ++x) {
            sum += std::pow(error(pixelCentreMm(scene, {x, y}), picture.pixel(x, y)), 2);
        }
    }
    return std::sqrt(sum / (picture.size().x * picture.size().y));
}

void SelfTest::interpolation() {
    const auto errorOf = [&](const AnalyticScene& scene, double depth, const FieldMm& field) {
        const ValueRange range = scene.figure.volume->data->range();
        return meanSquare(scene, draw(scene), [&](const glm::dvec2& mm, const float* pixel) {
            return range.low + (range.high - range.low) * pixel[0] - field(glm::dvec3(mm, depth));
        });
    };
    const MarschnerLobb signal;
    const auto linearError = [&](int voxels) {
        Grid grid = centredGrid(voxels, 2.0 / (voxels - 1));
        grid.dims.z = 8; // slices enough around the depth
        grid.originMm.z = -3.5 * grid.spacingMm.z;
        constexpr double depth = 0.0371; // between slices
        const auto field = [&](const glm::dvec3& mm) { return signal.value(mm); };
        return errorOf(probe(sampleField(grid, field), depth, 1.3, 48), depth, field);
    };
    add("A6", "order of trilinear values, 81 to 161 voxels", 2, orderOf(linearError(81), linearError(161)),
        {0.2, "trilinear: accuracy 1.6"});
    const auto cubicError = [&](int voxels) {
        constexpr double depth = 0.137;
        AnalyticScene scene = probe(sampleField(centredGrid(voxels, 12.0 / (voxels - 1)), waveAt), depth, 3.1, 24);
        scene.figure.quality.interpolation = Interpolation::tricubic;
        return errorOf(scene, depth, waveAt);
    };
    add("A6", "order of tricubic values, 31 to 61 voxels", 4, orderOf(cubicError(31), cubicError(61)),
        {0.3, "the cubic B-spline through the voxels: accuracy 1.6"});
}

void SelfTest::splineGradient() {
    // The colour is the gradient's magnitude at the coarser grid's voxels, one pixel each.
    const auto errorOf = [&](int voxels) {
        const double spacing = 12.0 / (voxels - 1);
        AnalyticScene scene = probe(sampleField(centredGrid(voxels, spacing), waveAt), 0, 9 * 0.4, 9);
        scene.figure.quality.gradient = GradientEstimator::bspline;
        Transfer& transfer = scene.figure.layers.front().transfer;
        transfer.axis = "gradient";
        transfer.nodes = {{0, "", glm::dvec3(0)}, {1, "", glm::dvec3(1)}};
        transfer.opacity = {{0, 1}};
        RenderPlan plan = planOf(scene);
        plan.gradientMax = 2; // above every gradient of the field, the same for both
        plan.gradientFloor = 0;
        return meanSquare(scene, draw(plan), [](const glm::dvec2& mm, const float* pixel) {
            return 2 * pixel[0] - glm::length(waveGradient(glm::dvec3(mm, 0)));
        });
    };
    add("A6", "order of B-spline gradients at voxels, 31 to 61 voxels", 4, orderOf(errorOf(31), errorOf(61)),
        {0.3, "the cubic B-spline at its knots: accuracy 1.6"});
}

void SelfTest::gaussianBlob() {
    const GaussianBlob blob;
    AnalyticScene scene = blob.scene(blob.spacingMm); // samples fall on the voxels
    scene.request.size = {scene.request.size.x, 1};
    scene.figure.camera.heightMm = blob.spacingMm;
    const Picture picture = draw(scene);
    for (const int offset : {0, 2, 4}) {
        const double impact = offset * blob.spacingMm;
        add("A7", "opacity at " + number(impact) + " mm", blob.opacity(impact),
            picture.pixel(scene.request.size.x / 2 + offset, 0)[3],
            inDouble_ ? Bound{3e-7, "voxels are float32, over thirty samples"} : rounding());
    }
}

void SelfTest::thinSheet() {
    const ThinSheet sheet;
    const double step = sheet.thicknessMm / 3; // whole steps end on its faces
    add("A8", atStep("colour", step), sheet.premultiplied(), draw(sheet.scene(step)).pixel(0, 0)[0],
        inDouble_ ? Bound{1e-6, "a pixel is float32, and so are the voxels that say where the sheet is"}
                  : Bound{2e-5, "single precision of e^I over a thousand samples"});
    for (const double coarse : {1.0 / 128, 1.0 / 32}) {
        add("A8", atStep("colour where no sample meets the sheet", coarse), 0, draw(sheet.scene(coarse)).pixel(0, 0)[0],
            {0, "what is not sampled is not seen"});
    }
}

std::vector<SceneReport> SelfTest::run() {
    using Scene = void (SelfTest::*)();
    const Scene scenes[] = {
        &SelfTest::constantMedium, &SelfTest::linearRamp,     &SelfTest::earlyTermination, &SelfTest::stepInterface,
        &SelfTest::ball,           &SelfTest::ballsMean,      &SelfTest::importancePair,   &SelfTest::risingImportance,
        &SelfTest::interpolation,  &SelfTest::splineGradient, &SelfTest::gaussianBlob,     &SelfTest::thinSheet};
    task_.beginPhase("Drawing scenes of known pictures");
    for (const Scene scene : scenes) {
        task_.throwIfCancelled();
        (this->*scene)();
        done_ += 1.0 / std::size(scenes);
        task_.progress(done_);
    }
    return rows_;
}

} // namespace

std::vector<SceneReport> selfTest(const Backend& backend, Task& task) { return SelfTest(backend, task).run(); }

} // namespace limner::accuracy
