#include "core/style/extraction/mask_file.h"

#include "core/base/error.h"
#include "core/style/picture_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <new>
#include <span>

namespace limner {
namespace {

constexpr int kLongestSide = 4096; // 16 MB, finer than any hand

/// Sums of a mask's pixels, gathered row by row.
class Gatherer {
  public:
    Gatherer(int width, int factor)
        : factor_(factor), columns_((width + factor - 1) / factor), light_(static_cast<std::size_t>(columns_)),
          opaque_(light_.size()) {}

    void addRow(std::span<const Rgba> row) {
        for (std::size_t x = 0; x < row.size(); ++x) {
            const std::size_t column = x / static_cast<std::size_t>(factor_);
            const Rgba& pixel = row[x];
            const float light = (0.2126F * pixel.r + 0.7152F * pixel.g + 0.0722F * pixel.b) * pixel.a; // Rec. 709
            light_[column] += light;
            opaque_[column] += pixel.a;
            anyLight_ = anyLight_ || light > 0;
            anyClear_ = anyClear_ || pixel.a < 1;
        }
        if (++rows_ == factor_) {
            endCell(static_cast<int>(row.size()));
        }
    }

    Mask finish(int width) {
        if (rows_ > 0) {
            endCell(width);
        }
        Mask mask{columns_, static_cast<int>(lightValues_.size()) / columns_, {}};
        mask.values = std::move(anyLight_ || !anyClear_ ? lightValues_ : opaqueValues_);
        return mask;
    }

  private:
    void endCell(int width) {
        for (int column = 0; column < columns_; ++column) {
            const int across = std::min(factor_, width - column * factor_);
            const float share = 255.0F / static_cast<float>(across * rows_);
            const auto at = static_cast<std::size_t>(column);
            lightValues_.push_back(static_cast<std::uint8_t>(std::lround(share * light_[at])));
            opaqueValues_.push_back(static_cast<std::uint8_t>(std::lround(share * opaque_[at])));
        }
        std::fill(light_.begin(), light_.end(), 0.0F);
        std::fill(opaque_.begin(), opaque_.end(), 0.0F);
        rows_ = 0;
    }

    int factor_;
    int columns_;
    int rows_ = 0; ///< in the cells being gathered
    bool anyLight_ = false;
    bool anyClear_ = false;
    std::vector<float> light_;
    std::vector<float> opaque_;
    std::vector<std::uint8_t> lightValues_;
    std::vector<std::uint8_t> opaqueValues_;
};

} // namespace

Mask loadMask(const std::filesystem::path& file) {
    const PictureRows::Words words{"cannot read the mask", "use a PNG, TIFF or JPEG picture, white where it counts"};
    try {
        PictureRows rows(file, words);
        const int longest = std::max(rows.width(), rows.height());
        Gatherer gatherer(rows.width(), (longest + kLongestSide - 1) / kLongestSide);
        for (int y = 0; y < rows.height(); y += rows.bandRows()) {
            const std::span<const Rgba> band = rows.read(y);
            const auto width = static_cast<std::size_t>(rows.width());
            for (std::size_t at = 0; at < band.size(); at += width) {
                gatherer.addRow(band.subspan(at, width));
            }
        }
        return gatherer.finish(rows.width());
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources, {words.what, file.string(), "out of memory", "use a smaller picture"});
    }
}

} // namespace limner
