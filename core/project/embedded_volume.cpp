#include "core/project/embedded_volume.h"

#include "core/base/error.h"
#include "core/project/sha256.h"

#include <zlib.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <locale>
#include <sstream>

namespace limner {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
    throw Error(ErrorKind::noResources, {"cannot embed the scan", path.string(), std::strerror(errno),
                                         "free some space, or save the project without embedding"});
}

/// The type of number that holds the volume's values exactly, or float.
const char* nrrdType(const Volume& volume) {
    const Volume::Contents& contents = volume.contents();
    const bool whole = contents.slope == 1 && contents.intercept == std::floor(contents.intercept);
    const ValueRange range = volume.range();
    const auto fits = [&](double low, double high) { return whole && range.low >= low && range.high <= high; };
    if (contents.type == VoxelType::float32) {
        return "float";
    }
    return fits(0, 255) && contents.type == VoxelType::uint8 ? "uint8"
           : fits(-32768, 32767)                             ? "int16"
           : fits(0, 65535)                                  ? "uint16"
                                                             : "float";
}

std::string header(const Volume& volume, const char* type) {
    const Grid& grid = volume.grid();
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(17); // every double comes back as it was
    const auto vector = [&](const glm::dvec3& v) { text << "(" << v.x << "," << v.y << "," << v.z << ")"; };
    const glm::dmat3 steps = grid.voxelToMmMatrix();
    text << "NRRD0005\ntype: " << type << "\ndimension: 3\nspace: left-posterior-superior\nsizes: " << grid.dims.x
         << " " << grid.dims.y << " " << grid.dims.z << "\nspace directions: ";
    for (int axis = 0; axis < 3; ++axis) {
        vector(steps[axis]);
        text << (axis < 2 ? " " : "\n");
    }
    text << "kinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: ";
    vector(grid.originMm);
    text << "\n";
    if (volume.contents().modality == Modality::ct || volume.contents().modality == Modality::mr) {
        text << "modality:=" << (volume.contents().modality == Modality::ct ? "CT" : "MR") << "\n";
    }
    text << "\n";
    return text.str();
}

double storedNumber(const std::byte* row, VoxelType type, int x) {
    if (type == VoxelType::uint8) {
        return static_cast<double>(row[x]);
    }
    if (type == VoxelType::int16) {
        std::int16_t number = 0;
        std::memcpy(&number, row + std::ptrdiff_t{x} * 2, 2);
        return number;
    }
    float number = 0;
    std::memcpy(&number, row + std::ptrdiff_t{x} * 4, 4);
    return static_cast<double>(number);
}

void append(std::string& bytes, double value, const std::string& type) {
    const auto put = [&](auto number) { bytes.append(reinterpret_cast<const char*>(&number), sizeof number); };
    if (type == "uint8") {
        put(static_cast<std::uint8_t>(std::lround(value)));
    } else if (type == "int16") {
        put(static_cast<std::int16_t>(std::lround(value)));
    } else if (type == "uint16") {
        put(static_cast<std::uint16_t>(std::lround(value)));
    } else {
        put(static_cast<float>(value));
    }
}

} // namespace

std::string writeNrrd(const Volume& volume, const std::filesystem::path& path, Task& task) {
    const std::string type = nrrdType(volume);
    std::ofstream start(path, std::ios::binary);
    start << header(volume, type.c_str());
    start.close();
    if (!start) {
        fail(path);
    }
    // Level 1: scans gain little from more, and saving must not keep anybody waiting.
    gzFile file = gzopen(path.c_str(), "ab1");
    if (file == nullptr) {
        fail(path);
    }
    const glm::ivec3 dims = volume.grid().dims;
    std::vector<std::byte> row(static_cast<std::size_t>(dims.x) * bytesPerVoxel(volume.type()));
    std::string bytes;
    Sha256 sum;
    task.beginPhase("Embedding the scan");
    for (int z = 0; z < dims.z; ++z) {
        task.progress(static_cast<double>(z) / dims.z);
        bytes.clear();
        for (int y = 0; y < dims.y; ++y) {
            volume.copyRow(y, z, row.data());
            for (int x = 0; x < dims.x; ++x) {
                append(bytes, volume.valueFromStored(storedNumber(row.data(), volume.type(), x)), type);
            }
        }
        sum.add(bytes);
        const bool stopped = task.cancelled();
        if (stopped || gzfwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) {
            gzclose(file);
            task.throwIfCancelled();
            fail(path);
        }
    }
    if (gzclose(file) != Z_OK) {
        fail(path);
    }
    return sum.hex();
}

} // namespace limner
