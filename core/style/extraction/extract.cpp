#include "core/style/extraction/extract.h"

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/style/extraction/disk_holes.h"
#include "core/style/extraction/find.h"
#include "core/style/extraction/gather.h"
#include "core/style/extraction/normals.h"
#include "core/style/extraction/paper.h"
#include "core/style/extraction/texture_apart.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace limner {
namespace {

constexpr int kLongest = 1024;           ///< of a cut: its disk has more pixels than a sphere of 512 has texels
constexpr std::size_t kLeastVotes = 100; ///< pixels: fewer are a spot, not a shaded form
constexpr float kLeastTone = 0.03F;      ///< between patches of the disk: eight steps of 256
constexpr double kDegree = 3.14159265358979323846 / 180;

[[noreturn]] void fail(const Artwork& artwork, const std::string& why, const std::string& remedy) {
    throw Error(ErrorKind::badInput, {"cannot take a style", artwork.file().string(), why, remedy});
}

struct Box {
    glm::dvec2 low{0, 0};
    glm::dvec2 high{0, 0};
};

Box boxOf(const Ellipse& ellipse) {
    const double c = std::cos(ellipse.degrees * kDegree);
    const double s = std::sin(ellipse.degrees * kDegree);
    const glm::dvec2 half(std::hypot(ellipse.semiAxes.x * c, ellipse.semiAxes.y * s),
                          std::hypot(ellipse.semiAxes.x * s, ellipse.semiAxes.y * c));
    return {ellipse.centre - half, ellipse.centre + half};
}

/// Of the mask's "yes", on the artwork; empty where there is none.
std::optional<Box> boxOf(const Mask& mask, const Artwork& artwork) {
    glm::dvec2 low(mask.width, mask.height);
    glm::dvec2 high(0, 0);
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            if (mask.has(x, y)) {
                low = glm::min(low, glm::dvec2(x, y));
                high = glm::max(high, glm::dvec2(x + 1, y + 1));
            }
        }
    }
    if (high.x <= low.x) {
        return std::nullopt;
    }
    const glm::dvec2 scale(static_cast<double>(artwork.width()) / mask.width,
                           static_cast<double>(artwork.height()) / mask.height);
    return Box{low * scale, high * scale};
}

/// Pixels of the artwork around a box: a tenth more, so that edges are seen from both sides.
ArtRect around(const Box& box) {
    const glm::dvec2 margin = 0.1 * (box.high - box.low) + 2.0;
    const glm::dvec2 low = glm::floor(box.low - margin);
    const glm::dvec2 size = glm::ceil(box.high + margin) - low;
    return {static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(size.x), static_cast<int>(size.y)};
}

void checkEllipse(const Artwork& artwork, const Ellipse& ellipse, Task& task) {
    const std::array<double, 5> numbers{ellipse.centre.x, ellipse.centre.y, ellipse.semiAxes.x, ellipse.semiAxes.y,
                                        ellipse.degrees};
    // A million pixels: beyond any scan, and safe to turn into whole numbers.
    const bool sound = std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::abs(v) < 1e6; });
    if (!sound || ellipse.semiAxes.x <= 0 || ellipse.semiAxes.y <= 0) {
        fail(artwork, "an ellipse with impossible numbers", "give a centre and radii in pixels of the artwork");
    }
    const Box box = boxOf(ellipse);
    const glm::dvec2 size(artwork.width(), artwork.height());
    const glm::dvec2 seen = glm::max(glm::min(box.high, size) - glm::max(box.low, glm::dvec2(0, 0)), glm::dvec2(0, 0));
    const double share = seen.x * seen.y / ((box.high.x - box.low.x) * (box.high.y - box.low.y));
    if (share < 0.5) {
        fail(artwork,
             share <= 0 ? "the outline lies outside the scan" : "more than half of the outline lies outside the scan",
             "the scan is " + std::to_string(artwork.width()) + " x " + std::to_string(artwork.height()) +
                 " pixels; place the outline on it");
    }
    if (share < 0.999) {
        task.warn("part of the outline lies outside the scan; directions that are seen only there are filled in");
    }
}

/// A mask over the whole artwork at one of the cut's pixels.
bool hasAt(const Mask& mask, const Artwork& artwork, glm::dvec2 place) {
    const int x = static_cast<int>(place.x / artwork.width() * mask.width);
    const int y = static_cast<int>(place.y / artwork.height() * mask.height);
    return x >= 0 && y >= 0 && x < mask.width && y < mask.height && mask.has(x, y);
}

Mask overCut(const Mask& whole, const Artwork& artwork, const ArtCut& cut) {
    Mask mask{cut.picture.width, cut.picture.height, {}};
    mask.values.resize(cut.picture.pixels.size());
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            mask.values[mask.offset(x, y)] = hasAt(whole, artwork, cut.toArtwork({x + 0.5, y + 0.5})) ? 255 : 0;
        }
    }
    return mask;
}

/// What is looked at: the cut, the normals over it, and which of its pixels count.
struct Looked {
    ArtCut cut;
    NormalField normals;
    Mask pixels;
};

/// Pixels of the outline show the ground too: one pixel of the form's border does not count.
void dropBorder(const NormalField& normals, Mask& pixels) {
    cv::Mat form(normals.height, normals.width, CV_8U);
    for (std::size_t i = 0; i < normals.normals.size(); ++i) {
        form.data[i] = std::isfinite(normals.normals[i].x) ? 255 : 0;
    }
    cv::Mat inner;
    cv::erode(form, inner, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}), {-1, -1}, 1, cv::BORDER_CONSTANT,
              cv::Scalar(255));
    for (std::size_t i = 0; i < pixels.values.size(); ++i) {
        pixels.values[i] = inner.data[i] != 0 ? pixels.values[i] : 0;
    }
}

/// Letters and lines over the cut, found among their surroundings: a word that the form cuts off is no row of letters
/// any more, and a line's end no line.
Mask letteringOver(const Artwork& artwork, const ArtCut& cut, const Box& box, Task& task) {
    const glm::dvec2 margin = 0.5 * (box.high - box.low);
    const ArtCut wider = artwork.cut(around({box.low - margin, box.high + margin}), kLongest, task);
    const Mask found = findLettering(wider);
    Mask mask{cut.picture.width, cut.picture.height, std::vector<std::uint8_t>(cut.picture.pixels.size(), 0)};
    for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
            const glm::dvec2 place = glm::floor(wider.toCut(cut.toArtwork({x + 0.5, y + 0.5})));
            const bool within = place.x >= 0 && place.y >= 0 && place.x < found.width && place.y < found.height;
            const bool letter = within && found.has(static_cast<int>(place.x), static_cast<int>(place.y));
            mask.values[mask.offset(x, y)] = letter ? 255 : 0;
        }
    }
    return mask;
}

Looked look(const Artwork& artwork, const ExtractionRequest& request, Task& task) {
    const auto* ellipse = std::get_if<Ellipse>(&request.form);
    const auto* region = std::get_if<FormRegion>(&request.form);
    if (ellipse != nullptr) {
        checkEllipse(artwork, *ellipse, task);
    }
    const std::optional<Box> box = ellipse != nullptr ? boxOf(*ellipse) : boxOf(region->mask, artwork);
    if (!box) {
        fail(artwork, "the region is empty", "draw around a shaded form");
    }
    Looked looked;
    looked.cut = artwork.cut(around(*box), kLongest, task);
    const ArtPicture& picture = looked.cut.picture;
    looked.normals = ellipse != nullptr
                         ? ellipseNormals(looked.cut, *ellipse)
                         : formNormals(looked.cut, overCut(region->mask, artwork, looked.cut), region->marks, task);
    looked.pixels = {picture.width, picture.height, std::vector<std::uint8_t>(picture.pixels.size(), 0)};
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const bool opaque = picture.pixels[i].a >= 0.5F;
        looked.pixels.values[i] = opaque && std::isfinite(looked.normals.normals[i].x) ? 255 : 0;
    }
    dropBorder(looked.normals, looked.pixels);
    const auto leaveOut = [&](const Mask& mask) {
        for (std::size_t i = 0; i < mask.values.size(); ++i) {
            looked.pixels.values[i] = mask.values[i] >= 128 ? 0 : looked.pixels.values[i];
        }
    };
    if (!request.ignored.empty()) {
        leaveOut(overCut(request.ignored, artwork, looked.cut));
    }
    if (request.skipLettering && !picture.empty()) {
        leaveOut(letteringOver(artwork, looked.cut, *box, task));
    }
    return looked;
}

std::vector<Vote> votesOf(const Looked& looked) {
    // Halves in small blocks: neighbours share the scan's grain and its compression, and would vouch for one another.
    constexpr int kBlock = 4;
    std::vector<Vote> votes;
    const ArtPicture& picture = looked.cut.picture;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            if (looked.pixels.has(x, y)) {
                const glm::vec2 n = looked.normals.normals[picture.offset(x, y)];
                const Rgba& c = picture.at(x, y);
                votes.push_back(
                    {n.x, n.y, c.r, c.g, c.b, c.a, static_cast<std::uint8_t>((x / kBlock + y / kBlock) % 2)});
            }
        }
    }
    return votes;
}

/// The mean of the middle third of a patch's values: lines across it do not count.
float toneOf(std::vector<float>& values) {
    std::sort(values.begin(), values.end());
    const auto cut = static_cast<std::ptrdiff_t>(values.size() / 3);
    return std::accumulate(values.begin() + cut, values.end() - cut, 0.0F) /
           static_cast<float>(values.size() - 2 * static_cast<std::size_t>(cut));
}

/// Blank paper has one tone; so has line art, between its lines.
void checkTone(const Artwork& artwork, const ArtPicture& disk) {
    constexpr int kPatches = 8; // a side
    const int patch = disk.width / kPatches;
    constexpr float Rgba::*kChannels[] = {&Rgba::r, &Rgba::g, &Rgba::b};
    float widest = 0;
    for (float Rgba::*const channel : kChannels) {
        std::vector<float> tones;
        for (int p = 0; p < kPatches * kPatches; ++p) {
            std::vector<float> values;
            for (int i = 0; i < patch * patch; ++i) {
                const Rgba& texel = disk.at(p % kPatches * patch + i % patch, p / kPatches * patch + i / patch);
                if (texel.a > 0) {
                    values.push_back(texel.*channel);
                }
            }
            if (2 * values.size() > static_cast<std::size_t>(patch * patch)) {
                tones.push_back(toneOf(values));
            }
        }
        // Some patches at either end may lie under crossing lines.
        std::sort(tones.begin(), tones.end());
        const std::size_t odd = tones.size() / 16;
        if (!tones.empty()) {
            widest = std::max(widest, tones[tones.size() - 1 - odd] - tones[odd]);
        }
    }
    if (widest < kLeastTone) {
        fail(artwork, "there is no shading in it: blank paper, flat colour or lines alone",
             "choose a shaded form, or build a style from swatches");
    }
}

/// The gathered disk at the size asked for, and which of its texels had votes.
struct Disk {
    SpherePtr sphere;
    Mask covered;
};

Disk finish(ArtPicture gathered, int size, Task& task) {
    cv::Mat had(gathered.height, gathered.width, CV_8U);
    for (std::size_t i = 0; i < gathered.pixels.size(); ++i) {
        had.data[i] = gathered.pixels[i].a > 0 ? 255 : 0;
    }
    fillHoles(gathered, task);
    const cv::Mat fine(gathered.height, gathered.width, CV_32FC4, gathered.pixels.data());
    std::vector<Rgba> pixels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    cv::Mat resized(size, size, CV_32FC4, pixels.data());
    cv::resize(fine, resized, {size, size}, 0, 0, size < gathered.width ? cv::INTER_AREA : cv::INTER_CUBIC);
    for (Rgba& p : pixels) {
        p = {std::clamp(p.r, 0.0F, 1.0F), std::clamp(p.g, 0.0F, 1.0F), std::clamp(p.b, 0.0F, 1.0F), 1};
    }
    Disk disk;
    disk.covered = {size, size, std::vector<std::uint8_t>(pixels.size())};
    cv::Mat covered(size, size, CV_8U, disk.covered.values.data());
    cv::resize(had, covered, {size, size}, 0, 0, cv::INTER_NEAREST);
    disk.sphere = std::make_shared<const LitSphere>(size, std::move(pixels));
    return disk;
}

void shadeAgain(const Looked& looked, const LitSphere& sphere, Extraction& result) {
    const ArtPicture& art = looked.cut.picture;
    result.reshaded = {art.width, art.height, std::vector<Rgba>(art.pixels.size(), Rgba{0, 0, 0, 0})};
    result.difference = result.reshaded;
    tbb::parallel_for(0, art.height, [&](int y) {
        for (int x = 0; x < art.width; ++x) {
            const glm::vec2 n = looked.normals.normals[art.offset(x, y)];
            if (std::isfinite(n.x)) {
                const Rgba lit = sphere.at(n.x, n.y);
                const Rgba& seen = art.at(x, y);
                const auto half = [](float a, float b) { return 0.5F + (a - b) / 2; };
                result.reshaded.at(x, y) = lit;
                result.difference.at(x, y) = {half(seen.r, lit.r), half(seen.g, lit.g), half(seen.b, lit.b), 1};
            }
        }
    });
}

/// RMSE between two disks where both had votes.
double differenceOf(const ArtPicture& a, const ArtPicture& b) {
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
        const Rgba& p = a.pixels[i];
        const Rgba& q = b.pixels[i];
        if (p.a > 0 && q.a > 0) {
            sum += (p.r - q.r) * (p.r - q.r) + (p.g - q.g) * (p.g - q.g) + (p.b - q.b) * (p.b - q.b);
            count += 3;
        }
    }
    return count > 0 ? std::sqrt(sum / count) : 0;
}

/// Every few votes: a disk of 64 to 128 texels.
std::vector<Vote> someVotes(const Looked& looked, const NormalField& normals) {
    constexpr std::size_t kFew = 20'000;
    Looked other{looked.cut, normals, looked.pixels};
    for (std::size_t i = 0; i < other.pixels.values.size(); ++i) {
        other.pixels.values[i] = std::isfinite(normals.normals[i].x) ? other.pixels.values[i] : 0;
    }
    const std::vector<Vote> all = votesOf(other);
    std::vector<Vote> votes;
    const std::size_t every = std::max<std::size_t>(1, all.size() / kFew);
    for (std::size_t i = 0; i < all.size(); i += every) {
        votes.push_back(all[i]);
    }
    return votes;
}

/// Whether two outlines differ by less than a thirtieth of their size.
bool alike(const Ellipse& a, const Ellipse& b) {
    const double size = std::min({a.semiAxes.x, a.semiAxes.y, b.semiAxes.x, b.semiAxes.y});
    const Box boxA = boxOf(a);
    const Box boxB = boxOf(b);
    return glm::distance(boxA.low, boxB.low) < size / 30 && glm::distance(boxA.high, boxB.high) < size / 30;
}

/// How far the sphere would be off, were the form another one.
std::optional<double> formError(const Artwork& artwork, const ExtractionRequest& request, const Looked& looked,
                                Task& task) {
    NormalField other;
    if (const auto* ellipse = std::get_if<Ellipse>(&request.form)) {
        const std::optional<Ellipse> snapped = snapEllipse(looked.cut, *ellipse);
        const std::optional<Ellipse> again = snapped ? snapEllipse(looked.cut, *snapped) : std::nullopt;
        if (!again || !alike(*snapped, *again)) {
            return std::nullopt; // it moves on: among soft edges none is the form's
        }
        other = ellipseNormals(looked.cut, *snapped);
    } else {
        const auto& region = std::get<FormRegion>(request.form);
        FormMarks deeper = region.marks;
        deeper.depth *= 1.25; // between a ball and a rod of one outline lies a factor of 1.4
        other = formNormals(looked.cut, overCut(region.mask, artwork, looked.cut), deeper, task);
    }
    std::vector<Vote> here = someVotes(looked, looked.normals);
    std::vector<Vote> there = someVotes(looked, other);
    // Both on one grid: as many votes for one as for the other.
    const std::size_t count = std::min(here.size(), there.size());
    here.resize(count);
    there.resize(count);
    if (count < kLeastVotes) {
        return std::nullopt;
    }
    return differenceOf(gatherVotes(std::move(here), HeldOut::left, task).picture,
                        gatherVotes(std::move(there), HeldOut::left, task).picture);
}

} // namespace

Extraction extractStyle(const Artwork& artwork, const ExtractionRequest& request, Task& task) {
    if (request.size < 16 || request.size > 2048) {
        throw Error(ErrorKind::usage, {"cannot take a style", "size " + std::to_string(request.size),
                                       "a style's picture is 16 to 2048 pixels wide", "512 is plenty"});
    }
    Looked looked = look(artwork, request, task);
    if (request.removePaperCast) {
        if (const std::optional<Rgba> paper = paperColour(artwork.reduced())) {
            for (Rgba& pixel : looked.cut.picture.pixels) {
                pixel = withoutCast(pixel, *paper);
            }
        } else {
            task.warn("no paper was found on the artwork; colours are as they were");
        }
    }
    std::vector<Vote> votes = votesOf(looked);
    if (votes.size() < kLeastVotes) {
        fail(artwork, "only " + std::to_string(votes.size()) + " pixels of it count, the rest is clear or left out",
             "choose a larger form, or scan it finer");
    }
    Gathered gathered;
    Extraction result;
    // Neither keeps two cores busy on its own.
    tbb::parallel_invoke([&] { gathered = gatherVotes(std::move(votes), HeldOut::measured, task); },
                         [&] { result.figures.formRmse = formError(artwork, request, looked, task); });
    checkTone(artwork, gathered.picture);
    result.figures.coverage = diskCoverage(gathered.picture);
    result.figures.largestHoleDegrees = largestHoleDegrees(gathered.picture);
    result.figures.residualRmse = *gathered.heldOutRmse;
    Disk disk = finish(std::move(gathered.picture), request.size, task);
    // Lighting is what changes slowly over the sphere; finer things are the texture's, and not said twice.
    result.unedited = request.separateTexture ? withSmoothing(disk.sphere, 1) : disk.sphere;
    result.covered = std::move(disk.covered);
    shadeAgain(looked, *result.unedited, result);
    if (request.separateTexture) {
        result.texture = textureApart(looked.cut.picture, looked.normals, result.reshaded, looked.pixels);
    }
    result.sphere = edited(result.unedited, request.edits);
    result.cut = std::move(looked.cut);
    return result;
}

} // namespace limner
