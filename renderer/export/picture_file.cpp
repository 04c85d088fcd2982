#include "renderer/export/picture_file.h"

#include "core/base/error.h"
#include "core/base/pending_file.h"
#include "renderer/export/backdrop.h"
#include "renderer/export/bands.h"
#include "renderer/export/finished_bands.h"
#include "renderer/export/memory_stream.h"
#include "renderer/export/picture_writer.h"
#include "renderer/export/pixel_rows.h"
#include "renderer/export/vector_file.h"
#include "renderer/marks/marked_picture.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <future>
#include <memory>
#include <optional>

namespace limner {

namespace {

// What the formats' resolution fields hold without loss of sense, and any press, screen or plotter asks for.
constexpr double kLowestDpi = 1;
constexpr double kHighestDpi = 100'000;

void checkSize(PictureFormat format, glm::ivec2 size, const std::string& where) {
    const FormatTraits& traits = traitsOf(format);
    const std::string text = std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels";
    if (size.x < 1 || size.y < 1) {
        throw Error(ErrorKind::usage, {"cannot write a picture of " + text, where, "there is no pixel in it",
                                       "give a width and a height of at least 1 pixel"});
    }
    if (std::max(size.x, size.y) > traits.longestEdge) {
        const bool other = traits.longestEdge < traitsOf(PictureFormat::tiff).longestEdge;
        throw Error(ErrorKind::usage, {"cannot write a picture of " + text, where,
                                       std::string(traits.name) + " holds at most " +
                                           std::to_string(traits.longestEdge) + " pixels an edge",
                                       other ? "make it smaller or use tif or png" : "make it smaller"});
    }
}

void checkFolder(const std::filesystem::path& path) {
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
        throw Error(ErrorKind::usage,
                    {"cannot write the picture", path.string(), "there is no such folder", "make the folder first"});
    }
    if (std::filesystem::is_directory(path, ignored)) {
        throw Error(ErrorKind::usage,
                    {"cannot write the picture", path.string(), "that is a folder", "give the name of a file"});
    }
    // Devices and pipes cannot be replaced by a finished file.
    if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)) {
        throw Error(ErrorKind::usage, {"cannot write the picture", path.string(), "that is not an ordinary file",
                                       "give the name of a file"});
    }
}

/// Renders band after band and hands each to the writer, which works while the next one is rendered.
class BandPipeline {
  public:
    struct Parts {
        const MarkedPicture& picture;
        const DrawnAnnotations& annotations;
        glm::ivec2 size;
        PixelLayout layout;
        BandLayout bands;
        FinishedBands* kept; ///< null: nothing is kept
    };

    BandPipeline(const Parts& parts, PictureWriter& writer, Task& task) : parts_(parts), writer_(writer), task_(task) {}

    /// `afterBand` is called when a band has reached the stream.
    template <typename AfterBand>
    void run(ExportFacts& facts, AfterBand afterBand) {
        const glm::ivec2 size = parts_.size;
        std::vector<std::byte> inFile; // the band that is being written; outlives the writing
        std::future<void> writing;
        std::size_t index = 0;
        std::size_t known = parts_.kept != nullptr ? parts_.kept->count() : 0;
        for (int row = 0; row < size.y; row += parts_.bands.rows, ++index) {
            const int rows = std::min(parts_.bands.rows, size.y - row);
            band_.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(rows) *
                         parts_.layout.bytesPerPixel());
            BandFacts of;
            const bool there = index < known && parts_.kept->read(index, band_, of);
            if (!there) {
                known = 0; // from here on only the writing touches the finished bands
                renderBand({{0, row}, {size.x, rows}}, of);
            }
            facts.samples += of.samples;
            facts.shaded += of.shaded;
            facts.notFinite += of.notFinite;
            finishWriting(writing, afterBand);
            std::swap(band_, inFile);
            writing = std::async(std::launch::async, [this, &inFile, rows, index, of, there] {
                if (parts_.kept != nullptr && !there) {
                    parts_.kept->add(index, inFile, of);
                }
                writer_.writeRows(inFile, rows);
            });
        }
        finishWriting(writing, afterBand);
    }

  private:
    template <typename AfterBand>
    void finishWriting(std::future<void>& writing, AfterBand& afterBand) {
        if (!writing.valid()) {
            return;
        }
        try {
            writing.get();
        } catch (const Error&) {
            afterBand(); // the stream knows better why
            throw;
        }
        afterBand();
        task_.throwIfCancelled();
    }

    void renderBand(const Tile& band, BandFacts& facts) {
        const glm::ivec2 size = parts_.size;
        const auto doneAt = [&](int x) {
            return (band.origin.y + static_cast<double>(x) / size.x * band.size.y) / size.y;
        };
        for (int x = 0; x < size.x; x += parts_.bands.tileWidth) {
            task_.throwIfCancelled();
            const int width = std::min(parts_.bands.tileWidth, size.x - x);
            Task part(task_, doneAt(x), doneAt(x + width));
            const Tile tile{{x, band.origin.y}, {width, band.size.y}};
            RenderResult result = parts_.picture.render(tile, part);
            assert(result.picture.size() == tile.size);
            layAnnotations(parts_.annotations, size, tile, result.picture);
            facts.samples += result.samples;
            facts.shaded += result.shaded;
            facts.notFinite += writePixels(result.picture, parts_.layout, {band_, size.x, {x, 0}, tile.origin});
            part.progress(1);
        }
    }

    Parts parts_;
    PictureWriter& writer_;
    Task& task_;
    std::vector<std::byte> band_; ///< that is being filled
};

void warnOfNotFinite(const ExportFacts& facts, Task& task) {
    if (facts.notFinite > 0) {
        task.warn(std::to_string(facts.notFinite) + " pixels were not finite numbers and were left empty");
    }
}

} // namespace

PictureOptions pictureOptions(const Figure& figure) {
    PictureOptions options;
    options.dpi = figure.output.dpi;
    options.transparent = figure.output.transparent;
    options.background = figure.background.rgba;
    if (figure.background.kind == "image") {
        options.backgroundPicture = figure.background.picture;
    }
    return options;
}

AnnotationPaper annotationPaper(const PictureOptions& options) {
    if (options.transparent) {
        return {};
    }
    return {glm::dvec3(options.background) * options.background.a + (1 - options.background.a)};
}

DrawnAnnotations annotationsOf(const RenderPlan& plan, const PictureOptions& options) {
    if (!plan.figure || plan.figure->annotations.empty()) {
        return {};
    }
    return drawAnnotations(*plan.figure, annotationPaper(options));
}

void checkExport(const std::filesystem::path& path, glm::ivec2 size, const PictureOptions& options) {
    const bool vector = vectorFormatOf(path).has_value();
    if (vector)
        checkVectorOptions(path, options);
    // What a vector file embeds is a PNG's pixels.
    const PictureFormat format = vector ? PictureFormat::png : pictureFormatOf(path);
    const PixelLayout layout = pixelLayout(format, options);
    if (!(options.dpi >= kLowestDpi && options.dpi <= kHighestDpi)) {
        throw Error(ErrorKind::usage, {"cannot write the picture", path.string(), "the resolution makes no sense",
                                       "give between 1 and 100000 dots per inch"});
    }
    if (size != glm::ivec2(0)) {
        checkSize(format, size, path.string());
        chooseBands(size, format, layout, options);
    }
    checkFolder(path);
}

namespace {

ExportFacts writePictureFile(const RenderPlan& plan, const Backend& backend, const std::filesystem::path& path,
                             const PictureOptions& options, Task& task) {
    PictureHeader header;
    header.format = pictureFormatOf(path);
    header.layout = pixelLayout(header.format, options);
    header.size = plan.size;
    header.dpi = options.dpi;
    header.name = path.string();
    const BandLayout bands = chooseBands(plan.size, header.format, header.layout, options);
    header.bandRows = bands.rows;
    header.layout.backdrop = makeBackdrop(options, header.layout, plan.size);

    const DrawnAnnotations annotations = annotationsOf(plan, options);
    ExportFacts facts;
    facts.size = plan.size;
    facts.annotations = annotations.count();
    removeStaleParts(path);
    PendingFile file(path);
    PictureWriter writer(header, file.stream());
    const MarkedPicture picture(plan, backend, task);
    facts.dots = picture.dots();
    facts.strokes = picture.strokes();
    task.beginPhase("Rendering");
    std::optional<FinishedBands> kept;
    if (options.resumable) {
        kept.emplace(path, exportKey(plan, backend, options, path.extension().string(), bands));
    }
    BandPipeline pipeline({picture, annotations, plan.size, header.layout, bands, kept ? &*kept : nullptr}, writer,
                          task);
    pipeline.run(facts, [&] { file.check(); });
    task.beginPhase("Writing");
    try {
        writer.finish();
    } catch (const Error&) {
        file.check();
        throw;
    }
    task.throwIfCancelled();
    file.commit();
    if (kept) {
        kept->remove();
    }
    return facts;
}

} // namespace

std::size_t exportMemory(const std::string& ending, glm::ivec2 size, const PictureOptions& options) {
    const std::filesystem::path path = "picture." + ending;
    const PictureFormat format = vectorFormatOf(path) ? PictureFormat::png : pictureFormatOf(path);
    checkSize(format, size, {});
    return chooseBands(size, format, pixelLayout(format, options), options).bytes;
}

void forgetUnfinished(const std::filesystem::path& picture) {
    std::error_code ignored;
    std::filesystem::remove(FinishedBands::fileFor(picture), ignored);
}

ExportFacts exportPicture(const RenderPlan& plan, const Backend& backend, const std::filesystem::path& path,
                          const PictureOptions& options, Task& task) {
    const auto start = std::chrono::steady_clock::now();
    const bool vector = vectorFormatOf(path).has_value();
    checkSize(vector ? PictureFormat::png : pictureFormatOf(path), plan.size, path.string()); // 0 is checked here too
    checkExport(path, plan.size, options);
    task.throwIfCancelled();
    ExportFacts facts = vector ? writeVectorFile(plan, backend, path, options, task)
                               : writePictureFile(plan, backend, path, options, task);
    warnOfNotFinite(facts, task);
    facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return facts;
}

std::vector<std::uint8_t> toRgba8(const Picture& picture, const PictureOptions& options) {
    PixelLayout layout;
    layout.background = options.background;
    layout.alpha = options.transparent ? AlphaForm::unassociated : AlphaForm::opaque;
    layout.backdrop = makeBackdrop(options, layout, picture.size());
    std::vector<std::uint8_t> out(static_cast<std::size_t>(picture.size().x) *
                                  static_cast<std::size_t>(picture.size().y) * 4);
    writePixels(picture, layout, {std::as_writable_bytes(std::span(out)), picture.size().x, {0, 0}});
    return out;
}

std::vector<std::byte> encodePng(const Picture& picture, const PictureOptions& options) {
    PictureHeader header;
    header.layout = pixelLayout(PictureFormat::png, options);
    header.size = picture.size();
    header.dpi = options.dpi;
    header.name = "picture.png";
    checkSize(header.format, header.size, header.name);
    header.layout.backdrop = makeBackdrop(options, header.layout, header.size);
    std::vector<std::byte> rows(static_cast<std::size_t>(header.size.x) * static_cast<std::size_t>(header.size.y) *
                                header.layout.bytesPerPixel());
    writePixels(picture, header.layout, {rows, header.size.x, {0, 0}});
    const MemoryStream memory;
    PictureWriter writer(header, memory.stream());
    writer.writeRows(rows, header.size.y);
    writer.finish();
    return {memory.bytes().begin(), memory.bytes().end()};
}

std::vector<std::byte> renderPng(const RenderPlan& plan, const Backend& backend, const PictureOptions& options,
                                 Task& task) {
    const Tile whole{{0, 0}, plan.size};
    Picture picture = MarkedPicture(plan, backend, task).render(whole, task).picture;
    layAnnotations(annotationsOf(plan, options), plan.size, whole, picture);
    return encodePng(picture, options);
}

} // namespace limner
