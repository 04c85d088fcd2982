#include "core/base/error.h"
#include "core/base/file_lock.h"
#include "core/project/archive.h"
#include "core/project/project_lock.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

TEST(FileLock, IsHeldByOneAndSaysByWhom) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "lock";
    EXPECT_FALSE(FileLock::holderOf(file));
    auto first = FileLock::take(file, "first");
    ASSERT_TRUE(first);
    EXPECT_FALSE(FileLock::take(file, "second"));
    EXPECT_EQ(FileLock::holderOf(file), "first");
    FileLock moved = std::move(*first);
    first.reset();
    EXPECT_FALSE(FileLock::take(file, "second")) << "moving does not let go";
    moved = std::move(*FileLock::take(folder.path() / "other", ""));
    EXPECT_FALSE(fs::exists(file)) << "who lets go leaves nothing";
    EXPECT_TRUE(FileLock::take(file, "second"));
}

TEST(FileLock, AFileThatNobodyHoldsBlocksNobody) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "lock";
    std::ofstream(file) << "process 1 on this machine"; // as a machine that lost its power leaves it
    EXPECT_FALSE(FileLock::holderOf(file));
    EXPECT_TRUE(FileLock::take(file, "me"));
    EXPECT_THROW(FileLock::take(folder.path() / "none" / "lock", "me"), Error);
}

TEST(FileLock, AKilledProgramLetsGo) {
    const TemporaryFolder folder;
    const fs::path project = folder.path() / "head.limner";
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto lock = lockProject(project);
        const char told = lock ? 'y' : 'n';
        static_cast<void>(!::write(ready[1], &told, 1));
        ::pause();
        ::_exit(0);
    }
    char told = 0;
    ASSERT_EQ(::read(ready[0], &told, 1), 1);
    EXPECT_EQ(told, 'y');
    const auto holder = projectHolder(project);
    ASSERT_TRUE(holder);
    EXPECT_TRUE(holder->starts_with("process " + std::to_string(child) + " on ")) << *holder;
    EXPECT_FALSE(lockProject(project));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_FALSE(projectHolder(project));
    EXPECT_TRUE(fs::exists(folder.path() / ".head.limner.lock")) << "the file is left, its hold is not";
    EXPECT_TRUE(lockProject(project));
}

TEST(FileLock, LinksToOneProjectShareItsLock) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "a.limner") << "x";
    fs::create_symlink(folder.path() / "a.limner", folder.path() / "b.limner");
    const auto lock = lockProject(folder.path() / "a.limner");
    ASSERT_TRUE(lock);
    EXPECT_TRUE(projectHolder(folder.path() / "b.limner"));
}

} // namespace
} // namespace limner
