#pragma once

#include "core/base/task.h"
#include "core/figure/figure.h"
#include "renderer/annotations.h"
#include "renderer/backend.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace limner {

enum class SampleDepth { automatic, eight, sixteen, floating };

struct PictureOptions {
    double dpi = 300;
    SampleDepth depth = SampleDepth::automatic; ///< automatic: 8 bits, float for EXR; sixteen is half for EXR
    bool transparent = false;                   ///< keep alpha; formats without it (JPEG) take the background
    glm::dvec4 background{1, 1, 1, 1}; ///< sRGB-encoded, not premultiplied; what of it is see-through shows white paper
    /// Behind the figure and over the background colour, scaled to cover; null: none.
    std::shared_ptr<const BackgroundPicture> backgroundPicture = nullptr;
    std::size_t memoryBudget = std::size_t{1} << 30; ///< beyond the volume
    int tile = 0;                                    ///< edge in pixels; 0: chosen from the budget
    /// What is drawn is kept beside the picture until that is whole (finished_bands.h), so that an export which failed,
    /// was stopped or killed goes on where it was when it is asked for again, with the same picture in the end.
    bool resumable = false;
};

/// Resolution, background and transparency as the figure has them.
PictureOptions pictureOptions(const Figure& figure);

/// The paper of a picture with these options.
AnnotationPaper annotationPaper(const PictureOptions& options);

/// The figure's annotations as such a picture has them; none where the plan has no figure. Throws
/// Error(noResources) where there is text and the system has no font.
DrawnAnnotations annotationsOf(const RenderPlan& plan, const PictureOptions& options);

struct ExportFacts {
    glm::ivec2 size{0};
    std::uint64_t samples = 0;
    std::uint64_t shaded = 0;
    double seconds = 0;
    std::uint64_t dots = 0; ///< marks of ink
    std::uint64_t strokes = 0;
    std::uint64_t annotations = 0;
    bool layersEmbedded = false; ///< as a picture inside a vector file
    std::uint64_t notFinite = 0; ///< pixels that were NaN or infinite: written as empty, and warned of
};

/// Throws what `exportPicture` would refuse before it renders: an unknown ending, a depth or size the format cannot
/// hold (a size of 0 is not looked at), more memory than the budget, a folder that is not there.
void checkExport(const std::filesystem::path& path, glm::ivec2 size, const PictureOptions& options);

/// Bytes of memory that an export to a file of that ending takes beyond the volume, about. Throws as `checkExport`.
std::size_t exportMemory(const std::string& ending, glm::ivec2 size, const PictureOptions& options);

/// Drops what an export that is not wanted any more has kept beside its picture (`PictureOptions::resumable`).
void forgetUnfinished(const std::filesystem::path& picture);

/// Renders the plan's whole picture tile by tile, with its annotations over it, and streams it into a file whose ending
/// picks the format (png, tif, tiff, exr, jpg, jpeg, webp), with dpi and an sRGB profile (EXR: linear, scene-referred
/// floats); svg and pdf are drawn instead (vector_file.h). Memory stays within the budget for any size in the formats
/// that can be written by scan line or tile. The file is written beside its final name and renamed at the end: a
/// failure or a cancellation leaves no partial file (but see `resumable`, of which svg and pdf know nothing). Alpha is
/// not premultiplied in PNG, TIFF and WebP, premultiplied in EXR. Throws Error.
ExportFacts exportPicture(const RenderPlan& plan, const Backend& backend, const std::filesystem::path& path,
                          const PictureOptions& options, Task& task);

/// Lays a premultiplied picture over a colour; transparent keeps alpha (not premultiplied). 8-bit RGBA, top row first,
/// for screens and thumbnails. Rounded to nearest.
std::vector<std::uint8_t> toRgba8(const Picture& picture, const PictureOptions& options);

/// A picture as the bytes of an 8-bit PNG, with dpi and profile: for thumbnails inside projects.
std::vector<std::byte> encodePng(const Picture& picture, const PictureOptions& options);

/// A plan's whole picture with its annotations, as `encodePng` writes it.
std::vector<std::byte> renderPng(const RenderPlan& plan, const Backend& backend, const PictureOptions& options,
                                 Task& task);

} // namespace limner
