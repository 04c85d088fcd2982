#include "core/base/pending_file.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include <unistd.h>

namespace limner {
namespace {

class PendingFileTest : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / ("limner-pending-" + std::to_string(::getpid()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    [[nodiscard]] std::size_t filesLeft() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
    }
    std::filesystem::path folder_;
};

TEST_F(PendingFileTest, AppearsOnlyWhenItIsCommitted) {
    const auto path = folder_ / "a.txt";
    {
        PendingFile file(path);
        std::fputs("hello", file.stream());
        EXPECT_FALSE(std::filesystem::exists(path));
        file.commit();
    }
    std::string text;
    std::ifstream(path) >> text;
    EXPECT_EQ(text, "hello");
    EXPECT_EQ(filesLeft(), 1U);
}

TEST_F(PendingFileTest, LeavesNothingWhenItIsGivenUp) {
    { PendingFile file(folder_ / "a.txt"); }
    EXPECT_EQ(filesLeft(), 0U);
}

TEST_F(PendingFileTest, ASignalsHandlerCanRemoveAllOfThem) {
    PendingFile a(folder_ / "a.txt");
    PendingFile b(folder_ / "b.txt");
    EXPECT_EQ(filesLeft(), 2U);
    removePendingFiles();
    EXPECT_EQ(filesLeft(), 0U);
    EXPECT_THROW(a.commit(), Error);
}

TEST_F(PendingFileTest, TakesTheLongestLegalName) {
    const auto path = folder_ / std::string(255, 'n');
    PendingFile file(path);
    file.commit();
    EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_F(PendingFileTest, SaysWhereAFolderIsMissing) {
    try {
        const PendingFile file(folder_ / "none" / "a.txt");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::noResources);
        EXPECT_NE(std::string(error.what()).find("a.txt"), std::string::npos);
    }
}

} // namespace
} // namespace limner
