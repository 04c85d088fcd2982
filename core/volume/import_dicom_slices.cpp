#include "core/volume/import_bytes.h"
#include "core/volume/import_dicom.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace limner::importing {

namespace {

constexpr std::uint32_t kShared = dicomTag(0x5200, 0x9229);
constexpr std::uint32_t kPerFrame = dicomTag(0x5200, 0x9230);
constexpr std::uint32_t kPlanePosition = dicomTag(0x0020, 0x9113);
constexpr std::uint32_t kPlaneOrientation = dicomTag(0x0020, 0x9116);
constexpr std::uint32_t kPixelMeasures = dicomTag(0x0028, 0x9110);
constexpr std::uint32_t kValueTransformation = dicomTag(0x0028, 0x9145);

bool allFinite(const std::vector<double>& numbers) {
    for (const double number : numbers) {
        if (!std::isfinite(number) || std::abs(number) > 1e9) { // no patient is 1000 km away
            return false;
        }
    }
    return true;
}

/// Position and orientation, from the plain attributes or from a functional group's items.
void placeSlice(DicomSlice& slice, const DicomDataSet* positions, const DicomDataSet* orientations) {
    const auto position = positions != nullptr ? positions->decimals(dicomTag(0x0020, 0x0032)) : std::vector<double>();
    const auto orientation =
        orientations != nullptr ? orientations->decimals(dicomTag(0x0020, 0x0037)) : std::vector<double>();
    if (position.size() < 3 || orientation.size() < 6 || !allFinite(position) || !allFinite(orientation)) {
        return;
    }
    const glm::dvec3 row(orientation[0], orientation[1], orientation[2]);
    const glm::dvec3 column(orientation[3], orientation[4], orientation[5]);
    constexpr double kShort = 1e-3; // directions are unit vectors
    if (glm::length(row) < kShort || glm::length(column) < kShort ||
        glm::length(glm::cross(glm::normalize(row), glm::normalize(column))) < 0.5) {
        return;
    }
    slice.placed = true;
    slice.positionMm = {position[0], position[1], position[2]};
    slice.rowDirection = glm::normalize(row);
    slice.columnDirection = glm::normalize(column);
}

void spaceSlice(const Context& context, DicomSlice& slice, const DicomDataSet* measures) {
    if (measures == nullptr) {
        return;
    }
    auto spacing = measures->decimals(dicomTag(0x0028, 0x0030));
    if (spacing.size() < 2) {
        spacing = measures->decimals(dicomTag(0x0018, 0x1164)); // imager pixel spacing
    }
    if (spacing.size() >= 2) {
        checkSpacing(context, spacing[0]);
        checkSpacing(context, spacing[1]);
        slice.spaced = true;
        slice.spacingMm = {spacing[1], spacing[0]}; // PixelSpacing gives the distance of rows first
    }
    const double between = std::abs(measures->decimal(dicomTag(0x0018, 0x0088)).value_or(0));
    const double thickness = std::abs(measures->decimal(dicomTag(0x0018, 0x0050)).value_or(0));
    slice.thicknessMm = between > 0 ? between : thickness;
}

void scaleSlice(const Context& context, DicomSlice& slice, const DicomDataSet* transformation) {
    if (transformation == nullptr) {
        return;
    }
    const auto slope = transformation->decimal(dicomTag(0x0028, 0x1053));
    const auto intercept = transformation->decimal(dicomTag(0x0028, 0x1052));
    if ((slope && !std::isfinite(*slope)) || (intercept && !std::isfinite(*intercept))) {
        context.refuse("its rescale slope and intercept are no numbers");
    }
    if (slope && *slope != 0) {
        slice.slope = *slope;
    }
    slice.intercept = intercept.value_or(0);
    slice.unit = transformation->text(dicomTag(0x0028, 0x1054));
}

void setPadding(DicomSlice& slice, const DicomDataSet& data) {
    const auto padding = data.number16(dicomTag(0x0028, 0x0120));
    if (!padding || slice.pixels.floatBits != 0) {
        return;
    }
    const auto stored = [&](std::uint16_t number) {
        return slice.pixels.isSigned ? static_cast<double>(static_cast<std::int16_t>(number))
                                     : static_cast<double>(number);
    };
    const auto limit = data.number16(dicomTag(0x0028, 0x0121));
    const double a = stored(*padding);
    const double b = limit ? stored(*limit) : a;
    slice.paddingLow = std::min(a, b);
    slice.paddingHigh = std::max(a, b);
}

/// A functional group's first item for a frame: per frame where given, else shared, else the data set itself.
const DicomDataSet* groupOf(const DicomDataSet& data, int frame, std::uint32_t group) {
    const DicomElement* perFrame = data.find(kPerFrame);
    if (perFrame != nullptr && static_cast<std::size_t>(frame) < perFrame->items.size()) {
        if (const DicomDataSet* item = perFrame->items[static_cast<std::size_t>(frame)].item(group)) {
            return item;
        }
    }
    const DicomDataSet* shared = data.item(kShared);
    const DicomDataSet* item = shared != nullptr ? shared->item(group) : nullptr;
    return item != nullptr ? item : &data;
}

} // namespace

std::vector<DicomSlice> describeDicom(const Context& context, const DicomFile& file,
                                      const std::filesystem::path& path) {
    const DicomDataSet& data = file.data;
    DicomSlice common;
    common.pixels = dicomPixelsOf(context, file);
    checkDicomPixels(context, file, common.pixels, path.filename().string());
    common.file = path;
    common.seriesUid = data.text(dicomTag(0x0020, 0x000e));
    common.description = data.text(dicomTag(0x0008, 0x103e));
    common.modality = data.text(dicomTag(0x0008, 0x0060));
    common.sopUid = data.text(dicomTag(0x0008, 0x0018));
    common.instance = data.decimal(dicomTag(0x0020, 0x0013)).value_or(0);
    setPadding(common, data);
    std::vector<DicomSlice> slices;
    for (int frame = 0; frame < common.pixels.frames; ++frame) {
        DicomSlice slice = common;
        slice.frame = frame;
        placeSlice(slice, groupOf(data, frame, kPlanePosition), groupOf(data, frame, kPlaneOrientation));
        spaceSlice(context, slice, groupOf(data, frame, kPixelMeasures));
        scaleSlice(context, slice, groupOf(data, frame, kValueTransformation));
        slices.push_back(std::move(slice));
    }
    return slices;
}

} // namespace limner::importing
