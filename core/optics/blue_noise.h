#pragma once

#include <array>
#include <cstdint>

namespace limner {

/// A tile of thresholds that repeats without a seam. The pixels below any threshold are spread evenly and without a
/// pattern (blue noise), whatever the threshold: what is compared with it thins out as a stipple drawing does. Made by
/// void and cluster (Ulichney 1993, "The void-and-cluster method for dither array generation"). The same seed gives the
/// same tile on every machine. Thread-safe once made.
class BlueNoiseTile {
  public:
    static constexpr int kSize = 64; ///< columns and rows: a power of two
    static constexpr int kCount = kSize * kSize;

    /// Takes some hundredths of a second.
    explicit BlueNoiseTile(std::uint32_t seed);

    /// Place in the order in which the tile fills, 0 .. kCount - 1, each once; the tile repeats in all directions.
    [[nodiscard]] int rank(int column, int row) const;
    /// (rank + 0.5) / kCount, in (0, 1): of the tile's pixels the share t, to the nearest pixel, lies below t.
    [[nodiscard]] double threshold(int column, int row) const;

  private:
    std::array<std::uint16_t, kCount> ranks_{};
};

/// The tile that figures are drawn with; made on first use, from any thread.
const BlueNoiseTile& blueNoise();

} // namespace limner
