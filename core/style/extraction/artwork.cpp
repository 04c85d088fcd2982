#include "core/style/extraction/artwork.h"

#include "core/base/error.h"
#include "core/base/task.h"
#include "core/style/extraction/area_means.h"
#include "core/style/picture_rows.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <span>
#include <utility>
#include <vector>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr int kLongestSide = 100'000;
/// Rows of a picture in memory that are kept together.
constexpr int kMemoryBand = 64;
/// A cut that is coarser than the reduced copy by this much shows no more than the copy does.
constexpr double kFineEnough = 2;

constexpr const char* kWhat = "cannot read the artwork";

PictureRows openRows(const fs::path& file) {
    return {file, {kWhat, "use a TIFF, PNG, JPEG, PSD, WebP or EXR picture"}};
}

ArtPicture blankPicture(const Reduction& reduction) {
    ArtPicture picture{reduction.width, reduction.height, {}};
    picture.pixels.resize(picture.offset(0, reduction.height));
    return picture;
}

std::uint16_t word(float value) { return static_cast<std::uint16_t>(std::clamp(value, 0.0F, 1.0F) * 65535 + 0.5F); }

ArtRect clipped(const ArtRect& rect, int width, int height) {
    const auto side = [](int from, int length, int most) {
        const std::int64_t end = std::clamp<std::int64_t>(static_cast<std::int64_t>(from) + length, 0, most);
        const std::int64_t begin = std::clamp<std::int64_t>(from, 0, most);
        return std::pair<int, int>(static_cast<int>(begin), static_cast<int>(std::max<std::int64_t>(0, end - begin)));
    };
    const auto [x, across] = side(rect.x, rect.width, width);
    const auto [y, down] = side(rect.y, rect.height, height);
    return across > 0 && down > 0 ? ArtRect{x, y, across, down} : ArtRect{};
}

} // namespace

/// All pixels, in bands of rows, so that memory grows with what has been read.
struct Artwork::Kept {
    using Word4 = std::array<std::uint16_t, 4>;

    int width = 0;
    int bandRows = 1;
    std::vector<std::vector<Word4>> bands;

    void add(std::span<const Rgba> pixels) {
        std::vector<Word4> band(pixels.size());
        std::transform(pixels.begin(), pixels.end(), band.begin(), [](const Rgba& p) {
            return Word4{word(p.r), word(p.g), word(p.b), word(p.a)};
        });
        bands.push_back(std::move(band));
    }

    void read(int y, int left, std::span<Rgba> row) const {
        const auto& band = bands[static_cast<std::size_t>(y / bandRows)];
        const Word4* from =
            band.data() + static_cast<std::size_t>(y % bandRows) * static_cast<std::size_t>(width) + left;
        constexpr float kScale = 1 / 65535.0F;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const Word4& p = from[i];
            row[i] = {static_cast<float>(p[0]) * kScale, static_cast<float>(p[1]) * kScale,
                      static_cast<float>(p[2]) * kScale, static_cast<float>(p[3]) * kScale};
        }
    }
};

namespace {

/// A reduction of rows that can be read in any order: `readRow(y, row)` gives the columns that count.
template <typename ReadRow>
ArtPicture reduceRows(const Reduction& r, const ReadRow& readRow, const Task& task) {
    ArtPicture copy = blankPicture(r);
    const auto reduce = [&](const tbb::blocked_range<int>& rows) {
        std::vector<Rgba> row(static_cast<std::size_t>(r.right - r.left));
        if (r.scale <= 1) {
            for (int y = rows.begin(); y < rows.end() && !task.cancelled(); ++y) {
                readRow(r.top + y, std::span(copy.pixels).subspan(copy.offset(0, y), row.size()));
            }
            return;
        }
        AreaMeans means(r, rows.begin(), rows.end(), copy);
        for (int y = means.top(); y < means.bottom() && !task.cancelled(); ++y) {
            readRow(y, std::span(row));
            means.addRow(y, row);
        }
        means.finish();
    };
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(tbb::blocked_range<int>(0, r.height, 16), reduce); });
    task.throwIfCancelled();
    return copy;
}

/// Reads rows of a picture from the column `left` on.
auto rowsOf(const ArtPicture& picture, int left) {
    return [&picture, left](int y, std::span<Rgba> row) {
        std::copy_n(picture.pixels.data() + picture.offset(left, y), row.size(), row.begin());
    };
}

/// The same reduction, of a copy of the artwork.
Reduction onCopy(const Reduction& r, const ArtCut& copy) {
    Reduction onIt = r;
    onIt.origin = copy.toCut(r.origin);
    onIt.scale = r.scale / copy.scale;
    const auto low = [&](int place) { return static_cast<int>(std::floor(place / copy.scale)); };
    const auto high = [&](int place, int most) {
        return std::min(most, static_cast<int>(std::ceil(place / copy.scale)));
    };
    onIt.left = low(r.left);
    onIt.right = high(r.right, copy.picture.width);
    onIt.top = low(r.top);
    onIt.bottom = high(r.bottom, copy.picture.height);
    return onIt;
}

/// What to do with each band: `take(y, pixels)`, the rows from `y` on.
template <typename Take>
void readBands(PictureRows& rows, const Reduction& r, Task& task, const Take& take) {
    for (int band = r.top / rows.bandRows() * rows.bandRows(); band < r.bottom; band += rows.bandRows()) {
        task.throwIfCancelled();
        const std::span<const Rgba> pixels = rows.read(band, r.left, r.right);
        take(band, pixels);
        task.progress((band - r.top) / static_cast<double>(r.bottom - r.top));
    }
}

void addBand(AreaMeans& means, int band, std::span<const Rgba> pixels, std::size_t width) {
    const int end = std::min(means.bottom(), band + static_cast<int>(pixels.size() / width));
    for (int y = std::max(means.top(), band); y < end; ++y) {
        means.addRow(y, pixels.subspan(static_cast<std::size_t>(y - band) * width, width));
    }
}

} // namespace

Artwork::Artwork(fs::path file, Task& task) : file_(std::move(file)) {
    task.beginPhase("Reading the artwork");
    try {
        PictureRows rows = openRows(file_);
        width_ = rows.width();
        height_ = rows.height();
        if (width_ > kLongestSide || height_ > kLongestSide) {
            rows.fail(std::to_string(width_) + " x " + std::to_string(height_) + " pixels are too many",
                      "bring it to at most " + std::to_string(kLongestSide) + " pixels a side");
        }
        rows.failWhereTooShort();
        const Reduction whole = reductionOf({0, 0}, {width_, height_}, kReducedSide);
        reduced_ = {blankPicture(whole), whole.origin, whole.scale};
        AreaMeans means(whole, 0, whole.height, reduced_.picture);
        const bool keep = static_cast<std::int64_t>(width_) * height_ <= kKeptPixels;
        auto kept = std::make_shared<Kept>(Kept{width_, rows.bandRows(), {}});
        readBands(rows, whole, task, [&](int band, std::span<const Rgba> pixels) {
            if (keep) {
                kept->add(pixels);
            }
            addBand(means, band, pixels, static_cast<std::size_t>(width_));
        });
        means.finish();
        if (keep) {
            kept_ = std::move(kept);
        }
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources, {kWhat, file_.string(), "out of memory", "use a smaller one"});
    }
}

Artwork::Artwork(ArtPicture picture, std::string name)
    : file_(std::move(name)), width_(picture.empty() ? 0 : picture.width),
      height_(picture.empty() ? 0 : picture.height) {
    if (picture.empty()) {
        return;
    }
    auto kept = std::make_shared<Kept>(Kept{width_, kMemoryBand, {}});
    for (int y = 0; y < height_; y += kMemoryBand) {
        const int rows = std::min(kMemoryBand, height_ - y);
        kept->add(std::span(picture.pixels).subspan(picture.offset(0, y), picture.offset(0, rows)));
    }
    const Reduction whole = reductionOf({0, 0}, {width_, height_}, kReducedSide);
    reduced_ = {reduceRows(whole, rowsOf(picture, 0), Task()), whole.origin, whole.scale};
    kept_ = std::move(kept);
}

ArtCut Artwork::cut(ArtRect rect, int longest, Task& task) const {
    rect = clipped(rect, width_, height_);
    if (rect.width == 0) {
        return {};
    }
    const Reduction r = reductionOf({rect.x, rect.y}, {rect.width, rect.height}, longest);
    if (kept_ != nullptr) {
        const auto readRow = [&](int y, std::span<Rgba> row) { kept_->read(y, r.left, row); };
        return {reduceRows(r, readRow, task), r.origin, r.scale};
    }
    if (r.scale >= kFineEnough * reduced_.scale) {
        return {reduceRows(onCopy(r, reduced_), rowsOf(reduced_.picture, onCopy(r, reduced_).left), task), r.origin,
                r.scale};
    }
    try {
        PictureRows rows = openRows(file_);
        if (rows.width() != width_ || rows.height() != height_) {
            rows.fail("it is another picture than it was", "open the artwork anew");
        }
        ArtCut cut{blankPicture(r), r.origin, r.scale};
        AreaMeans means(r, 0, r.height, cut.picture);
        readBands(rows, r, task, [&](int band, std::span<const Rgba> pixels) {
            addBand(means, band, pixels, static_cast<std::size_t>(r.right - r.left));
        });
        means.finish();
        return cut;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources, {kWhat, file_.string(), "out of memory", "cut a smaller part"});
    }
}

} // namespace limner
