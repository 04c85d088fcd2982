#pragma once

#include "core/volume/import_parts.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// DICOM files (PS3.5, PS3.10). Internal to core/volume: import_dicom*.cpp.
///
/// The data set is parsed here and not by GDCM: the packaged GDCM ends the process by assertion on damaged files, and a
/// length has to be checked against the file before anything is allocated. GDCM decodes the compressed pixels.
namespace limner::importing {

constexpr std::uint32_t dicomTag(std::uint32_t group, std::uint32_t element) { return group << 16 | element; }

struct DicomDataSet;

struct DicomElement {
    std::span<const std::byte> value;                  ///< empty for sequences
    std::vector<DicomDataSet> items;                   ///< of a sequence
    std::vector<std::span<const std::byte>> fragments; ///< of encapsulated pixels; the first is the offset table
    bool encapsulated = false;
    bool cutOff = false; ///< the last fragment is shorter than it says
};

/// Elements that are read, and typed access to them.
struct DicomDataSet {
    std::map<std::uint32_t, DicomElement> elements;
    bool bigEndian = false;

    [[nodiscard]] const DicomElement* find(std::uint32_t tag) const;
    [[nodiscard]] std::string text(std::uint32_t tag) const;             ///< trimmed; empty where absent
    [[nodiscard]] std::vector<double> decimals(std::uint32_t tag) const; ///< DS and IS
    [[nodiscard]] std::optional<double> decimal(std::uint32_t tag) const;
    [[nodiscard]] std::optional<std::uint16_t> number16(std::uint32_t tag) const;
    /// First item of a sequence.
    [[nodiscard]] const DicomDataSet* item(std::uint32_t tag) const;
};

/// A parsed file; its spans point into `bytes`.
struct DicomFile {
    ByteBuffer bytes;
    ByteBuffer inflated; ///< data set of the deflated transfer syntax
    std::string transferSyntax;
    DicomDataSet data;
};

/// Whether a file starts as DICOM does, with or without a preamble.
bool looksLikeDicom(const std::filesystem::path& path);

/// Parses a file; nothing where it is no DICOM data set.
std::optional<DicomFile> parseDicom(const Context& context, const std::filesystem::path& path);

/// How one file's pixels are stored.
struct DicomPixels {
    int rows = 0;
    int columns = 0;
    int frames = 1;
    int samples = 1;
    bool planar = false;
    int bitsAllocated = 16;
    int bitsStored = 16;
    int highBit = 15;
    bool isSigned = false;
    int floatBits = 0; ///< 32 or 64 for float pixel data
    std::string photometric;

    [[nodiscard]] ScalarType scalar() const; ///< what `readDicomFrame` writes
    [[nodiscard]] std::size_t framePixels() const {
        return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    }
};

/// Refuses what cannot be pixels.
DicomPixels dicomPixelsOf(const Context& context, const DicomFile& file);

/// Whether the file can hold its pixels; checked before a frame is decoded. Refuses with the file's name.
void checkDicomPixels(const Context& context, const DicomFile& file, const DicomPixels& pixels,
                      const std::string& name);

/// Decodes one frame to `framePixels()` numbers of `scalar()`: unused bits masked, sign extended, first sample of
/// colour.
void readDicomFrame(const Context& context, const DicomFile& file, const DicomPixels& pixels, int frame,
                    std::span<std::byte> out);

/// One picture of a series.
struct DicomSlice {
    std::filesystem::path file;
    int frame = 0;
    std::string seriesUid;
    std::string description;
    std::string modality;
    std::string sopUid;
    std::string unit; ///< rescale type
    DicomPixels pixels;
    bool placed = false; ///< position and orientation are known
    bool spaced = false; ///< pixel spacing is known
    glm::dvec3 positionMm{0};
    glm::dvec3 rowDirection{1, 0, 0};    ///< along a row: columns grow
    glm::dvec3 columnDirection{0, 1, 0}; ///< down a column: rows grow
    glm::dvec2 spacingMm{1};             ///< between columns, between rows
    double thicknessMm = 0;              ///< spacing between slices, or thickness, where said; else 0
    double instance = 0;
    double slope = 1;
    double intercept = 0;
    std::optional<double> paddingLow; ///< stored numbers in [paddingLow, paddingHigh] are padding
    double paddingHigh = 0;
};

/// The frames of a parsed file.
std::vector<DicomSlice> describeDicom(const Context& context, const DicomFile& file, const std::filesystem::path& path);

} // namespace limner::importing
