#include "core/volume/import_dicom.h"

#include "core/base/error.h"
#include "core/volume/import_bytes.h"

#include <glm/geometric.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <functional>
#include <mutex>
#include <set>
#include <utility>

namespace limner::importing {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 100000; // of a folder; the largest studies have some ten thousand

/// Files of a folder; those of its subfolders only where it has no DICOM itself (discs: DICOMDIR over folders).
std::vector<fs::path> filesOf(const Context& context, const fs::path& folder, int depth) {
    std::vector<fs::path> files;
    std::vector<fs::path> folders;
    std::error_code failed;
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
        context.task.throwIfCancelled();
        std::error_code unread;
        if (it->is_directory(unread)) {
            folders.push_back(it->path());
        } else if (it->is_regular_file(unread) && it->path().filename() != "DICOMDIR" && looksLikeDicom(it->path())) {
            files.push_back(it->path());
        }
        if (files.size() + folders.size() > kMostFiles) {
            context.refuse("the folder has more than " + std::to_string(kMostFiles) + " files",
                           "open the folder of one series");
        }
    }
    if (failed) {
        context.refuse("the folder cannot be read");
    }
    std::sort(files.begin(), files.end());
    std::sort(folders.begin(), folders.end());
    constexpr int kDeepest = 6; // patient, study, series and a little more
    if (files.empty() && depth < kDeepest) {
        for (const fs::path& inner : folders) {
            const auto more = filesOf(context, inner, depth + 1);
            files.insert(files.end(), more.begin(), more.end());
        }
    }
    return files;
}

/// Runs `body(i)` for all i in parallel; the first exception (by index) comes out.
void forAll(std::size_t count, const std::function<void(std::size_t)>& body) {
    std::mutex mutex;
    std::size_t worst = count;
    std::exception_ptr thrown;
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        {
            const std::lock_guard lock(mutex);
            if (worst < i) {
                return;
            }
        }
        try {
            body(i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (i < worst) {
                worst = i;
                thrown = std::current_exception();
            }
        }
    });
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

std::vector<DicomSlice> scan(Context& context, const std::vector<fs::path>& files) {
    std::vector<std::vector<DicomSlice>> found(files.size());
    std::vector<std::string> problems(files.size());
    forAll(files.size(), [&](std::size_t i) {
        context.task.throwIfCancelled();
        try {
            if (const auto parsed = parseDicom(context, files[i])) {
                found[i] = describeDicom(context, *parsed, files[i]);
            }
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::cancelled) {
                throw;
            }
            problems[i] = error.text().why;
        }
        context.task.progress(0.3 * static_cast<double>(i + 1) / static_cast<double>(files.size()));
    });
    std::vector<DicomSlice> slices;
    std::size_t unread = 0;
    std::string firstProblem;
    for (std::size_t i = 0; i < files.size(); ++i) {
        slices.insert(slices.end(), std::make_move_iterator(found[i].begin()), std::make_move_iterator(found[i].end()));
        if (!problems[i].empty()) {
            ++unread;
            firstProblem = firstProblem.empty() ? files[i].filename().string() + ": " + problems[i] : firstProblem;
        }
    }
    if (slices.empty() && unread > 0) {
        context.refuse(files.size() == 1 ? firstProblem.substr(firstProblem.find(": ") + 2) : firstProblem);
    }
    if (unread > 0) {
        context.warn(std::to_string(unread) + " files were left out (" + firstProblem + ")");
    }
    return slices;
}

/// Slices that can lie in one volume: same series, size, orientation and pixel format.
bool belongTogether(const DicomSlice& a, const DicomSlice& b) {
    constexpr double kAligned = 0.999; // 2.5 degrees: scout views are at right angles
    return a.seriesUid == b.seriesUid && a.pixels.rows == b.pixels.rows && a.pixels.columns == b.pixels.columns &&
           a.pixels.samples == b.pixels.samples && a.pixels.scalar() == b.pixels.scalar() && a.placed == b.placed &&
           (!a.placed || (glm::dot(a.rowDirection, b.rowDirection) > kAligned &&
                          glm::dot(a.columnDirection, b.columnDirection) > kAligned));
}

using Series = std::vector<DicomSlice>;

std::vector<Series> group(std::vector<DicomSlice> slices) {
    std::vector<Series> all;
    for (DicomSlice& slice : slices) {
        const auto found = std::find_if(all.rbegin(), all.rend(),
                                        [&](const Series& series) { return belongTogether(series.front(), slice); });
        if (found == all.rend()) {
            all.emplace_back();
            all.back().push_back(std::move(slice));
        } else {
            found->push_back(std::move(slice));
        }
    }
    // The largest first; equal ones in the order of their files.
    std::stable_sort(all.begin(), all.end(), [](const Series& a, const Series& b) { return a.size() > b.size(); });
    return all;
}

std::string inWords(const std::vector<Series>& all) {
    std::string text;
    for (std::size_t i = 0; i < all.size() && i < 8; ++i) { // more would not be one line
        const DicomSlice& first = all[i].front();
        text += (i > 0 ? ", " : "") + std::to_string(i + 1) + ": " + first.modality + " " +
                std::to_string(first.pixels.columns) + "x" + std::to_string(first.pixels.rows) + "x" +
                std::to_string(all[i].size()) + (first.description.empty() ? "" : " '" + first.description + "'");
    }
    return text + (all.size() > 8 ? ", ..." : "");
}

Series choose(Context& context, std::vector<Series> all) {
    for (const Series& series : all) {
        const DicomSlice& first = series.front();
        context.report.series.push_back(
            {first.seriesUid, first.description, first.modality, static_cast<int>(series.size())});
    }
    const std::string& wanted = context.options.series;
    if (wanted.empty()) {
        if (all.size() > 1) {
            context.warn("the largest of " + std::to_string(all.size()) + " series was read (" + inWords(all) + ")");
        }
        return std::move(all.front());
    }
    const auto number = parseInteger(wanted);
    if (number && *number >= 1 && *number <= static_cast<std::int64_t>(all.size())) {
        return std::move(all[static_cast<std::size_t>(*number) - 1]);
    }
    for (Series& series : all) {
        if (series.front().seriesUid == wanted) {
            return std::move(series);
        }
    }
    throw Error(ErrorKind::usage, {"cannot choose the series", context.path.filename().string(),
                                   "there is no series " + wanted.substr(0, 80) + " among " + inWords(all),
                                   "give its number or its UID"});
}

double alongNormal(const DicomSlice& slice, const glm::dvec3& normal) { return glm::dot(slice.positionMm, normal); }

/// Order along the normal, duplicates dropped.
void sortSlices(Context& context, Series& series) {
    const bool placed = series.front().placed;
    const glm::dvec3 normal = glm::normalize(glm::cross(series.front().rowDirection, series.front().columnDirection));
    std::stable_sort(series.begin(), series.end(), [&](const DicomSlice& a, const DicomSlice& b) {
        const double along = placed ? alongNormal(a, normal) - alongNormal(b, normal) : 0;
        constexpr double kSamePlaceMm = 1e-4; // text of positions has about six digits
        if (std::abs(along) > kSamePlaceMm) {
            return along < 0;
        }
        return std::pair(a.instance, a.frame) < std::pair(b.instance, b.frame);
    });
    if (!placed) {
        return;
    }
    const std::size_t before = series.size();
    constexpr double kSamePlaceMm = 1e-3;
    const auto last = std::unique(series.begin(), series.end(), [&](const DicomSlice& a, const DicomSlice& b) {
        return std::abs(alongNormal(a, normal) - alongNormal(b, normal)) < kSamePlaceMm;
    });
    series.erase(last, series.end());
    if (series.size() < before) {
        context.warn(std::to_string(before - series.size()) + " of " + std::to_string(before) +
                     " slices lie at the place of another and were left out");
    }
}

/// Says where slices are missing: a gap that is a whole multiple of the usual one.
void noticeGaps(Context& context, const Series& series) {
    if (!series.front().placed || series.size() < 3) {
        return;
    }
    const glm::dvec3 normal = glm::normalize(glm::cross(series.front().rowDirection, series.front().columnDirection));
    std::vector<double> gaps;
    for (std::size_t i = 1; i < series.size(); ++i) {
        gaps.push_back(alongNormal(series[i], normal) - alongNormal(series[i - 1], normal));
    }
    std::vector<double> sorted = gaps;
    std::sort(sorted.begin(), sorted.end());
    const double usual = sorted[sorted.size() / 2];
    int missing = 0;
    int odd = 0;
    for (const double gap : gaps) {
        constexpr double kAlike = 0.05;
        const double times = gap / usual;
        if (std::abs(times - 1) > kAlike) {
            const bool multiple = times > 1.5 && times < 1000 && std::abs(times - std::round(times)) < kAlike;
            missing += multiple ? static_cast<int>(std::round(times)) - 1 : 0;
            odd += multiple ? 0 : 1;
        }
    }
    // Scans with thinner slices over a part have many odd gaps; a lost file leaves a multiple.
    if (missing > 0 && odd == 0) {
        context.warn(std::to_string(missing) + " slices seem to be missing");
    }
}

void place(Context& context, const Series& series, StoredVolume& stored) {
    const DicomSlice& first = series.front();
    glm::dvec2 spacing = first.spacingMm;
    if (!first.spaced) {
        context.warn("the files give no pixel spacing; 1 mm was taken");
    }
    if (!first.placed) {
        context.warn(
            "the files give no position: slices are in order of their instance numbers, 1 mm apart unless said");
    }
    double step = first.thicknessMm;
    if (!(step > 0 && std::isfinite(step))) {
        step = 1;
    }
    const glm::dvec3 normal = glm::normalize(glm::cross(first.rowDirection, first.columnDirection));
    stored.axesMm = glm::dmat3(first.rowDirection * spacing.x, first.columnDirection * spacing.y, normal * step);
    if (first.placed) {
        stored.originMm = first.positionMm;
        for (const DicomSlice& slice : series) {
            stored.sliceOrigins.push_back(slice.positionMm);
        }
        if (series.size() > 1) {
            noticeGaps(context, series);
        }
    }
}

bool sameScaling(const Series& series) {
    return std::all_of(series.begin(), series.end(), [&](const DicomSlice& slice) {
        return slice.slope == series.front().slope && slice.intercept == series.front().intercept;
    });
}

/// Decodes every slice, in parallel over files, to stored numbers.
ByteBuffer decode(Context& context, const Series& series) {
    const DicomPixels& pixels = series.front().pixels;
    const std::size_t sliceBytes = pixels.framePixels() * bytesPerScalar(pixels.scalar());
    ByteBuffer values(sliceBytes * series.size());
    std::map<fs::path, std::vector<std::size_t>> byFile;
    for (std::size_t i = 0; i < series.size(); ++i) {
        byFile[series[i].file].push_back(i);
    }
    const std::vector<std::pair<fs::path, std::vector<std::size_t>>> jobs(byFile.begin(), byFile.end());
    std::atomic<std::size_t> done{0};
    forAll(jobs.size(), [&](std::size_t job) {
        const auto file = parseDicom(context, jobs[job].first);
        if (!file) {
            context.refuse(jobs[job].first.filename().string() + " has changed while it was read");
        }
        forAll(jobs[job].second.size(), [&](std::size_t n) {
            context.task.throwIfCancelled();
            const std::size_t i = jobs[job].second[n];
            readDicomFrame(context, *file, series[i].pixels, series[i].frame,
                           values.span().subspan(i * sliceBytes, sliceBytes));
            context.task.progress(0.3 + 0.7 * static_cast<double>(++done) / static_cast<double>(series.size()));
        });
    });
    return values;
}

/// Values after rescale, as float32: what the hash is of, and what is kept where slices differ in their scaling.
template <typename T>
ByteBuffer rescaled(const Series& series, std::span<const T> values) {
    const std::size_t slice = series.front().pixels.framePixels();
    ByteBuffer result(values.size() * sizeof(float));
    float* out = result.as<float>().data();
    tbb::parallel_for(std::size_t{0}, series.size(), [&](std::size_t k) {
        for (std::size_t i = k * slice; i < (k + 1) * slice; ++i) {
            out[i] = static_cast<float>(static_cast<double>(values[i]) * series[k].slope + series[k].intercept);
        }
    });
    return result;
}

/// Which voxels are padding; empty where none is.
template <typename T>
std::vector<bool> paddingMask(const Series& series, std::span<const T> values) {
    const std::size_t slice = series.front().pixels.framePixels();
    std::vector<bool> mask;
    for (std::size_t k = 0; k < series.size(); ++k) {
        if (!series[k].paddingLow) {
            continue;
        }
        for (std::size_t i = k * slice; i < (k + 1) * slice; ++i) {
            const auto value = static_cast<double>(values[i]);
            if (value >= *series[k].paddingLow && value <= series[k].paddingHigh) {
                mask.resize(values.size());
                mask[i] = true;
            }
        }
    }
    return mask;
}

/// Padding becomes air: the lowest number that is none.
template <typename T>
void airForPadding(std::span<T> values, const std::vector<bool>& mask, bool highIsAir) {
    T air = highIsAir ? std::numeric_limits<T>::lowest() : std::numeric_limits<T>::max();
    bool any = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!mask[i] && !(values[i] != values[i])) {
            air = highIsAir ? std::max(air, values[i]) : std::min(air, values[i]);
            any = true;
        }
    }
    for (std::size_t i = 0; any && i < values.size(); ++i) {
        if (mask[i]) {
            values[i] = air;
        }
    }
}

void setMeaning(Context& context, const Series& series, StoredVolume& stored) {
    const DicomSlice& first = series.front();
    const bool hounsfield = first.unit.empty() || first.unit == "HU" || first.unit == "US";
    stored.modalityKnown = !first.modality.empty();
    stored.modality = first.modality == "CT" && hounsfield ? Modality::ct
                      : first.modality == "MR"             ? Modality::mr
                      : first.modality == "SEG"            ? Modality::labels
                                                           : Modality::unknown;
    if (first.pixels.photometric == "MONOCHROME1" && first.slope > 0) {
        context.warn("the pictures are stored inverted (MONOCHROME1): high values are dark");
    }
}

/// Scaling, hash and padding of decoded numbers.
void settleValues(Context& context, const Series& series, StoredVolume& stored) {
    withScalar(stored.type, [&](auto zero) {
        using T = decltype(zero);
        const std::vector<bool> padding = paddingMask(series, std::as_const(stored.values).as<T>());
        ByteBuffer values = rescaled(series, std::as_const(stored.values).as<T>());
        context.report.sha256Values = sha256(values.span());
        if (sameScaling(series)) {
            stored.slope = series.front().slope;
            stored.intercept = series.front().intercept;
            if (!padding.empty()) {
                airForPadding(stored.values.as<T>(), padding, stored.slope < 0);
            }
        } else {
            stored.values = std::move(values);
            stored.type = ScalarType::float32;
            context.warn("slope and intercept differ between the slices; each was applied to its own");
            if (!padding.empty()) {
                airForPadding(stored.values.as<float>(), padding, false);
            }
        }
    });
}

std::vector<fs::path> inputFiles(const Context& context) {
    if (fs::is_directory(context.path)) {
        return filesOf(context, context.path, 0);
    }
    if (context.path.filename() == "DICOMDIR") {
        const fs::path folder = context.path.has_parent_path() ? context.path.parent_path() : fs::path(".");
        const auto files = filesOf(context, folder, 0);
        if (files.empty()) {
            context.refuse("the DICOMDIR stands alone: no picture files lie beside or below it");
        }
        return files;
    }
    if (!looksLikeDicom(context.path)) {
        context.refuse("it is in no format that Limner reads",
                       "give DICOM, NIfTI, NRRD, MetaImage, VTK, TIFF, PNG, .inv3, or describe raw bytes with --raw");
    }
    return {context.path};
}

} // namespace

StoredVolume readDicom(Context& context) {
    const std::vector<fs::path> files = inputFiles(context);
    if (files.empty()) {
        context.refuse("the folder holds no DICOM files and no pictures that Limner reads");
    }
    std::vector<DicomSlice> slices = scan(context, files);
    if (slices.empty()) {
        context.refuse(files.size() == 1 ? "it is in no format that Limner reads" : "none of its files holds pictures");
    }
    Series series = choose(context, group(std::move(slices)));
    sortSlices(context, series);

    const DicomPixels& pixels = series.front().pixels;
    expectComponents(context, static_cast<std::uint64_t>(pixels.samples), std::to_string(pixels.samples) + " colours");
    if (pixels.photometric == "PALETTE COLOR") {
        expectComponents(context, 2, "palette colours");
    }
    StoredVolume stored;
    stored.type = pixels.scalar();
    const std::int64_t dims[] = {pixels.columns, pixels.rows, static_cast<std::int64_t>(series.size())};
    stored.dims = checkedDims(context, dims, stored.type);
    place(context, series, stored);
    setMeaning(context, series, stored);
    checkGeometry(context, stored);
    stored.values = decode(context, series);
    settleValues(context, series, stored);
    context.report.format = files.size() == 1 && series.size() == 1 ? "DICOM file"
                            : files.size() == 1                     ? "DICOM multi-frame file"
                                                                    : "DICOM series";
    return stored;
}

} // namespace limner::importing
