#include "core/base/error.h"
#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"

#include <OpenImageIO/imageio.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

// Stacks of TIFF or PNG pictures and TIFFs of several pages, through OpenImageIO.

namespace limner::importing {

namespace {

namespace fs = std::filesystem;

bool isPicture(const fs::path& path) {
    const std::string ending = lowered(path.extension().string());
    return ending == ".png" || ending == ".tif" || ending == ".tiff";
}

/// "slice_2" before "slice_10": runs of digits compare as numbers.
bool naturallyBefore(const std::string& a, const std::string& b) {
    std::size_t i = 0;
    std::size_t j = 0;
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    while (i < a.size() && j < b.size()) {
        if (!isDigit(a[i]) || !isDigit(b[j])) {
            if (a[i] != b[j]) {
                return a[i] < b[j];
            }
            ++i;
            ++j;
            continue;
        }
        const auto run = [&](const std::string& text, std::size_t& at) {
            const std::size_t from = std::min(text.find_first_not_of('0', at), text.size());
            at = from;
            while (at < text.size() && isDigit(text[at])) {
                ++at;
            }
            return text.substr(from, at - from);
        };
        const std::string x = run(a, i);
        const std::string y = run(b, j);
        if (x != y) {
            return x.size() != y.size() ? x.size() < y.size() : x < y;
        }
    }
    return a.size() - i < b.size() - j;
}

/// A name with its digits struck out: pictures of one stack have the same.
std::string patternOf(const fs::path& path) {
    std::string pattern = path.filename().string();
    pattern.erase(std::remove_if(pattern.begin(), pattern.end(), [](char c) { return c >= '0' && c <= '9'; }),
                  pattern.end());
    return lowered(pattern);
}

std::vector<fs::path> picturesOf(const Context& context, const fs::path& folder) {
    std::vector<fs::path> pictures;
    std::error_code failed;
    constexpr std::size_t kMost = static_cast<std::size_t>(kLargestAxis);
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
        std::error_code unread;
        if (it->is_regular_file(unread) && isPicture(it->path())) {
            pictures.push_back(it->path());
        }
        if (pictures.size() > kMost) {
            context.refuse("the folder holds more than " + std::to_string(kMost) + " pictures");
        }
    }
    std::sort(pictures.begin(), pictures.end(), [](const fs::path& a, const fs::path& b) {
        return naturallyBefore(a.filename().string(), b.filename().string());
    });
    return pictures;
}

struct Page {
    fs::path file;
    int index = 0; ///< of the file's pages
};

struct PageShape {
    int width = 0;
    int height = 0;
    int channels = 1;
    ScalarType type = ScalarType::uint8;
    OIIO::TypeDesc format; ///< the same, in OpenImageIO's words
};

ScalarType typeOf(const Context& context, const OIIO::TypeDesc& format) {
    switch (format.basetype) {
    case OIIO::TypeDesc::UINT8: return ScalarType::uint8;
    case OIIO::TypeDesc::INT8: return ScalarType::int8;
    case OIIO::TypeDesc::UINT16: return ScalarType::uint16;
    case OIIO::TypeDesc::INT16: return ScalarType::int16;
    case OIIO::TypeDesc::UINT32: return ScalarType::uint32;
    case OIIO::TypeDesc::INT32: return ScalarType::int32;
    case OIIO::TypeDesc::FLOAT: return ScalarType::float32;
    case OIIO::TypeDesc::DOUBLE: return ScalarType::float64;
    default: context.refuse("its pictures have a type of numbers that Limner does not read");
    }
}

std::unique_ptr<OIIO::ImageInput> open(const Context& context, const fs::path& file) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1); // numbers as stored
    auto input = OIIO::ImageInput::open(file.string(), &config);
    if (!input) {
        const std::string why = OIIO::geterror();
        context.refuse(file.filename().string() + " cannot be read as a picture" +
                           (why.empty() ? "" : " (" + why.substr(0, 200) + ")"),
                       "copy or export it anew");
    }
    return input;
}

/// Shape of a page, checked against what its file can hold.
PageShape shapeOf(const Context& context, const OIIO::ImageSpec& spec, const fs::path& file) {
    PageShape shape{spec.width, spec.height, spec.nchannels, typeOf(context, spec.format), spec.format};
    const std::array<std::int64_t, 3> dims = {spec.width, spec.height, spec.nchannels};
    const std::uint64_t bytes = checkedVoxels(context, dims, shape.type) * bytesPerScalar(shape.type);
    constexpr std::uint64_t kDeflateRatio = 1032; // nothing these formats are written with does better on real pictures
    if (bytes > (fileLength(context, file) + 1) * kDeflateRatio) {
        context.refuse(file.filename().string() + " promises " + std::to_string(bytes) + " bytes that it cannot hold");
    }
    return shape;
}

/// Pages of one file.
int countPages(const Context& context, OIIO::ImageInput& input, const fs::path& file) {
    const auto most = static_cast<int>(
        std::min<std::uint64_t>(static_cast<std::uint64_t>(kLargestAxis),
                                fileLength(context, file) / 8)); // a page's directory takes more than that
    int pages = 1;
    while (pages < most && input.seek_subimage(pages, 0)) {
        context.task.throwIfCancelled();
        ++pages;
    }
    input.geterror(); // "no such page" is the end, no problem
    return pages;
}

void readPage(const Context& context, OIIO::ImageInput& input, const Page& page, const PageShape& shape,
              std::span<std::byte> out) {
    const OIIO::ImageSpec spec = input.spec_dimensions(page.index, 0);
    if (spec.width != shape.width || spec.height != shape.height || spec.nchannels != shape.channels) {
        context.refuse("its pictures differ in size: " + std::to_string(shape.width) + "x" +
                           std::to_string(shape.height) + " and " + std::to_string(spec.width) + "x" +
                           std::to_string(spec.height) + " (" + page.file.filename().string() + ")",
                       "keep pictures of one size in the folder");
    }
    constexpr int kFirstChannel = 0;
    if (spec.format != shape.format ||
        !input.read_image(page.index, 0, kFirstChannel, kFirstChannel + 1, shape.format, out.data())) {
        context.refuse(page.file.filename().string() + " is damaged (" + input.geterror().substr(0, 200) + ")",
                       "copy or export it anew");
    }
}

/// Spacing that a TIFF's tags give, in mm: resolution with a unit, or ImageJ's description.
glm::dvec3 spacingOf(Context& context, const OIIO::ImageSpec& spec) {
    const double x = spec.get_float_attribute("XResolution", 0);
    const double y = spec.get_float_attribute("YResolution", 0);
    const std::string unit = spec.get_string_attribute("ResolutionUnit", "none");
    const std::string description = spec.get_string_attribute("ImageDescription", "");
    std::map<std::string, std::string> imageJ;
    for (const std::string_view line : words(description, "\n\r")) {
        if (const std::size_t equals = line.find('='); equals != std::string_view::npos) {
            imageJ[std::string(line.substr(0, equals))] = line.substr(equals + 1);
        }
    }
    double mm = unit == "cm" ? 10 : unit == "in" ? 25.4 : 0;
    const bool isImageJ = imageJ.contains("ImageJ");
    if (isImageJ) {
        const std::string& name = imageJ["unit"];
        mm = name == "mm"                                             ? 1
             : name == "cm"                                           ? 10
             : name == "um" || name == "micron" || name == "\\u00B5m" ? 0.001
             : name == "inch"                                         ? 25.4
                                                                      : 0;
    }
    constexpr double kLargestMm = 1e3;
    constexpr double kSmallestMm = 1e-6;
    glm::dvec3 spacing(1);
    // 72 and 96 dots per inch are what programs write that know nothing of size.
    const bool byHabit = !isImageJ && unit == "in" && (x == 72 || x == 96 || x == 300);
    const bool known = mm > 0 && x > 0 && y > 0 && !byHabit && mm / x < kLargestMm && mm / x > kSmallestMm &&
                       mm / y < kLargestMm && mm / y > kSmallestMm;
    if (!known) {
        context.warn("the pictures give no spacing; 1 mm was taken");
        return spacing;
    }
    spacing.x = mm / x;
    spacing.y = mm / y;
    const double step = parseNumber(imageJ["spacing"]).value_or(0) * mm;
    if (isImageJ && std::abs(step) > kSmallestMm && std::abs(step) < kLargestMm) {
        spacing.z = std::abs(step);
    } else {
        spacing.z = spacing.x;
        context.warn("the pictures give no distance between slices; that between pixels was taken");
    }
    return spacing;
}

std::vector<Page> pagesOf(const Context& context, const std::vector<fs::path>& files, OIIO::ImageInput& first) {
    std::vector<Page> pages;
    if (files.size() == 1) {
        const int count = countPages(context, first, files[0]);
        for (int i = 0; i < count; ++i) {
            pages.push_back({files[0], i});
        }
        return pages;
    }
    for (const fs::path& file : files) {
        pages.push_back({file, 0});
    }
    return pages;
}

/// The stack that one picture is part of; the picture alone where it has pages or no companions.
std::vector<fs::path> stackOf(const Context& context) {
    if (fs::is_directory(context.path)) {
        return picturesOf(context, context.path);
    }
    const auto input = open(context, context.path);
    if (countPages(context, *input, context.path) > 1) {
        return {context.path};
    }
    const fs::path folder = context.path.has_parent_path() ? context.path.parent_path() : fs::path(".");
    std::vector<fs::path> stack;
    for (const fs::path& picture : picturesOf(context, folder)) {
        if (patternOf(picture) == patternOf(context.path)) {
            stack.push_back(picture);
        }
    }
    const std::string name = context.path.stem().string();
    const bool numberedName = std::any_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
    return numberedName && stack.size() > 1 ? stack : std::vector<fs::path>{context.path};
}

void readPages(Context& context, const std::vector<Page>& pages, const PageShape& shape, ByteBuffer& values) {
    const std::size_t pageBytes = values.size() / pages.size();
    std::atomic<std::size_t> done{0};
    std::mutex mutex;
    std::exception_ptr thrown;
    const bool oneFile = pages.front().file == pages.back().file;
    // Pages of one file are read in order by one reader: seeking back would read the directories again.
    const std::size_t jobs = oneFile ? 1 : pages.size();
    tbb::parallel_for(std::size_t{0}, jobs, [&](std::size_t job) {
        try {
            const std::size_t first = oneFile ? 0 : job;
            const std::size_t last = oneFile ? pages.size() : job + 1;
            const auto input = open(context, pages[first].file);
            for (std::size_t i = first; i < last; ++i) {
                context.task.throwIfCancelled();
                readPage(context, *input, pages[i], shape, values.span().subspan(i * pageBytes, pageBytes));
                context.task.progress(static_cast<double>(++done) / static_cast<double>(pages.size()));
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            thrown = thrown ? thrown : std::current_exception();
        }
    });
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

} // namespace

bool isPictureFolder(const fs::path& folder) {
    std::error_code failed;
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
        if (isPicture(it->path())) {
            return true;
        }
    }
    return false;
}

StoredVolume readPictures(Context& context) {
    const std::vector<fs::path> files = stackOf(context);
    if (files.empty()) {
        context.refuse("the folder holds no TIFF or PNG pictures");
    }
    const auto first = open(context, files[0]);
    const OIIO::ImageSpec spec = first->spec();
    const PageShape shape = shapeOf(context, spec, files[0]);
    const std::vector<Page> pages = pagesOf(context, files, *first);
    StoredVolume stored;
    stored.type = shape.type;
    const std::array<std::int64_t, 4> all = {shape.width, shape.height, static_cast<std::int64_t>(pages.size()),
                                             shape.channels};
    checkedVoxels(context, all, shape.type);
    stored.dims = checkedDims(context, std::span(all).first(3), shape.type);
    const auto components = static_cast<std::uint64_t>(shape.channels);
    expectComponents(context, components, std::to_string(components) + " colours per pixel");
    const glm::dvec3 spacing = spacingOf(context, spec);
    for (int i = 0; i < 3; ++i) {
        stored.axesMm[i] *= spacing[i];
    }
    checkGeometry(context, stored);
    const std::uint64_t count = checkedVoxels(context, std::span(all).first(3), shape.type); // of the first channel
    stored.values = ByteBuffer(count * bytesPerScalar(shape.type));
    readPages(context, pages, shape, stored.values);
    const bool tiff = lowered(files[0].extension().string()).starts_with(".tif");
    context.report.format = files.size() > 1   ? (tiff ? "TIFF stack" : "PNG stack")
                            : pages.size() > 1 ? "multi-page TIFF"
                            : tiff             ? "TIFF"
                                               : "PNG";
    return stored;
}

} // namespace limner::importing
