#include "gradient_backend.h"
#include "renderer/export/picture_file.h"

#include <gtest/gtest.h>

#include <OpenImageIO/imageio.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ; // NOLINT: POSIX

namespace limner {
namespace {

using testing::GradientBackend;

constexpr int kEdge = 16384;
constexpr std::size_t kBudget = std::size_t{1} << 30;
constexpr const char* kPosterVariable = "LIMNER_TEST_POSTER";

/// Bytes of resident memory that another run of the running test has at most; that run finds the variable set.
std::size_t peakOfChild(const std::filesystem::path& poster) {
    ::setenv(kPosterVariable, poster.c_str(), 1);
    std::string program = std::filesystem::read_symlink("/proc/self/exe");
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string filter = std::string("--gtest_filter=") + test->test_suite_name() + "." + test->name();
    char* arguments[] = {program.data(), filter.data(), nullptr};
    pid_t child = 0;
    const int failed = ::posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ);
    ::unsetenv(kPosterVariable);
    EXPECT_EQ(failed, 0);
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

void makePoster(const std::filesystem::path& path) {
    RenderPlan plan;
    plan.size = {kEdge, kEdge};
    PictureOptions options;
    options.memoryBudget = kBudget;
    Task task;
    exportPicture(plan, GradientBackend(), path, options, task);
}

TEST(Poster, OfAQuarterOfABillionPixelsStaysWithinItsBudgetAndReadsBack) {
    if (const char* poster = std::getenv(kPosterVariable); poster != nullptr) {
        makePoster(poster);
        return;
    }
    const auto path = std::filesystem::temp_directory_path() / ("limner-poster-" + std::to_string(::getpid()) + ".tif");
    const std::size_t peak = peakOfChild(path);
    std::cout << "peak memory " << (peak >> 20) << " MiB\n";
    EXPECT_LT(peak, kBudget);

    auto in = OIIO::ImageInput::open(path.string());
    ASSERT_NE(in, nullptr) << OIIO::geterror();
    EXPECT_EQ(in->spec().width, kEdge);
    EXPECT_EQ(in->spec().height, kEdge);
    ASSERT_EQ(in->spec().nchannels, 3);
    std::vector<std::uint8_t> row(static_cast<std::size_t>(kEdge) * 3);
    for (const int y : {0, 1, 63, 64, 8191, 12345, kEdge - 1}) { // across bands and strips
        ASSERT_TRUE(in->read_scanline(y, 0, OIIO::TypeDesc::UINT8, row.data())) << in->geterror();
        for (int x = 0; x < kEdge; ++x) {
            const glm::vec4 c = GradientBackend::colourAt(x, y);
            for (int i = 0; i < 3; ++i) {
                const float expected = (c[i] + 1 - c.a) * 255;
                ASSERT_NEAR(row[static_cast<std::size_t>(x) * 3 + static_cast<std::size_t>(i)], expected, 0.501F)
                    << x << ' ' << y;
            }
        }
    }
    in->close();
    std::filesystem::remove(path);
}

} // namespace
} // namespace limner
