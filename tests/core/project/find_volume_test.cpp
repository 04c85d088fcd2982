#include "core/base/error.h"
#include "core/project/archive.h"
#include "core/project/embedded_volume.h"
#include "core/project/find_volume.h"
#include "core/project/project.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <fstream>

namespace limner {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Volume> ramp(int from) {
    return testing::makeVolume<std::int16_t>(testing::gridOf({6, 5, 4}), VoxelType::int16,
                                             [&](glm::ivec3 v) { return from + v.x + 10 * v.y + 100 * v.z; });
}

class FindVolume : public ::testing::Test {
  protected:
    FindVolume() {
        fs::create_directories(root_ / "work" / "project");
        writeNrrd(*ramp(0), scan_, task_);
        const Document document = openDocument(scan_, "auto", {}, task_);
        reference_ = *document.figure.volume;
        reference_.data = nullptr;
    }
    [[nodiscard]] std::optional<FoundVolume> find() {
        return findVolume(reference_, searchFolders(root_ / "work" / "project" / "head.limner", {}), task_);
    }

    TemporaryFolder temporary_;
    fs::path root_ = fs::weakly_canonical(temporary_.path());
    fs::path scan_ = root_ / "scan.nrrd";
    Task task_;
    VolumeReference reference_;
};

TEST_F(FindVolume, AMovedScanIsFoundByItsNumbers) {
    const fs::path place = root_ / "work" / "scans" / "2024";
    fs::create_directories(place);
    fs::rename(scan_, place / "scan.nrrd");
    const auto found = find();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->path, place / "scan.nrrd");
    EXPECT_EQ(found->imported.volume->valueAt({5, 4, 3}), 345);
}

TEST_F(FindVolume, ARenamedScanIsFoundAndAnotherOneOfItsNameIsNot) {
    fs::rename(scan_, root_ / "work" / "anna.nrrd");
    writeNrrd(*ramp(1), root_ / "work" / "project" / "scan.nrrd", task_); // nearer, of the same name, other numbers
    const auto found = find();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->path, root_ / "work" / "anna.nrrd");
}

TEST_F(FindVolume, AFileOfTheSameSizeThatIsNoScanIsPassedOver) {
    const auto size = fs::file_size(scan_);
    fs::remove(scan_);
    std::ofstream(root_ / "work" / "letter.txt") << std::string(size, 'a');
    EXPECT_FALSE(find());
}

TEST_F(FindVolume, WithoutAChecksumNameAndSizeMustDo) {
    reference_.sha256.clear();
    fs::rename(scan_, root_ / "work" / "other.nrrd");
    EXPECT_FALSE(find()) << "of the same size only";
    fs::rename(root_ / "work" / "other.nrrd", root_ / "work" / "scan.nrrd");
    EXPECT_TRUE(find());
}

TEST_F(FindVolume, IsStoppedAtOnce) {
    fs::rename(scan_, root_ / "work" / "scan.nrrd");
    task_.cancel();
    EXPECT_THROW(static_cast<void>(find()), Error);
}

TEST_F(FindVolume, LooksInTheProjectsFolderItsParentsAndThoseOfRecentFiles) {
    const auto folders = searchFolders(root_ / "work" / "project" / "head.limner",
                                       {root_ / "else" / "a.nrrd", root_ / "work" / "b.limner", "/a.nrrd"});
    EXPECT_EQ(folders, (std::vector<fs::path>{root_ / "work" / "project", root_ / "work", root_, root_ / "else"}));
    EXPECT_EQ(findByName("old/place/scan.nrrd", folders, task_), scan_);
    EXPECT_FALSE(findByName("nothing.nrrd", folders, task_));
}

} // namespace
} // namespace limner
