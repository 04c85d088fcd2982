#pragma once

#include "core/base/pending_file.h"
#include "renderer/export/picture_file.h"
#include "renderer/marks/marks.h"

#include <filesystem>
#include <optional>

namespace limner {

enum class VectorFormat { svg, pdf };

/// By the path's ending, in either case; absent: not a vector format's.
std::optional<VectorFormat> vectorFormatOf(const std::filesystem::path& path);

/// Throws Error(usage) where options ask for what a drawing cannot have.
void checkVectorOptions(const std::filesystem::path& path, const PictureOptions& options);

/// Draws the plan's marks as circles and paths, one layer a group, millimetres as on the figure's paper; the layers,
/// where they are drawn, as one embedded picture of the plan's size. Memory beyond the marks is that of a band and of
/// the packed picture. A failure or a cancellation leaves no partial file. Throws Error.
ExportFacts writeVectorFile(const RenderPlan& plan, const Backend& backend, const std::filesystem::path& path,
                            const PictureOptions& options, Task& task);

/// The same of marks that are there, into a file that the caller commits.
ExportFacts writeVectorMarks(const Marks& marks, const RenderPlan& plan, const Backend& backend,
                             const PictureOptions& options, VectorFormat format, PendingFile& file, Task& task);

} // namespace limner
