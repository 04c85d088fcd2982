#include "core/base/error.h"
#include "core/volume/import_bytes.h"
#include "core/volume/import_parts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limner::importing {

namespace {

constexpr double kShorts = 65536; // numbers that 16 bits tell apart

/// What one pass over the numbers tells.
struct Survey {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    std::size_t nonFinite = 0;
    bool whole = true; ///< every finite number is an integer
};

template <typename T>
void look(Survey& survey, std::span<const T> values) {
    if constexpr (std::is_floating_point_v<T>) {
        for (const T value : values) {
            if (!std::isfinite(value)) {
                ++survey.nonFinite;
                continue;
            }
            survey.low = std::min(survey.low, static_cast<double>(value));
            survey.high = std::max(survey.high, static_cast<double>(value));
            survey.whole = survey.whole && std::trunc(value) == value;
        }
    } else {
        T low = std::numeric_limits<T>::max();
        T high = std::numeric_limits<T>::lowest();
        for (const T value : values) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
        survey.low = std::min(survey.low, static_cast<double>(low));
        survey.high = std::max(survey.high, static_cast<double>(high));
    }
}

template <typename T>
Survey surveyOf(std::span<const T> values) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, values.size(), 1 << 16), Survey{},
        [&](const tbb::blocked_range<std::size_t>& range, Survey survey) {
            look(survey, values.subspan(range.begin(), range.size()));
            return survey;
        },
        [](Survey a, const Survey& b) {
            a.low = std::min(a.low, b.low);
            a.high = std::max(a.high, b.high);
            a.nonFinite += b.nonFinite;
            a.whole = a.whole && b.whole;
            return a;
        });
}

template <typename T>
void replaceNonFinite(std::span<T> values, double replacement) {
    if constexpr (std::is_floating_point_v<T>) {
        tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t i) {
            if (!std::isfinite(values[i])) {
                values[i] = static_cast<T>(replacement);
            }
        });
    }
}

/// Width of the range that holds all but a thousandth of the numbers at either end, by a fixed sample.
template <typename T>
double robustRange(std::span<const T> values) {
    constexpr std::size_t kSample = 1 << 18; // a thousandth of it is 262 numbers: steady enough
    const std::size_t stride = std::max<std::size_t>(1, values.size() / kSample);
    std::vector<double> sample;
    sample.reserve(values.size() / stride + 1);
    for (std::size_t i = 0; i < values.size(); i += stride) {
        sample.push_back(static_cast<double>(values[i]));
    }
    const std::size_t tail = sample.size() / 1000;
    const auto at = [&](std::size_t n) {
        std::nth_element(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(n), sample.end());
        return sample[n];
    };
    const double low = at(tail);
    return at(sample.size() - 1 - tail) - low;
}

/// How stored numbers become kept ones: file number = scale * kept + offset.
struct Keeping {
    VoxelType type = VoxelType::int16;
    double scale = 1;
    double offset = 0;
    bool exact = true;
};

template <typename T>
Keeping keepingFor(std::span<const T> values, const Survey& survey, bool labels, const Context& context) {
    if constexpr (sizeof(T) == 1) {
        // Signed bytes stay bytes, moved to start at 0.
        return {VoxelType::uint8, 1, std::is_signed_v<T> ? -128.0 : 0.0, true};
    } else if constexpr (std::is_same_v<T, std::uint16_t>) {
        return {VoxelType::int16, 1, 32768, true};
    } else if constexpr (std::is_same_v<T, std::int16_t>) {
        return {VoxelType::int16, 1, 0, true};
    } else {
        const double range = survey.high - survey.low;
        constexpr double kExactInDouble = 9007199254740992; // 2^53
        const bool exact = std::max(std::abs(survey.low), std::abs(survey.high)) <= kExactInDouble;
        if (survey.whole && exact && range < kShorts) {
            const bool direct = survey.low >= -32768 && survey.high <= 32767;
            return {VoxelType::int16, 1, direct ? 0 : survey.low + 32768, true};
        }
        if (survey.low == survey.high) {
            return {VoxelType::int16, 1, survey.low, true};
        }
        if (labels) {
            context.refuse("its labels are not whole numbers within 65,536 of each other",
                           "renumber the labels, or read it as an ordinary volume");
        }
        if (!std::isfinite(range)) {
            context.refuse("its numbers span more than double precision holds");
        }
        constexpr double kNegligible = 1.0 / 8192; // of the range that matters: finer than any opacity table
        const double step = range / (kShorts - 1);
        // The last test keeps denormal ranges, whose 65,535th part has no digits left, out of 16 bits.
        if (step / 2 < kNegligible * robustRange(values) && step > std::numeric_limits<double>::min()) {
            return {VoxelType::int16, step, survey.low + 32768 * step, false};
        }
        return {VoxelType::float32, range, survey.low, false};
    }
}

/// Writes the kept numbers and returns the largest |file number - kept number|.
template <typename T, typename Kept>
double keep(std::span<const T> values, std::span<Kept> out, const Keeping& keeping) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, values.size(), 1 << 16), 0.0,
        [&](const tbb::blocked_range<std::size_t>& range, double worst) {
            if (keeping.exact) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) {
                    out[i] = static_cast<Kept>(static_cast<double>(values[i]) - keeping.offset);
                }
                return worst;
            }
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const double value = static_cast<double>(values[i]);
                double kept = (value - keeping.offset) / keeping.scale;
                if constexpr (std::is_integral_v<Kept>) {
                    kept = std::clamp(std::round(kept), -32768.0, 32767.0);
                } else {
                    kept = std::clamp(kept, 0.0, 1.0);
                }
                out[i] = static_cast<Kept>(kept);
                worst = std::max(worst, std::abs(static_cast<double>(out[i]) * keeping.scale + keeping.offset - value));
            }
            return worst;
        },
        [](double a, double b) { return std::max(a, b); });
}

/// Air is about -1000 in CT and nothing else is; bounds wide enough for padding and metal.
bool looksLikeHu(const Survey& survey, const StoredVolume& stored) {
    const double low = std::min(stored.slope * survey.low, stored.slope * survey.high) + stored.intercept;
    const double high = std::max(stored.slope * survey.low, stored.slope * survey.high) + stored.intercept;
    return low >= -3100 && low <= -900 && high >= 200 && high <= 32767;
}

void settleModality(StoredVolume& stored, const Survey& survey, const Context& context) {
    if (context.options.labels) {
        stored.modality = Modality::labels;
    } else if (!stored.modalityKnown && looksLikeHu(survey, stored)) {
        stored.modality = Modality::ct;
    }
}

ByteBuffer convert(const StoredVolume& stored, const Keeping& keeping, double& worst) {
    ByteBuffer kept(stored.values.size() / bytesPerScalar(stored.type) * bytesPerVoxel(keeping.type));
    withScalar(stored.type, [&](auto zero) {
        const auto values = stored.values.as<decltype(zero)>();
        // Only the pairs that `keepingFor` chooses: each is a loop of its own.
        if constexpr (sizeof(zero) == 1) {
            worst = keep(values, kept.as<std::uint8_t>(), keeping);
        } else if constexpr (sizeof(zero) == 2) {
            worst = keep(values, kept.as<std::int16_t>(), keeping);
        } else {
            worst = keeping.type == VoxelType::int16 ? keep(values, kept.as<std::int16_t>(), keeping)
                                                     : keep(values, kept.as<float>(), keeping);
        }
    });
    return kept;
}

/// Hash of the numbers as they are in the file, and what they are like; non-finite ones are replaced afterwards.
Survey surveyAndHash(StoredVolume& stored, Context& context) {
    Survey survey;
    tbb::parallel_invoke(
        [&] {
            if (context.report.sha256Values.empty()) {
                context.report.sha256Values = sha256(stored.values.span());
            }
        },
        [&] {
            survey = withScalar(stored.type,
                                [&](auto zero) { return surveyOf(std::as_const(stored.values).as<decltype(zero)>()); });
        });
    const std::size_t voxels = stored.values.size() / bytesPerScalar(stored.type);
    if (survey.nonFinite == voxels) {
        context.refuse("not one of its " + std::to_string(voxels) + " voxels is a finite number");
    }
    if (survey.nonFinite > 0) {
        withScalar(stored.type, [&](auto zero) { replaceNonFinite(stored.values.as<decltype(zero)>(), survey.low); });
        context.warn(std::to_string(survey.nonFinite) +
                     " voxels are not numbers (NaN or infinite) and take the lowest value");
    }
    return survey;
}

} // namespace

ImportedVolume finish(StoredVolume stored, Context& context) {
    context.task.throwIfCancelled();
    checkGeometry(context, stored);
    const Survey survey = surveyAndHash(stored, context);
    settleModality(stored, survey, context);
    straighten(stored, {stored.slope < 0 ? survey.high : survey.low, survey.whole, context.options.labels}, context);
    context.task.throwIfCancelled();

    const Keeping keeping = withScalar(stored.type, [&](auto zero) {
        return keepingFor(std::as_const(stored.values).as<decltype(zero)>(), survey, context.options.labels, context);
    });
    double worst = 0;
    const bool asIs =
        keeping.exact && keeping.offset == 0 && bytesPerVoxel(keeping.type) == bytesPerScalar(stored.type);
    const ByteBuffer kept = asIs ? std::move(stored.values) : convert(stored, keeping, worst);

    Volume::Contents contents;
    contents.grid = gridOf(stored);
    contents.type = keeping.type;
    contents.slope = stored.slope * keeping.scale;
    contents.intercept = stored.slope * keeping.offset + stored.intercept;
    const double ends[2] = {stored.slope * survey.low + stored.intercept,
                            stored.slope * survey.high + stored.intercept};
    contents.range = {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
    contents.nonFinite = survey.nonFinite;
    contents.modality = stored.modality;
    contents.unit = stored.modality == Modality::ct ? "HU" : "";
    if (!std::isfinite(contents.slope) || contents.slope == 0 ||
        !std::isfinite(contents.range.high - contents.range.low)) {
        context.refuse("its numbers, slope and intercept together leave the range of double precision");
    }
    context.report.quantisationError = worst * std::abs(stored.slope);
    context.report.type = nameOf(stored.type);
    return {std::make_shared<const Volume>(std::move(contents), kept.span()), context.report};
}

} // namespace limner::importing
