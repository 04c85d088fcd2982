#include "core/volume/widened.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

namespace limner {

std::shared_ptr<const Volume> widenedToInt16(const Volume& narrow) {
    assert(narrow.type() == VoxelType::uint8);
    const glm::ivec3 dims = narrow.grid().dims;
    const auto row = static_cast<std::size_t>(dims.x);
    std::vector<std::int16_t> wide(narrow.grid().voxelCount());
    tbb::parallel_for(0, dims.z, [&](int z) {
        std::vector<std::uint8_t> numbers(row);
        for (int y = 0; y < dims.y; ++y) {
            narrow.copyRow(y, z, reinterpret_cast<std::byte*>(numbers.data()));
            const std::size_t first = (static_cast<std::size_t>(z) * dims.y + static_cast<std::size_t>(y)) * row;
            std::copy(numbers.begin(), numbers.end(), wide.begin() + static_cast<std::ptrdiff_t>(first));
        }
    });
    Volume::Contents contents = narrow.contents();
    contents.type = VoxelType::int16;
    return std::make_shared<const Volume>(std::move(contents), std::as_bytes(std::span(wide)));
}

} // namespace limner
