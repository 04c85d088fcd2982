#pragma once

#include "core/style/png_writing.h"
#include "core/style/style_library.h"
#include "program_run.h"

#include <cmath>
#include <cstdlib>

namespace limner::testing {

/// A folder of its own for the user's styles and for pictures.
class WithStyles : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            std::filesystem::temp_directory_path() / ("limner-styles-" + std::to_string(::getpid()) + "-" +
                                                      ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        const char* old = std::getenv("LIMNER_STYLES");
        old_ = old == nullptr ? "" : old;
        ::setenv("LIMNER_STYLES", path("mine").c_str(), 1);
    }
    void TearDown() override {
        old_.empty() ? ::unsetenv("LIMNER_STYLES") : ::setenv("LIMNER_STYLES", old_.c_str(), 1);
        std::filesystem::remove_all(folder_);
    }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    [[nodiscard]] StyleLibrary mine() const { return StyleLibrary(path("mine")); }
    /// Names in the folder, those of the user's styles left out.
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
            if (entry.path().filename() != "mine") {
                names.push_back(entry.path().filename().string());
            }
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    /// Paper with a painted ball on it: centre (90, 80), radius 50, lit from the upper left.
    void paintBall(const std::string& name, float alphaOutside = 1) const {
        constexpr int kWidth = 200;
        constexpr int kHeight = 160;
        std::vector<Rgba> pixels;
        for (int row = 0; row < kHeight; ++row) {
            for (int column = 0; column < kWidth; ++column) {
                const double x = (column + 0.5 - 90) / 50;
                const double y = (80 - row - 0.5) / 50;
                const double z2 = 1 - x * x - y * y;
                if (z2 <= 0) {
                    pixels.push_back({0.95F, 0.92F, 0.85F, alphaOutside});
                    continue;
                }
                const double light = std::max(0.0, 0.5 * (y - x) / std::sqrt(2.0) + 0.8 * std::sqrt(z2));
                const auto tone = static_cast<float>(0.15 + 0.7 * light);
                pixels.push_back({tone, 0.8F * tone, 0.6F * tone, 1});
            }
        }
        writeWholeFile(folder_ / name, pngBytes({kWidth, kHeight}, pixels));
    }
    /// A picture of one colour.
    void paintPlain(const std::string& name, glm::ivec2 size, const Rgba& colour) const {
        const std::vector<Rgba> pixels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), colour);
        writeWholeFile(folder_ / name, pngBytes(size, pixels));
    }
    /// A grey mask with a white rectangle.
    void paintMask(const std::string& name, glm::ivec2 from, glm::ivec2 to) const {
        std::vector<std::uint8_t> values(200 * 160);
        for (int y = from.y; y < to.y; ++y) {
            std::fill(values.begin() + y * 200 + from.x, values.begin() + y * 200 + to.x, 255);
        }
        writeWholeFile(folder_ / name, pngBytes({200, 160}, values));
    }

    std::filesystem::path folder_;
    std::string old_;
};

/// The run fails with that code and one line that has the hint in it; nothing on standard output.
inline void expectRefused(const std::vector<std::string>& arguments, int code, const std::string& hint) {
    const ProgramRun refused = run(arguments);
    std::string command;
    for (const std::string& argument : arguments) {
        command += argument + " ";
    }
    SCOPED_TRACE(command);
    EXPECT_EQ(refused.code, code) << refused.err;
    EXPECT_EQ(refused.out, "");
    const std::size_t start = refused.err.find("limner: ");
    ASSERT_NE(start, std::string::npos) << refused.err;
    EXPECT_EQ(refused.err.find('\n', start), refused.err.size() - 1) << refused.err;
    EXPECT_NE(refused.err.find(hint, start), std::string::npos) << refused.err;
}

} // namespace limner::testing
