#include "core/base/error.h"
#include "core/project/archive.h"
#include "gradient_backend.h"
#include "renderer/export/finished_bands.h"
#include "renderer/export/picture_file.h"
#include "support/small_disk.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ; // NOLINT: POSIX

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::GradientBackend;

constexpr int kBands = 10;
constexpr int kRows = 64;
constexpr const char* kKilled = "LIMNER_TEST_KILLED_EXPORT";

std::string bytesOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    // TIFF says when it was written, to the second.
    static const std::regex kTime("[0-9]{4}:[0-9]{2}:[0-9]{2} [0-9]{2}:[0-9]{2}:[0-9]{2}");
    return std::regex_replace(bytes.str(), kTime, "time");
}

class Resume : public ::testing::TestWithParam<const char*> {
  protected:
    Resume() {
        plan_.size = {500, kBands * kRows - 7}; // the last band is not full
        options_.tile = kRows;
        options_.resumable = true;
    }
    [[nodiscard]] fs::path file(const char* stem) const {
        return folder_.path() / (std::string(stem) + "." + GetParam());
    }
    [[nodiscard]] int tilesPerBand() const { return (plan_.size.x + kRows - 1) / kRows; }
    ExportFacts write(const fs::path& path, GradientBackend& backend) {
        Task task;
        return exportPicture(plan_, backend, path, options_, task);
    }
    /// Stops in the middle of band `band`, as a failure of the renderer would.
    void failIn(int band, const fs::path& path) {
        GradientBackend backend;
        backend.afterTile = [&](Picture&) {
            if (backend.calls == band * tilesPerBand() + 2)
                throw Error(ErrorKind::noResources, {"no more memory", "", "", ""});
        };
        EXPECT_THROW(write(path, backend), Error);
    }

    TemporaryFolder folder_;
    RenderPlan plan_;
    PictureOptions options_;
};

TEST_P(Resume, AnInterruptedPictureGoesOnWhereItWasAndIsTheSameBitForBit) {
    GradientBackend whole;
    const ExportFacts all = write(file("whole"), whole);
    EXPECT_FALSE(fs::exists(FinishedBands::fileFor(file("whole")))) << "nothing is left of a finished one";
    failIn(6, file("parts"));
    EXPECT_FALSE(fs::exists(file("parts"))) << "no half picture";
    failIn(2, file("parts")); // the second try fails later: its bands 6, 7 are drawn, band 8 is not
    GradientBackend rest;
    const ExportFacts facts = write(file("parts"), rest);
    EXPECT_TRUE(bytesOf(file("parts")) == bytesOf(file("whole")));
    EXPECT_EQ(rest.calls, (kBands - 6 - 2) * tilesPerBand()) << "only what was missing is drawn";
    EXPECT_EQ(facts.samples, all.samples);
    EXPECT_FALSE(fs::exists(FinishedBands::fileFor(file("parts"))));
}

TEST_P(Resume, AnotherFigureOrSettingStartsAnew) {
    const fs::path path = file("picture");
    failIn(5, path);
    options_.background = {0, 0, 0, 1};
    GradientBackend backend;
    write(path, backend);
    EXPECT_EQ(backend.calls, kBands * tilesPerBand());
    options_.resumable = false;
    GradientBackend fresh;
    write(file("fresh"), fresh);
    EXPECT_TRUE(bytesOf(path) == bytesOf(file("fresh")));
}

TEST_P(Resume, DamageInTheFinishedBandsIsDrawnAgain) {
    const fs::path path = file("picture");
    failIn(6, path);
    const fs::path bands = FinishedBands::fileFor(path);
    {
        std::fstream stream(bands, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekp(static_cast<std::streamoff>(fs::file_size(bands) / 2));
        stream.write("damage", 6);
    }
    GradientBackend backend;
    write(path, backend);
    EXPECT_GT(backend.calls, (kBands - 6) * tilesPerBand());
    GradientBackend whole;
    write(file("whole"), whole);
    EXPECT_TRUE(bytesOf(path) == bytesOf(file("whole")));
}

TEST_P(Resume, AFileThatWasCutOffGivesItsWholeBands) {
    const fs::path path = file("picture");
    failIn(6, path);
    const fs::path bands = FinishedBands::fileFor(path);
    fs::resize_file(bands, fs::file_size(bands) - 3);
    GradientBackend backend;
    write(path, backend);
    EXPECT_EQ(backend.calls, (kBands - 5) * tilesPerBand());
}

TEST_P(Resume, AFullDiskKeepsNothingMoreAndDisturbsNothing) {
    const fs::path path = file("picture");
    GradientBackend backend;
    {
        const testing::SmallDisk disk(3'000); // no format gets the picture into it
        EXPECT_THROW(write(path, backend), Error);
    }
    EXPECT_FALSE(fs::exists(path));
    GradientBackend again;
    write(path, again);
    GradientBackend whole;
    write(file("whole"), whole);
    EXPECT_TRUE(bytesOf(path) == bytesOf(file("whole")));
}

TEST_P(Resume, AKilledExportGoesOn) {
    if (const char* killed = std::getenv(kKilled); killed != nullptr) { // this run is the one that is killed
        GradientBackend backend;
        backend.afterTile = [&](Picture&) {
            if (backend.calls == 7 * tilesPerBand() + 1)
                ::raise(SIGKILL);
        };
        write(killed, backend);
        return;
    }
    const fs::path path = file("picture");
    ::setenv(kKilled, path.c_str(), 1);
    std::string program = fs::read_symlink("/proc/self/exe");
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string filter = std::string("--gtest_filter=") + test->test_suite_name() + "." + test->name();
    char* arguments[] = {program.data(), filter.data(), nullptr};
    pid_t child = 0;
    const int failed = ::posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ);
    ::unsetenv(kKilled);
    ASSERT_EQ(failed, 0);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    for (const auto& entry : fs::directory_iterator(folder_.path())) // as if it had been yesterday
        fs::last_write_time(entry, fs::file_time_type::clock::now() - std::chrono::hours(24));
    GradientBackend backend;
    write(path, backend);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1) << "the killed one's file is gone as well";
    EXPECT_LE(backend.calls, (kBands - 5) * tilesPerBand()) << "the band before may not have been written yet";
    GradientBackend whole;
    write(file("whole"), whole);
    EXPECT_TRUE(bytesOf(path) == bytesOf(file("whole")));
}

TEST_P(Resume, WhatIsNotWantedAnyMoreCanBeForgotten) {
    failIn(5, file("picture"));
    EXPECT_TRUE(fs::exists(FinishedBands::fileFor(file("picture"))));
    forgetUnfinished(file("picture"));
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

INSTANTIATE_TEST_SUITE_P(Formats, Resume, ::testing::Values("png", "tif", "exr", "jpg", "webp"),
                         [](const auto& param) { return std::string(param.param); });

} // namespace
} // namespace limner
