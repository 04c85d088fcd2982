#pragma once

#include "core/base/task.h"
#include "core/figure/figure.h"
#include "renderer/backend.h"

#include <filesystem>
#include <optional>
#include <string>

namespace limner {

enum class SampleDepth { automatic, eight, sixteen, floating };

struct PictureOptions {
    double dpi = 300;
    SampleDepth depth = SampleDepth::automatic; ///< automatic: 8 bits, float for EXR
    bool transparent = false;
    glm::dvec4 background{1, 1, 1, 1};
    std::size_t memoryBudget = std::size_t{1} << 30; ///< beyond the volume
    int tile = 0;                                    ///< edge in pixels; 0: chosen from the budget
};

struct ExportFacts {
    glm::ivec2 size{0};
    std::uint64_t samples = 0;
    std::uint64_t shaded = 0;
    double seconds = 0;
};

/// Renders the plan's whole picture tile by tile and streams it into a file whose ending picks the format (png, tif,
/// tiff, exr, jpg, jpeg, webp), with dpi and an sRGB profile (EXR: linear, scene-referred floats). Memory stays within
/// the budget for any size in the formats that can be written by scan line or tile. The file is written beside its
/// final name and renamed at the end: a failure or a cancellation leaves no partial file. Throws Error.
ExportFacts exportPicture(const RenderPlan& plan, const Backend& backend, const std::filesystem::path& path,
                          const PictureOptions& options, Task& task);

/// Lays a premultiplied picture over a colour; transparent keeps alpha. 8-bit RGBA, top row first, for screens and
/// thumbnails. Rounded to nearest.
std::vector<std::uint8_t> toRgba8(const Picture& picture, const PictureOptions& options);

} // namespace limner
