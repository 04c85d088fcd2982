#pragma once

#include "app/cli/program.h"
#include "core/volume/phantom.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace limner::testing {

struct ProgramRun {
    int code = 0;
    std::string out;
    std::string err;

    [[nodiscard]] nlohmann::json facts() const { return nlohmann::json::parse(out); }
};

inline ProgramRun run(const std::vector<std::string>& arguments) {
    std::ostringstream out;
    std::ostringstream err;
    ProgramRun result;
    result.code = cli::runProgram(arguments, {out, err, -1});
    result.out = out.str();
    result.err = err.str();
    return result;
}

/// A volume as an NRRD file, as it is kept in memory.
inline void writeNrrd(const Volume& volume, const std::filesystem::path& path) {
    const Grid& grid = volume.grid();
    std::ofstream file(path, std::ios::binary);
    file << "NRRD0004\ntype: int16\ndimension: 3\nspace: left-posterior-superior\nsizes: " << grid.dims.x << ' '
         << grid.dims.y << ' ' << grid.dims.z << "\nspace directions: (" << grid.spacingMm.x << ",0,0) (0,"
         << grid.spacingMm.y << ",0) (0,0," << grid.spacingMm.z << ")\nspace origin: (" << grid.originMm.x << ','
         << grid.originMm.y << ',' << grid.originMm.z << ")\nendian: little\nencoding: raw\n\n";
    std::vector<std::byte> row(static_cast<std::size_t>(grid.dims.x) * bytesPerVoxel(volume.type()));
    for (int z = 0; z < grid.dims.z; ++z) {
        for (int y = 0; y < grid.dims.y; ++y) {
            volume.copyRow(y, z, row.data());
            file.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size()));
        }
    }
}

/// A folder of its own with a small head scan in it.
class WithScan : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            std::filesystem::temp_directory_path() / ("limner-cli-" + std::to_string(::getpid()) + "-" +
                                                      ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        const auto head = makeHeadPhantom(48);
        ASSERT_EQ(head->type(), VoxelType::int16);
        writeNrrd(*head, scan());
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string scan() const { return path("head.nrrd"); }
    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    [[nodiscard]] std::size_t filesLeft() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
    }

    std::filesystem::path folder_;
};

} // namespace limner::testing
