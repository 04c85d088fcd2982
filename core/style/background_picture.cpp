#include "core/style/background_picture.h"

#include "core/base/error.h"
#include "core/style/picture_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <span>
#include <utility>

namespace limner {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTexelBytes = 4 * sizeof(std::uint16_t);
/// A screen's picture comes in a few sizes: the still and its drafts.
constexpr std::size_t kMostKept = 4;
constexpr std::size_t kMostKeptBytes = std::size_t{256} << 20;

PictureRows openRows(const fs::path& file) {
    return {file, {"cannot read the background's picture", "use a PNG, TIFF, JPEG, EXR or WebP picture"}};
}

/// What of the source a copy shows. Lengths in pixels of the source.
struct Geometry {
    glm::dvec2 corner{0}; ///< of the output in the source
    glm::dvec2 first{0};  ///< of the copy in the source
    double pixel = 1;     ///< of the output
    double texel = 1;     ///< of the copy; at least 1
    glm::ivec2 size{1};   ///< of the copy
};

Geometry coveringGeometry(glm::ivec2 source, glm::ivec2 output, std::size_t maxBytes) {
    const glm::dvec2 from(source);
    const glm::dvec2 to(output);
    Geometry g;
    g.pixel = std::min(from.x / to.x, from.y / to.y);
    const glm::dvec2 seen = to * g.pixel;
    g.corner = (from - seen) * 0.5;
    const double most = std::max(1.0, static_cast<double>(maxBytes) / kTexelBytes);
    g.texel = std::max({1.0, g.pixel, seen.x / BackgroundPicture::kLongestCopy,
                        seen.y / BackgroundPicture::kLongestCopy, std::sqrt(seen.x * seen.y / most)});
    const auto count = [&](double length) {
        constexpr double kRounding = 1e-6; // of a texel: none is added for a rounding error
        return std::max(1, static_cast<int>(std::ceil(length / g.texel - kRounding)));
    };
    while (static_cast<double>(count(seen.x)) * count(seen.y) > most) { // texels that are seen in part count too
        g.texel *= 1.01;
    }
    if (g.texel > 1) {
        g.first = g.corner;
        g.size = {count(seen.x), count(seen.y)};
    } else { // the source's own pixels, those that the output touches
        g.first = {std::floor(g.corner.x), std::floor(g.corner.y)};
        const glm::dvec2 last = g.corner + seen;
        g.size = {static_cast<int>(std::ceil(last.x) - g.first.x), static_cast<int>(std::ceil(last.y) - g.first.y)};
        g.size = {std::min(g.size.x, source.x), std::min(g.size.y, source.y)};
    }
    return g;
}

using Sum = std::array<float, 4>;

/// The two texels at most that a source pixel falls on, and how much of it each gets.
struct Shares {
    int texel = 0;
    float here = 0;
    float next = 0;

    Shares(double from, double texelSize) {
        const double start = from / texelSize;
        const double end = (from + 1) / texelSize;
        texel = static_cast<int>(std::floor(start));
        const double cut = std::min(end, texel + 1.0);
        here = static_cast<float>((cut - start) * texelSize);
        next = static_cast<float>((end - cut) * texelSize);
    }
};

/// Averages rows of the source into rows of the copy, top to bottom.
class Reducer {
  public:
    Reducer(const Geometry& geometry, CoveringCopy& copy)
        : g_(geometry), copy_(copy), row_(static_cast<std::size_t>(g_.size.x)),
          weight_(static_cast<std::size_t>(g_.size.x)), here_(row_.size()), next_(row_.size()) {}

    void addRow(int y, std::span<const Rgba> source) {
        reduceAcross(source);
        const Shares shares(y - g_.first.y, g_.texel);
        moveTo(shares.texel);
        for (std::size_t i = 0; i < row_.size(); ++i) {
            for (std::size_t c = 0; c < 4; ++c) {
                here_[i][c] += shares.here * row_[i][c];
                next_[i][c] += shares.next * row_[i][c];
            }
        }
        hereWeight_ += shares.here;
        nextWeight_ += shares.next;
    }

    void finish() { moveTo(g_.size.y); }

  private:
    void reduceAcross(std::span<const Rgba> source) {
        std::fill(row_.begin(), row_.end(), Sum{});
        std::fill(weight_.begin(), weight_.end(), 0.0F);
        const int last =
            std::min(static_cast<int>(source.size()), static_cast<int>(std::ceil(g_.first.x + g_.size.x * g_.texel)));
        for (int x = std::max(0, static_cast<int>(std::floor(g_.first.x))); x < last; ++x) {
            const Rgba& p = source[static_cast<std::size_t>(x)];
            const Sum premultiplied{p.r * p.a, p.g * p.a, p.b * p.a, p.a};
            const Shares shares(x - g_.first.x, g_.texel);
            add(shares.texel, shares.here, premultiplied);
            add(shares.texel + 1, shares.next, premultiplied);
        }
        for (std::size_t i = 0; i < row_.size(); ++i) {
            const float scale = weight_[i] > 0 ? 1 / weight_[i] : 0;
            for (float& channel : row_[i]) {
                channel *= scale;
            }
        }
    }

    void add(int texel, float share, const Sum& value) {
        if (texel < 0 || texel >= g_.size.x || share <= 0) {
            return;
        }
        const auto i = static_cast<std::size_t>(texel);
        for (std::size_t c = 0; c < 4; ++c) {
            row_[i][c] += share * value[c];
        }
        weight_[i] += share;
    }

    /// Writes the rows of the copy that lie above `texel`.
    void moveTo(int texel) {
        for (; current_ < texel; ++current_) {
            if (current_ >= 0 && current_ < g_.size.y) {
                store();
            }
            std::swap(here_, next_);
            std::fill(next_.begin(), next_.end(), Sum{});
            hereWeight_ = std::exchange(nextWeight_, 0.0F);
        }
    }

    void store() {
        const float scale = hereWeight_ > 0 ? 65535 / hereWeight_ : 0;
        std::uint16_t* out = copy_.rgba.data() + static_cast<std::size_t>(current_) * row_.size() * 4;
        for (const Sum& sum : here_) {
            for (const float channel : sum) {
                *out++ = static_cast<std::uint16_t>(std::clamp(channel * scale + 0.5F, 0.0F, 65535.0F));
            }
        }
    }

    Geometry g_;
    CoveringCopy& copy_;
    std::vector<Sum> row_;      ///< one row of the source, reduced across
    std::vector<float> weight_; ///< of its texels
    std::vector<Sum> here_;     ///< row `current_` of the copy so far
    std::vector<Sum> next_;     ///< the one after it
    float hereWeight_ = 0;
    float nextWeight_ = 0;
    int current_ = -1; ///< a pixel may begin above the copy's first row
};

std::shared_ptr<const CoveringCopy> readCopy(const fs::path& file, glm::ivec2 expected, const Geometry& g) {
    PictureRows rows = openRows(file);
    if (glm::ivec2(rows.width(), rows.height()) != expected) {
        rows.fail("it is another picture than it was", "choose the picture anew");
    }
    auto copy = std::make_shared<CoveringCopy>();
    copy->size = g.size;
    copy->first = (g.corner - g.first) / g.texel;
    copy->texelsPerPixel = g.pixel / g.texel;
    copy->rgba.resize(static_cast<std::size_t>(g.size.x) * static_cast<std::size_t>(g.size.y) * 4);
    Reducer reducer(g, *copy);
    const int top = std::max(0, static_cast<int>(std::floor(g.first.y)));
    const int bottom = std::min(rows.height(), static_cast<int>(std::ceil(g.first.y + g.size.y * g.texel)));
    const auto width = static_cast<std::size_t>(rows.width());
    for (int band = top / rows.bandRows() * rows.bandRows(); band < bottom; band += rows.bandRows()) {
        const std::span<const Rgba> pixels = rows.read(band);
        const int end = std::min(bottom, band + static_cast<int>(pixels.size() / width));
        for (int y = std::max(top, band); y < end; ++y) {
            reducer.addRow(y, pixels.subspan(static_cast<std::size_t>(y - band) * width, width));
        }
    }
    reducer.finish();
    return copy;
}

} // namespace

BackgroundPicture::BackgroundPicture(fs::path file, std::shared_ptr<const void> owner)
    : file_(std::move(file)), owner_(std::move(owner)) {
    const PictureRows rows = openRows(file_);
    size_ = {rows.width(), rows.height()};
    rows.failWhereTooShort();
}

std::shared_ptr<const CoveringCopy> BackgroundPicture::covering(glm::ivec2 output, std::size_t maxBytes) const {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
        return kept.output == output && kept.maxBytes == maxBytes;
    });
    if (found != kept_.end()) {
        std::rotate(found, found + 1, kept_.end());
        return kept_.back().copy;
    }
    const Geometry geometry = coveringGeometry(size_, output, maxBytes);
    const auto bytesOf = [](const CoveringCopy& copy) { return copy.rgba.size() * sizeof(std::uint16_t); };
    try {
        kept_.push_back({output, maxBytes, readCopy(file_, size_, geometry)});
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources,
                    {"cannot read the background's picture", file_.string(), "out of memory", "use a smaller one"});
    }
    std::size_t held = 0;
    for (const Kept& kept : kept_) {
        held += bytesOf(*kept.copy);
    }
    while (kept_.size() > 1 && (kept_.size() > kMostKept || held > kMostKeptBytes)) {
        held -= bytesOf(*kept_.front().copy);
        kept_.erase(kept_.begin());
    }
    return kept_.back().copy;
}

std::size_t BackgroundPicture::coveringBytes(glm::ivec2 output, std::size_t maxBytes) const {
    const Geometry geometry = coveringGeometry(size_, output, maxBytes);
    return static_cast<std::size_t>(geometry.size.x) * static_cast<std::size_t>(geometry.size.y) * kTexelBytes;
}

} // namespace limner
