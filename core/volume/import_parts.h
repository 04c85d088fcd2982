#pragma once

#include "core/base/task.h"
#include "core/volume/import.h"
#include "core/volume/volume.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What the readers of the single formats share. Internal to core/volume: only import*.cpp include it.
namespace limner::importing {

/// Numbers as a file keeps them.
enum class ScalarType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

std::size_t bytesPerScalar(ScalarType type);
const char* nameOf(ScalarType type); ///< "int16", "float32", ...

/// Calls `f(T{})` with the C++ type of `type`.
template <typename F>
decltype(auto) withScalar(ScalarType type, F&& f) {
    switch (type) {
    case ScalarType::uint8: return f(std::uint8_t{});
    case ScalarType::int8: return f(std::int8_t{});
    case ScalarType::uint16: return f(std::uint16_t{});
    case ScalarType::int16: return f(std::int16_t{});
    case ScalarType::uint32: return f(std::uint32_t{});
    case ScalarType::int32: return f(std::int32_t{});
    case ScalarType::uint64: return f(std::uint64_t{});
    case ScalarType::int64: return f(std::int64_t{});
    case ScalarType::float32: return f(float{});
    case ScalarType::float64: break;
    }
    return f(double{});
}

/// Bytes that are not written before they are filled: the pages of a promise that turns out false are never touched.
class ByteBuffer {
  public:
    ByteBuffer() = default;
    explicit ByteBuffer(std::size_t size); ///< throws Error(noResources)

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::byte* data() { return bytes_.get(); }
    [[nodiscard]] const std::byte* data() const { return bytes_.get(); }
    [[nodiscard]] std::span<std::byte> span() { return {bytes_.get(), size_}; }
    [[nodiscard]] std::span<const std::byte> span() const { return {bytes_.get(), size_}; }
    template <typename T>
    [[nodiscard]] std::span<T> as() {
        return {reinterpret_cast<T*>(bytes_.get()), size_ / sizeof(T)};
    }
    template <typename T>
    [[nodiscard]] std::span<const T> as() const {
        return {reinterpret_cast<const T*>(bytes_.get()), size_ / sizeof(T)};
    }

  private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t size_ = 0;
};

/// One import under way: what was asked, and where its words go.
struct Context {
    std::filesystem::path path;
    const ImportOptions& options;
    Task& task;
    ImportReport& report;
    std::uint64_t budget = 0; ///< bytes

    /// Throws Error(badInput) about this file.
    [[noreturn]] void refuse(const std::string& why, const std::string& remedy = "") const;
    void warn(const std::string& message) const;
};

/// What a reader of a format hands over: numbers as stored, native byte order, x fastest, and where they lie (LPS, mm).
struct StoredVolume {
    ScalarType type = ScalarType::uint8;
    glm::ivec3 dims{1};
    ByteBuffer values;
    glm::dmat3 axesMm{1};                 ///< columns: step for one voxel along i, j, k; may be sheared or left-handed
    glm::dvec3 originMm{0};               ///< centre of voxel (0, 0, 0)
    std::vector<glm::dvec3> sliceOrigins; ///< DICOM: centre of voxel (0, 0, k) for each k; empty: originMm + k * step
    double slope = 1;                     ///< value = slope * stored + intercept
    double intercept = 0;
    Modality modality = Modality::unknown;
    bool modalityKnown = false; ///< the file says it (or says that it is something else)
    std::size_t nonFinite = 0;  ///< counted by finish()
};

/// Hash, non-finite voxels, straight grid, storage type: everything after the numbers are in memory.
ImportedVolume finish(StoredVolume stored, Context& context);

/// How new voxels come about where a volume must be resampled.
struct Resampling {
    double fill = 0;      ///< stored number outside the scanned slices
    bool rounded = false; ///< whole numbers stay whole
    bool nearest = false; ///< labels: no mixing
};

/// Puts a sheared or unevenly spaced volume on a straight grid, with a warning; leaves a straight one alone.
/// Its values must be finite.
void straighten(StoredVolume& stored, const Resampling& resampling, Context& context);

/// The grid of a volume that `straighten` has been over.
Grid gridOf(const StoredVolume& stored);

// ---- Checks of header words

inline constexpr std::int64_t kLargestAxis = 65536;

/// Number of voxels of a grid whose axes a header gives; refuses axes outside [1, 65536] and volumes over the budget.
std::uint64_t checkedVoxels(const Context& context, std::span<const std::int64_t> dims, ScalarType type);
glm::ivec3 checkedDims(const Context& context, std::span<const std::int64_t> dims, ScalarType type);

/// Refuses axes that are not finite, not positive in length, or that lie in one plane, and origins that are not finite.
void checkGeometry(const Context& context, const StoredVolume& stored);

/// Refuses a spacing that is zero, negative, not finite or beyond any scanner.
void checkSpacing(const Context& context, double spacingMm);

/// Whether components are to be dropped (firstComponent); refuses where that was not asked for.
void expectComponents(const Context& context, std::uint64_t components, const std::string& what);

/// Keeps the first of `components` interleaved numbers of each voxel.
void keepFirstComponent(StoredVolume& stored, std::uint64_t components);

// ---- Text

std::string_view trimmed(std::string_view text);
std::string lowered(std::string_view text);
std::vector<std::string_view> words(std::string_view text, std::string_view separators = " \t\r\n");
std::optional<double> parseNumber(std::string_view text); ///< also "nan", "inf"
std::optional<std::int64_t> parseInteger(std::string_view text);
std::vector<double> parseNumbers(std::string_view text, std::string_view separators = " \t\r\n,()");

// ---- Readers. Each assumes that its format has been recognised.

StoredVolume readNifti(Context& context);
StoredVolume readNrrd(Context& context);
StoredVolume readMetaImage(Context& context);
StoredVolume readLegacyVtk(Context& context);
StoredVolume readVti(Context& context);
StoredVolume readPictures(Context& context);
StoredVolume readInvesalius(Context& context);
StoredVolume readRaw(Context& context);
StoredVolume readDicom(Context& context);
StoredVolume readBuiltin(Context& context);

// ---- What headers hold beside the numbers

/// Whether the first bytes of a file are a NIfTI header's, or Analyze's.
bool startsAsNifti(const std::string& head);

/// Contents of a NIfTI header's extensions without the zeros at their ends; at most 16 MiB together.
std::vector<std::string> niftiExtensions(const Context& context);

/// The `key:=value` lines of a NRRD header.
std::map<std::string, std::string> nrrdKeys(const Context& context);

/// Whether the path names a volume that is computed ("builtin:head") instead of a file.
bool isBuiltin(const std::filesystem::path& path);

/// Whether a folder holds at least one picture that can be part of a stack.
bool isPictureFolder(const std::filesystem::path& folder);

} // namespace limner::importing
