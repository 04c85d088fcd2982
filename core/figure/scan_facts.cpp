#include "core/figure/scan_facts.h"

#include "core/volume/bit_grid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

namespace limner {

namespace {

constexpr int kBins = 1024; // an 11-bit scan's values two by two; classes lie tens of bins apart

double shareAbove(const Histogram& h, double value) {
    double above = 0;
    double total = 0;
    for (std::size_t i = 0; i < h.counts.size(); ++i) {
        const auto count = static_cast<double>(h.counts[i]);
        total += count;
        above += h.binCentre(i) > value ? count : 0;
    }
    return total > 0 ? above / total : 0;
}

/// Finds the offset of Hounsfield units: air and soft tissue are peaks about 1000 to 1100 apart.
std::optional<double> huIntercept(const Volume& volume, const Histogram& h) {
    if (volume.contents().unit == "HU" || (volume.contents().modality == Modality::ct && h.range.low < -200)) {
        return 0;
    }
    if (volume.type() != VoxelType::int16 || h.range.high < 1300 || h.range.high > 70000) {
        return std::nullopt;
    }
    const std::vector<double> peaks = h.peaks(6);
    for (const double air : peaks) {
        for (const double tissue : peaks) {
            // Fat to muscle lies at -100..80 HU; air reads -1000, or a little more beside matter.
            if (tissue - air > 880 && tissue - air < 1110 && air < h.range.low + 200) {
                return std::abs(air - 0.0) < 100 ? 1024 : std::round(air) + 1000;
            }
        }
    }
    return std::nullopt;
}

BitGrid coarseMatter(const Volume& volume, double threshold, int stride) {
    const glm::ivec3 dims = (volume.grid().dims + stride - 1) / stride;
    BitGrid matter(dims);
    tbb::parallel_for(0, dims.z, [&](int z) {
        for (int y = 0; y < dims.y; ++y) {
            for (int x = 0; x < dims.x; ++x) {
                if (volume.valueAt(glm::ivec3(x, y, z) * stride) > threshold) {
                    matter.set({x, y, z});
                }
            }
        }
    });
    return matter;
}

/// Shape of the largest body of matter, on a lattice of at most about 128 samples a side.
struct Body {
    glm::dvec3 sizeMm{0}; ///< of its box
    double filled = 0;    ///< share of its box
    double thick = 0; ///< share of it that is left when three samples are taken off all around: branches leave nothing
    double share = 0; ///< of all matter
};

Body measureBody(const Volume& volume, double threshold) {
    const int stride =
        std::max(1, glm::max(glm::max(volume.grid().dims.x, volume.grid().dims.y), volume.grid().dims.z) / 128);
    const BitGrid matter = coarseMatter(volume, threshold, stride);
    const Components islands(matter, Connectivity::corners);
    Body body;
    if (islands.list().empty()) {
        return body;
    }
    const Component& c = islands.list()[0];
    const glm::dvec3 extent(c.high - c.low + 1);
    body.sizeMm = extent * static_cast<double>(stride) * volume.grid().spacingMm;
    body.filled = static_cast<double>(c.voxels) / (extent.x * extent.y * extent.z);
    body.share = static_cast<double>(c.voxels) / static_cast<double>(matter.count());
    std::vector<bool> largest(islands.list().size());
    largest[0] = true;
    const BitGrid core = eroded(islands.select(largest), glm::dvec3(1), 3);
    body.thick = static_cast<double>(core.count()) / static_cast<double>(c.voxels);
    return body;
}

/// Share of strong gradients that lie along one of the grid's axes to within 8 degrees: made parts are cut along them,
/// grown things are round (a sphere has 3 % there).
double axialShare(const Volume& volume, double threshold) {
    const glm::ivec3 dims = volume.grid().dims;
    const int stride = std::max(1, std::min({dims.x, dims.y, dims.z}) / 48);
    const glm::ivec3 n = dims / stride;
    constexpr double kCosine = 0.990; // of 8 degrees
    struct Count {
        double axial = 0, strong = 0;
    };
    std::vector<Count> counts(static_cast<std::size_t>(n.z));
    const double strong = 0.15 * (volume.range().high - volume.range().low); // per two voxels: a clear boundary
    tbb::parallel_for(0, n.z, [&](int z) {
        Count& count = counts[static_cast<std::size_t>(z)];
        for (int y = 1; y + 1 < n.y; ++y) {
            for (int x = 1; x + 1 < n.x; ++x) {
                const glm::ivec3 v = glm::ivec3(x, y, z) * stride;
                glm::dvec3 g;
                for (int axis = 0; axis < 3; ++axis) {
                    glm::ivec3 step(0);
                    step[axis] = 1;
                    g[axis] = volume.valueAt(v + step) - volume.valueAt(v - step);
                }
                const double length = glm::length(g);
                if (length > strong && std::abs(volume.valueAt(v) - threshold) < length) {
                    count.strong += 1;
                    const glm::dvec3 a = glm::abs(g);
                    count.axial += std::max({a.x, a.y, a.z}) > kCosine * length ? 1 : 0;
                }
            }
        }
    });
    Count sum;
    for (const Count& count : counts) {
        sum.axial += count.axial;
        sum.strong += count.strong;
    }
    return sum.strong > 0 ? sum.axial / sum.strong : 0;
}

/// Share of the voxels with matter in them that sit in the last bin: a window cuts bright tissue off.
bool isWindowed(const ScanFacts& facts) {
    const auto& counts = facts.histogram.counts;
    const auto last = static_cast<double>(counts.back());
    const double total = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
    double before = 0; // the next populated bins below; 8-bit data fill every fourth
    constexpr std::size_t kNear = 24;
    for (std::size_t i = counts.size() - kNear; i + 1 < counts.size(); ++i) {
        before = std::max(before, static_cast<double>(counts[i]));
    }
    return last > 3 * before && last > 2e-4 * total;
}

ScanKind kindOfCt(const Volume& volume, const ScanFacts& facts, const Body& body, std::string& why) {
    const double offset = *facts.huIntercept;
    const glm::dvec3 size = volume.grid().sizeMm();
    const double thinnest = std::min({body.sizeMm.x, body.sizeMm.y, body.sizeMm.z});
    const double widest = std::max({body.sizeMm.x, body.sizeMm.y, body.sizeMm.z});
    why = "the values are Hounsfield units";
    if (thinnest < 0.25 * widest && thinnest < 80) {
        return ScanKind::ctSlab;
    }
    // Contrast medium: far more at 200 to 600 HU than bone has beside its own dense part.
    const double blood = shareAbove(facts.histogram, 200 + offset) - shareAbove(facts.histogram, 600 + offset);
    const double bone = shareAbove(facts.histogram, 600 + offset);
    const double matter = shareAbove(facts.histogram, -300 + offset);
    const bool head = std::min(body.sizeMm.x, body.sizeMm.y) < 215 && widest < 330 && size.x < 300;
    if (blood > 0.08 * matter && blood > 4 * bone) {
        return ScanKind::ctContrast;
    }
    return head ? ScanKind::ctHead : ScanKind::ctBody;
}

ScanKind kindOf(const Volume& volume, ScanFacts& facts) {
    const Volume::Contents& contents = volume.contents();
    const glm::ivec3 dims = contents.grid.dims;
    facts.why.clear();
    if (!(contents.range.high > contents.range.low)) {
        return ScanKind::constant;
    }
    if (dims.x == 1 || dims.y == 1 || dims.z == 1) {
        return ScanKind::slice;
    }
    if (contents.modality == Modality::labels || looksLabelled(volume)) {
        facts.why = "most voxels equal their neighbours";
        return ScanKind::labels;
    }
    const double outer = facts.huIntercept ? *facts.huIntercept - 300 : facts.otsu;
    const Body body = measureBody(volume, outer);
    if (facts.huIntercept) {
        return kindOfCt(volume, facts, body, facts.why);
    }
    const double background = facts.histogram.percentile(0.5) - contents.range.low;
    const bool empty = background < 0.06 * (contents.range.high - contents.range.low);
    const double widest = std::max({body.sizeMm.x, body.sizeMm.y, body.sizeMm.z});
    constexpr double kTrunkMm = 280; // wider than any head or specimen in a scanner of its size
    if (isWindowed(facts) && contents.modality != Modality::mr && widest > kTrunkMm) {
        facts.why = "bright tissue is cut off at the highest value";
        return ScanKind::ctWindowed;
    }
    // Branches fill little of their box and nothing is left of them once three samples are taken off all around.
    if (empty && facts.matterShare < 0.06 && body.thick < 0.08 && body.filled < 0.06) {
        facts.why = "the volume is nearly empty and what is in it is thin";
        return ScanKind::vessels;
    }
    constexpr double kFlatFaces = 0.22; // seven times a sphere's share
    if (const double axial = axialShare(volume, facts.otsu); contents.modality != Modality::mr && axial > kFlatFaces) {
        facts.why = std::to_string(std::lround(100 * axial)) + " % of its faces lie along the grid";
        return ScanKind::machined;
    }
    const glm::dvec3 size = body.sizeMm;
    const bool headSized = std::min({size.x, size.y, size.z}) > 85 && std::max({size.x, size.y, size.z}) > 150 &&
                           std::max({size.x, size.y, size.z}) < 300;
    if (contents.modality == Modality::mr || (headSized && body.filled > 0.3)) {
        facts.why = contents.modality == Modality::mr ? "the file says so" : "by its size and density";
        return ScanKind::mrHead;
    }
    facts.why = "no modality is given and its values fit none";
    return ScanKind::specimen;
}

std::optional<double> number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<double> simpleAnchor(const ScanFacts& facts, std::string_view text) {
    if (text == "otsu")
        return facts.otsu;
    if (text == "otsu:1")
        return facts.otsuLower;
    if (text == "otsu:2")
        return facts.otsuUpper;
    if (text == "low")
        return facts.histogram.range.low;
    if (text == "high")
        return facts.histogram.range.high;
    if (text.starts_with("hu:")) {
        const auto hu = number(text.substr(3));
        return hu && facts.huIntercept ? std::optional(*hu + *facts.huIntercept) : std::nullopt;
    }
    if (text.starts_with('p') || text.starts_with('m')) {
        const auto fraction = number(text.substr(1));
        if (!fraction || *fraction < 0 || *fraction > 1)
            return std::nullopt;
        const double share = text.starts_with('m') ? 1 - facts.matterShare * (1 - *fraction) : *fraction;
        return facts.histogram.percentile(share);
    }
    return std::nullopt;
}

} // namespace

bool looksLabelled(const Volume& volume) {
    const Volume::Contents& contents = volume.contents();
    constexpr double kMostLabels = 4096;
    if (contents.modality != Modality::unknown || contents.type == VoxelType::float32 || contents.slope != 1 ||
        contents.range.low < 0 || contents.range.high > kMostLabels) {
        return false;
    }
    const glm::ivec3 dims = contents.grid.dims;
    const int stride = std::max(1, glm::max(glm::max(dims.x, dims.y), dims.z) / 96);
    double matter = 0;
    double flat = 0;
    for (int z = 0; z < dims.z; z += stride) {
        for (int y = 0; y < dims.y; y += stride) {
            for (int x = 0; x < dims.x; x += stride) {
                const glm::ivec3 v(x, y, z);
                const double value = volume.storedAt(v);
                if (volume.valueFromStored(value) <= contents.range.low) {
                    continue;
                }
                matter += 1;
                bool equal = true;
                for (int axis = 0; axis < 3; ++axis) {
                    glm::ivec3 step(0);
                    step[axis] = 1;
                    equal = equal && volume.storedAt(v + step) == value && volume.storedAt(v - step) == value;
                }
                flat += equal ? 1 : 0;
            }
        }
    }
    constexpr double kFlat = 0.4; // 116 regions of a brain have about 0.6, smoothed and noisy scans below 0.2
    return matter > 0 && flat > kFlat * matter;
}

ScanFacts examineScan(const Volume& volume) {
    ScanFacts facts;
    facts.histogram = computeHistogram(volume, kBins);
    facts.otsu = facts.histogram.otsu();
    const auto [lower, upper] = facts.histogram.otsuOfThree();
    facts.otsuLower = lower;
    facts.otsuUpper = upper;
    facts.matterShare = shareAbove(facts.histogram, facts.otsu);
    if (volume.contents().modality != Modality::mr && volume.contents().modality != Modality::labels) {
        facts.huIntercept = huIntercept(volume, facts.histogram);
    }
    facts.kind = kindOf(volume, facts);
    return facts;
}

std::optional<double> resolveAnchor(const ScanFacts& facts, std::string_view text) {
    while (!text.empty()) {
        const std::size_t bar = text.find('|');
        const std::string_view one = text.substr(0, bar);
        text = bar == std::string_view::npos ? std::string_view() : text.substr(bar + 1);
        const std::size_t tilde = one.find('~');
        if (tilde == std::string_view::npos) {
            if (const auto value = simpleAnchor(facts, one))
                return value;
            continue;
        }
        const std::size_t colon = one.rfind(':');
        if (colon == std::string_view::npos || colon < tilde)
            continue;
        const auto from = simpleAnchor(facts, one.substr(0, tilde));
        const auto to = simpleAnchor(facts, one.substr(tilde + 1, colon - tilde - 1));
        const auto share = number(one.substr(colon + 1));
        if (from && to && share)
            return *from + *share * (*to - *from);
    }
    return std::nullopt;
}

} // namespace limner
