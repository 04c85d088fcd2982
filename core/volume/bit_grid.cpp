#include "core/volume/bit_grid.h"

#include <glm/common.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>

namespace limner {

namespace {

using Word = BitGrid::Word;
constexpr int kBits = 64;

Word tailMask(int nx) { return nx % kBits == 0 ? ~Word{0} : (Word{1} << (nx % kBits)) - 1; }

/// out = row and the voxels left and right of it.
void spreadRow(Word* out, const Word* in, int words) {
    for (int i = 0; i < words; ++i) {
        const Word left = i > 0 ? in[i - 1] >> (kBits - 1) : 0;
        const Word right = i + 1 < words ? in[i + 1] << (kBits - 1) : 0;
        out[i] = in[i] | in[i] << 1 | in[i] >> 1 | left | right;
    }
}

/// The set with one more voxel at both ends of every run.
BitGrid spreadRows(const BitGrid& set) {
    BitGrid out(set.dims());
    tbb::parallel_for(0, set.dims().z, [&](int z) {
        for (int y = 0; y < set.dims().y; ++y) {
            spreadRow(out.row(y, z), set.row(y, z), set.wordsPerRow());
            out.row(y, z)[set.wordsPerRow() - 1] &= tailMask(set.dims().x);
        }
    });
    return out;
}

/// A row of a structuring element: the rows at (dy, dz) count, spread by `spread` voxels.
struct ElementRow {
    int dy = 0;
    int dz = 0;
    int spread = 0;
};

BitGrid dilatedBy(const BitGrid& set, const std::vector<ElementRow>& element) {
    int widest = 0;
    for (const ElementRow& row : element) {
        widest = std::max(widest, row.spread);
    }
    std::vector<BitGrid> spread = {set};
    for (int i = 0; i < widest; ++i) {
        spread.push_back(spreadRows(spread.back()));
    }
    const glm::ivec3 dims = set.dims();
    const int words = set.wordsPerRow();
    BitGrid out(dims);
    tbb::parallel_for(0, dims.z, [&](int z) {
        for (const ElementRow& row : element) {
            if (z + row.dz < 0 || z + row.dz >= dims.z) {
                continue;
            }
            for (int y = std::max(0, -row.dy); y < std::min(dims.y, dims.y - row.dy); ++y) {
                const Word* from = spread[static_cast<std::size_t>(row.spread)].row(y + row.dy, z + row.dz);
                std::transform(from, from + words, out.row(y, z), out.row(y, z), std::bit_or<>());
            }
        }
    });
    return out;
}

BitGrid complement(const BitGrid& set) {
    BitGrid out(set.dims());
    tbb::parallel_for(0, set.dims().z, [&](int z) {
        for (int y = 0; y < set.dims().y; ++y) {
            std::transform(set.row(y, z), set.row(y, z) + set.wordsPerRow(), out.row(y, z), std::bit_not<>());
            out.row(y, z)[set.wordsPerRow() - 1] &= tailMask(set.dims().x);
        }
    });
    return out;
}

template <typename Op>
void combine(BitGrid& a, const BitGrid& b, Op op) {
    assert(a.dims() == b.dims());
    tbb::parallel_for(0, a.dims().z, [&](int z) {
        const std::size_t n = static_cast<std::size_t>(a.wordsPerRow()) * static_cast<std::size_t>(a.dims().y);
        std::transform(a.row(0, z), a.row(0, z) + n, b.row(0, z), a.row(0, z), op);
    });
}

} // namespace

BitGrid::BitGrid(glm::ivec3 dims) : dims_(dims), wordsPerRow_((dims.x + kBits - 1) / kBits) {
    assert(dims.x > 0 && dims.y > 0 && dims.z > 0);
    words_.resize(rowStart(0, dims.z));
}

bool BitGrid::at(glm::ivec3 voxel) const {
    return (row(voxel.y, voxel.z)[voxel.x / kBits] >> (voxel.x % kBits) & 1) != 0;
}

void BitGrid::set(glm::ivec3 voxel) { row(voxel.y, voxel.z)[voxel.x / kBits] |= Word{1} << (voxel.x % kBits); }

void BitGrid::setRun(int y, int z, glm::ivec2 fromTo) {
    Word* words = row(y, z);
    for (int x = fromTo.x; x < fromTo.y;) {
        const int bit = x % kBits;
        const int n = std::min(kBits - bit, fromTo.y - x);
        words[x / kBits] |= (n == kBits ? ~Word{0} : (Word{1} << n) - 1) << bit;
        x += n;
    }
}

std::size_t BitGrid::count() const {
    return std::transform_reduce(words_.begin(), words_.end(), std::size_t{0}, std::plus<>(),
                                 [](Word w) { return static_cast<std::size_t>(std::popcount(w)); });
}

bool BitGrid::empty() const {
    return std::all_of(words_.begin(), words_.end(), [](Word w) { return w == 0; });
}

BitGrid& BitGrid::operator|=(const BitGrid& other) {
    combine(*this, other, std::bit_or<>());
    return *this;
}

BitGrid& BitGrid::operator&=(const BitGrid& other) {
    combine(*this, other, std::bit_and<>());
    return *this;
}

BitGrid& BitGrid::operator-=(const BitGrid& other) {
    combine(*this, other, [](Word a, Word b) { return a & ~b; });
    return *this;
}

BitGrid dilatedByOne(const BitGrid& set, Connectivity connectivity) {
    std::vector<ElementRow> element;
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dy = -1; dy <= 1; ++dy) {
            if (connectivity == Connectivity::corners) {
                element.push_back({dy, dz, 1});
            } else if (dy == 0 || dz == 0) {
                element.push_back({dy, dz, dy == 0 && dz == 0 ? 1 : 0});
            }
        }
    }
    return dilatedBy(set, element);
}

BitGrid dilated(const BitGrid& set, const glm::dvec3& spacingMm, double radiusMm) {
    constexpr double kSlack = 1e-9; // of the radius: a centre that lies on the ball is in
    const double radius = radiusMm * (1 + kSlack);
    const glm::ivec3 reach(radius / spacingMm);
    std::vector<ElementRow> element;
    for (int dz = -reach.z; dz <= reach.z; ++dz) {
        for (int dy = -reach.y; dy <= reach.y; ++dy) {
            const double left = radius * radius - std::pow(dz * spacingMm.z, 2) - std::pow(dy * spacingMm.y, 2);
            if (left >= 0) {
                element.push_back({dy, dz, static_cast<int>(std::sqrt(left) / spacingMm.x)});
            }
        }
    }
    return dilatedBy(set, element);
}

BitGrid eroded(const BitGrid& set, const glm::dvec3& spacingMm, double radiusMm) {
    return complement(dilated(complement(set), spacingMm, radiusMm));
}

Components::Components(const BitGrid& set, Connectivity connectivity) : dims_(set.dims()) {
    collectRuns(set);
    parent_.resize(runs_.size());
    std::iota(parent_.begin(), parent_.end(), 0U);
    const int reach = connectivity == Connectivity::corners ? 1 : 0;
    const auto rowIndex = [&](int y, int z) {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(dims_.y) + static_cast<std::size_t>(y);
    };
    for (int z = 0; z < dims_.z; ++z) {
        for (int y = 0; y < dims_.y; ++y) {
            if (y > 0) {
                joinRows(rowIndex(y - 1, z), rowIndex(y, z), reach);
            }
            for (int other = std::max(0, y - reach); z > 0 && other <= std::min(dims_.y - 1, y + reach); ++other) {
                joinRows(rowIndex(other, z - 1), rowIndex(y, z), reach);
            }
        }
    }
    measure();
}

void Components::collectRuns(const BitGrid& set) {
    std::vector<std::vector<Run>> bySlice(static_cast<std::size_t>(dims_.z));
    rowStart_.assign(static_cast<std::size_t>(dims_.y) * static_cast<std::size_t>(dims_.z) + 1, 0);
    tbb::parallel_for(0, dims_.z, [&](int z) {
        auto& runs = bySlice[static_cast<std::size_t>(z)];
        for (int y = 0; y < dims_.y; ++y) {
            const std::size_t before = runs.size();
            const Word* words = set.row(y, z);
            Word carry = 0; // last bit of the word before
            for (int w = 0; w < set.wordsPerRow(); ++w) {
                Word edges = words[w] ^ (words[w] << 1 | carry);
                carry = words[w] >> (kBits - 1);
                for (; edges != 0; edges &= edges - 1) {
                    const int x = w * kBits + std::countr_zero(edges);
                    if (runs.size() == before || runs.back().to >= 0) {
                        runs.push_back({x, -1, 0}); // open: its end is the next edge
                    } else {
                        runs.back().to = x;
                    }
                }
            }
            if (runs.size() > before && runs.back().to < 0) {
                runs.back().to = dims_.x;
            }
            rowStart_[static_cast<std::size_t>(z) * static_cast<std::size_t>(dims_.y) + static_cast<std::size_t>(y) +
                      1] = runs.size() - before;
        }
    });
    std::partial_sum(rowStart_.begin(), rowStart_.end(), rowStart_.begin());
    runs_.reserve(rowStart_.back());
    for (const auto& runs : bySlice) {
        runs_.insert(runs_.end(), runs.begin(), runs.end());
    }
}

std::uint32_t Components::root(std::uint32_t run) {
    while (parent_[run] != run) {
        parent_[run] = parent_[parent_[run]];
        run = parent_[run];
    }
    return run;
}

void Components::joinRows(std::size_t rowA, std::size_t rowB, int reach) {
    std::size_t a = rowStart_[rowA];
    std::size_t b = rowStart_[rowB];
    while (a < rowStart_[rowA + 1] && b < rowStart_[rowB + 1]) {
        if (runs_[a].from < runs_[b].to + reach && runs_[b].from < runs_[a].to + reach) {
            const std::uint32_t rootA = root(static_cast<std::uint32_t>(a));
            const std::uint32_t rootB = root(static_cast<std::uint32_t>(b));
            parent_[std::max(rootA, rootB)] = std::min(rootA, rootB);
        }
        (runs_[a].to < runs_[b].to ? a : b) += 1;
    }
}

void Components::measure() {
    std::vector<std::uint32_t> dense(runs_.size());
    const auto rows = static_cast<std::size_t>(dims_.y) * static_cast<std::size_t>(dims_.z);
    for (std::size_t row = 0; row < rows; ++row) {
        const auto y = static_cast<int>(row % static_cast<std::size_t>(dims_.y));
        const auto z = static_cast<int>(row / static_cast<std::size_t>(dims_.y));
        for (std::size_t r = rowStart_[row]; r < rowStart_[row + 1]; ++r) {
            const std::uint32_t top = root(static_cast<std::uint32_t>(r));
            Run& run = runs_[r];
            if (top == r) { // the root is the first run of its component
                dense[r] = static_cast<std::uint32_t>(list_.size());
                list_.push_back({0, {run.from, y, z}, {run.to - 1, y, z}, 0});
            }
            run.component = dense[top];
            Component& c = list_[run.component];
            c.voxels += static_cast<std::size_t>(run.to - run.from);
            c.low = glm::min(c.low, {run.from, y, z});
            c.high = glm::max(c.high, {run.to - 1, y, z});
        }
    }
    std::vector<std::uint32_t> order(list_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return list_[a].voxels > list_[b].voxels; });
    std::vector<std::uint32_t> rank(list_.size());
    std::vector<Component> sorted(list_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = i;
        sorted[i] = list_[order[i]];
    }
    list_ = std::move(sorted);
    for (Run& run : runs_) {
        run.component = rank[run.component];
    }
    // Overlap of each run with those right above it (z - 1) tells sheets that run through the slices from branches.
    for (std::size_t row = static_cast<std::size_t>(dims_.y); row < rows; ++row) {
        std::size_t a = rowStart_[row - static_cast<std::size_t>(dims_.y)];
        const std::size_t endA = rowStart_[row - static_cast<std::size_t>(dims_.y) + 1];
        std::size_t b = rowStart_[row];
        while (a < endA && b < rowStart_[row + 1]) {
            const int overlap = std::min(runs_[a].to, runs_[b].to) - std::max(runs_[a].from, runs_[b].from);
            list_[runs_[b].component].stacked += static_cast<std::size_t>(std::max(0, overlap));
            (runs_[a].to < runs_[b].to ? a : b) += 1;
        }
    }
}

int Components::at(glm::ivec3 voxel) const {
    const std::size_t row =
        static_cast<std::size_t>(voxel.z) * static_cast<std::size_t>(dims_.y) + static_cast<std::size_t>(voxel.y);
    for (std::size_t r = rowStart_[row]; r < rowStart_[row + 1]; ++r) {
        if (voxel.x >= runs_[r].from && voxel.x < runs_[r].to) {
            return static_cast<int>(runs_[r].component);
        }
    }
    return -1;
}

std::vector<bool> Components::meeting(const BitGrid& other) const {
    std::vector<bool> met(list_.size());
    for (int z = 0; z < dims_.z; ++z) {
        for (int y = 0; y < dims_.y; ++y) {
            const Word* words = other.row(y, z);
            const std::size_t row =
                static_cast<std::size_t>(z) * static_cast<std::size_t>(dims_.y) + static_cast<std::size_t>(y);
            for (std::size_t r = rowStart_[row]; r < rowStart_[row + 1]; ++r) {
                for (int x = runs_[r].from; x < runs_[r].to && !met[runs_[r].component];) {
                    const int n = std::min(kBits - x % kBits, runs_[r].to - x);
                    const Word mask = (n == kBits ? ~Word{0} : (Word{1} << n) - 1) << (x % kBits);
                    met[runs_[r].component] = (words[x / kBits] & mask) != 0;
                    x += n;
                }
            }
        }
    }
    return met;
}

BitGrid Components::select(const std::vector<bool>& chosen) const {
    BitGrid out(dims_);
    tbb::parallel_for(0, dims_.z, [&](int z) {
        for (int y = 0; y < dims_.y; ++y) {
            const std::size_t row =
                static_cast<std::size_t>(z) * static_cast<std::size_t>(dims_.y) + static_cast<std::size_t>(y);
            for (std::size_t r = rowStart_[row]; r < rowStart_[row + 1]; ++r) {
                if (chosen[runs_[r].component]) {
                    out.setRun(y, z, {runs_[r].from, runs_[r].to});
                }
            }
        }
    });
    return out;
}

} // namespace limner
