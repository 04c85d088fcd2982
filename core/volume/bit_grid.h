#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limner {

/// A set of voxels, one bit each: 2 MB for 256^3, so that morphology over a whole scan takes milliseconds. Rows are
/// padded to whole words; the padding bits are always 0.
class BitGrid {
  public:
    using Word = std::uint64_t;

    explicit BitGrid(glm::ivec3 dims);

    [[nodiscard]] glm::ivec3 dims() const { return dims_; }
    [[nodiscard]] int wordsPerRow() const { return wordsPerRow_; }
    [[nodiscard]] Word* row(int y, int z) { return words_.data() + rowStart(y, z); }
    [[nodiscard]] const Word* row(int y, int z) const { return words_.data() + rowStart(y, z); }

    [[nodiscard]] bool at(glm::ivec3 voxel) const;
    void set(glm::ivec3 voxel);
    /// Sets the voxels [from, to) of a row.
    void setRun(int y, int z, glm::ivec2 fromTo);
    [[nodiscard]] std::size_t count() const;
    [[nodiscard]] bool empty() const;

    BitGrid& operator|=(const BitGrid& other);
    BitGrid& operator&=(const BitGrid& other);
    /// Takes the voxels of the other out.
    BitGrid& operator-=(const BitGrid& other);
    friend bool operator==(const BitGrid&, const BitGrid&) = default;

  private:
    [[nodiscard]] std::size_t rowStart(int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(dims_.y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(wordsPerRow_);
    }
    glm::ivec3 dims_;
    int wordsPerRow_;
    std::vector<Word> words_;
};

/// What counts as touching: 6 or 26 neighbours.
enum class Connectivity { faces, corners };

/// Everything within `radiusMm` of the set: the ball over voxel centres, exact.
BitGrid dilated(const BitGrid& set, const glm::dvec3& spacingMm, double radiusMm);
/// What stays when such a ball is taken off along the boundary; what lies past the grid counts as set, so that matter
/// cut by the scan's border is not eroded there.
BitGrid eroded(const BitGrid& set, const glm::dvec3& spacingMm, double radiusMm);
/// The set and all voxels that touch it.
BitGrid dilatedByOne(const BitGrid& set, Connectivity connectivity);

/// One connected set of voxels.
struct Component {
    std::size_t voxels = 0;
    glm::ivec3 low{0};       ///< first voxel of the bounding box
    glm::ivec3 high{0};      ///< last voxel of the bounding box
    std::size_t stacked = 0; ///< voxels that have another of the component right above them along k
};

/// The set's components, largest first (equal ones in scan order), and which voxel belongs to which.
class Components {
  public:
    Components(const BitGrid& set, Connectivity connectivity);

    [[nodiscard]] const std::vector<Component>& list() const { return list_; }
    /// Component of a voxel, or -1.
    [[nodiscard]] int at(glm::ivec3 voxel) const;
    /// Which components share a voxel with the other set.
    [[nodiscard]] std::vector<bool> meeting(const BitGrid& other) const;
    /// The voxels of the components that `chosen[i]` marks.
    [[nodiscard]] BitGrid select(const std::vector<bool>& chosen) const;

  private:
    struct Run {
        int from = 0; ///< [from, to)
        int to = 0;
        std::uint32_t component = 0;
    };
    void collectRuns(const BitGrid& set);
    void joinRows(std::size_t rowA, std::size_t rowB, int reach);
    std::uint32_t root(std::uint32_t run);
    void measure();

    glm::ivec3 dims_;
    std::vector<std::size_t> rowStart_; ///< per row, one more at the end
    std::vector<Run> runs_;
    std::vector<std::uint32_t> parent_;
    std::vector<Component> list_;
};

} // namespace limner
