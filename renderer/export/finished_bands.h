#pragma once

#include "renderer/backend.h"
#include "renderer/export/bands.h"
#include "renderer/export/picture_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace limner {

/// What was counted while a band was drawn.
struct BandFacts {
    std::uint64_t samples = 0;
    std::uint64_t shaded = 0;
    std::uint64_t notFinite = 0;
};

/// The bands of a picture that are drawn already, packed, in a file beside the picture that is in the making: an export
/// that failed or was killed goes on from there. They hold for one key; those of another one are dropped. A disk that
/// is full, or another export of the same picture, only means that nothing more is kept. One thread at a time.
class FinishedBands {
  public:
    /// `.NAME.bands` beside the picture.
    static std::filesystem::path fileFor(const std::filesystem::path& picture);

    FinishedBands(const std::filesystem::path& picture, const std::string& key);
    ~FinishedBands();
    FinishedBands(const FinishedBands&) = delete;
    FinishedBands& operator=(const FinishedBands&) = delete;

    /// The first `count` bands are there.
    [[nodiscard]] std::size_t count() const { return places_.size(); }
    /// Reads band `index` into `bytes`, which has its size; false where it is not there or damaged.
    bool read(std::size_t index, std::vector<std::byte>& bytes, BandFacts& facts);
    /// Keeps the band that follows those that are there; does nothing for another one.
    void add(std::size_t index, const std::vector<std::byte>& bytes, const BandFacts& facts);
    /// The picture is whole: the file goes.
    void remove();

  private:
    void readPlaces(std::int64_t start);

    std::filesystem::path path_;
    int file_ = -1; ///< -1: nothing is kept
    std::vector<std::int64_t> places_;
    std::int64_t end_ = 0; ///< where the next band goes
};

/// All that the pixels of an export come from, as one sum: the figure with its scan, labels and pictures, the size, the
/// options and how it is cut into bands. Reads every voxel once.
std::string exportKey(const RenderPlan& plan, const Backend& backend, const PictureOptions& options,
                      const std::string& ending, const BandLayout& bands);

} // namespace limner
