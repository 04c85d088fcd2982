#include "core/base/error.h"
#include "core/figure/figure_json.h"
#include "core/project/archive.h"
#include "core/project/embedded_volume.h"
#include "core/project/recovery.h"
#include "support/make_volume.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <set>

#include <sys/wait.h>
#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Volume> ramp() {
    return testing::makeVolume<std::int16_t>(testing::gridOf({4, 3, 2}), VoxelType::int16,
                                             [](glm::ivec3 v) { return v.x + 10 * v.y + 100 * v.z; });
}

std::shared_ptr<const LitSphere> ball(float red) {
    return std::make_shared<const LitSphere>(8, std::vector<Rgba>(64, Rgba{red, 1, 0, 1}));
}

UnsavedDocument unsaved(const std::string& title) {
    UnsavedDocument result;
    result.name = "Untitled";
    Figure& figure = result.document.figure;
    figure.title = title;
    figure.volume.emplace().data = ramp();
    figure.styles.push_back({"ochre", "styles/ochre.png", "Ochre", "", "", ball(1)});
    figure.layers.emplace_back().transfer.nodes.emplace_back().rgb = glm::dvec3(1, 0.5, 0);
    figure.layers.back().transfer.opacity = {{0, 0}, {1, 1}};
    result.thumbnailPng = std::vector<std::byte>(5, std::byte{7});
    return result;
}

/// Opens the work and makes it the session's.
Document restored(RecoverySession& session, const RecoveryEntry& entry) {
    Task task;
    RestoredWork work = openWork(entry, task);
    Document document = work.document;
    session.adopt(std::move(work));
    return document;
}

bool sameValues(const Volume& a, const Volume& b) {
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 4; ++x)
                if (a.valueAt({x, y, z}) != b.valueAt({x, y, z}))
                    return false;
    return a.grid() == b.grid();
}

TEST(Recovery, ASessionThatEndedIsOfferedAndComesBackWhole) {
    const TemporaryFolder folder;
    Task task;
    const UnsavedDocument kept = unsaved("first");
    {
        RecoverySession session(folder.path());
        EXPECT_TRUE(session.folder().empty());
        session.write(kept, task);
        EXPECT_TRUE(unsavedWork(folder.path()).empty()) << "the session still runs";
    }
    const std::vector<RecoveryEntry> work = unsavedWork(folder.path());
    ASSERT_EQ(work.size(), 1U);
    EXPECT_EQ(work[0].name, "Untitled");
    EXPECT_TRUE(work[0].project.empty());
    EXPECT_EQ(work[0].process, ::getpid());
    EXPECT_EQ(fs::file_size(work[0].thumbnail), 5U);
    RecoverySession session(folder.path());
    const Document back = restored(session, work[0]);
    EXPECT_TRUE(back.path.empty());
    EXPECT_EQ(back.figure.title, "first");
    ASSERT_TRUE(back.figure.volume && back.figure.volume->data);
    EXPECT_TRUE(sameValues(*back.figure.volume->data, *kept.document.figure.volume->data));
    EXPECT_EQ(back.figure.volume->path, "") << "it came from no file, and must be embedded when it is saved";
    ASSERT_TRUE(back.figure.styles.at(0).sphere);
    EXPECT_EQ(back.figure.styles[0].sphere->at(0, 0), kept.document.figure.styles[0].sphere->at(0, 0));
    EXPECT_TRUE(back.notes.empty()) << back.notes.front();
}

TEST(Recovery, ARestoredSessionThatEndsAgainLosesNothing) {
    const TemporaryFolder folder;
    Task task;
    { RecoverySession(folder.path()).write(unsaved("first"), task); }
    { // restored, and gone before it could write anything
        RecoverySession session(folder.path());
        EXPECT_EQ(restored(session, unsavedWork(folder.path()).at(0)).figure.title, "first");
        EXPECT_TRUE(unsavedWork(folder.path()).empty());
    }
    { // restored again, changed, gone again
        RecoverySession session(folder.path());
        UnsavedDocument changed = unsaved("");
        changed.document = restored(session, unsavedWork(folder.path()).at(0));
        EXPECT_EQ(changed.document.figure.title, "first");
        changed.document.figure.title = "second";
        session.write(changed, task);
    }
    ASSERT_EQ(unsavedWork(folder.path()).size(), 1U);
    RecoverySession session(folder.path());
    const Document back = restored(session, unsavedWork(folder.path())[0]);
    EXPECT_EQ(back.figure.title, "second");
    EXPECT_TRUE(sameValues(*back.figure.volume->data, *ramp()));
    ASSERT_TRUE(back.figure.styles.at(0).sphere);
    session.clear();
    EXPECT_TRUE(fs::is_empty(folder.path())) << "a saved document leaves nothing";
}

TEST(Recovery, WorkThatIsOpenedAndLetGoStaysWhereItIs) {
    const TemporaryFolder folder;
    Task task;
    { RecoverySession(folder.path()).write(unsaved("first"), task); }
    {
        const RestoredWork work = openWork(unsavedWork(folder.path()).at(0), task);
        EXPECT_TRUE(unsavedWork(folder.path()).empty()) << "held";
    }
    EXPECT_EQ(unsavedWork(folder.path()).size(), 1U);
}

TEST(Recovery, TwoCannotRestoreTheSameWork) {
    const TemporaryFolder folder;
    Task task;
    { RecoverySession(folder.path()).write(unsaved("first"), task); }
    const RecoveryEntry entry = unsavedWork(folder.path()).at(0);
    RecoverySession first(folder.path());
    static_cast<void>(restored(first, entry));
    RecoverySession second(folder.path());
    second.write(unsaved("other"), task);
    EXPECT_THROW(static_cast<void>(restored(second, entry)), Error);
    discardWork(entry);
    EXPECT_TRUE(fs::exists(entry.folder)) << "nobody discards what another one works on";
    EXPECT_TRUE(fs::exists(second.folder() / "figure.json")) << "its own work is untouched";
    first.clear();
    EXPECT_THROW(static_cast<void>(restored(second, entry)), Error);
}

TEST(Recovery, ADamagedNewestGenerationGivesWayToTheOneBefore) {
    const TemporaryFolder folder;
    Task task;
    fs::path own;
    {
        RecoverySession session(folder.path());
        session.write(unsaved("first"), task);
        session.write(unsaved("second"), task);
        own = session.folder();
    }
    fs::resize_file(own / "figure.json", 40);
    RecoverySession session(folder.path());
    const Document back = restored(session, unsavedWork(folder.path()).at(0));
    EXPECT_EQ(back.figure.title, "first");
    ASSERT_FALSE(back.notes.empty());
    EXPECT_NE(back.notes.front().find("damaged"), std::string::npos);
}

TEST(Recovery, TheScanIsWrittenOnlyWhereNoFileHasItAndOnlyOnce) {
    const TemporaryFolder folder;
    Task task;
    writeNrrd(*ramp(), folder.path() / "scan.nrrd", task);
    RecoverySession session(folder.path() / "recovery");
    UnsavedDocument work;
    work.name = "scan.nrrd";
    work.document = openDocument(folder.path() / "scan.nrrd", "auto", {}, task);
    session.write(work, task);
    EXPECT_FALSE(fs::exists(session.folder() / "volume.nrrd"));
    session.clear();
    work = unsaved("made");
    session.write(work, task);
    const fs::path volume = session.folder() / "volume.nrrd";
    const auto written = fs::last_write_time(volume) - std::chrono::hours(1);
    fs::last_write_time(volume, written);
    work.document.figure.title = "changed";
    session.write(work, task);
    EXPECT_EQ(fs::last_write_time(volume), written) << "not at every autosave";
    work.document.figure.volume->data = ramp(); // another scan
    session.write(work, task);
    EXPECT_NE(fs::last_write_time(volume), written);
}

TEST(Recovery, RestoredWorkOfAProjectIsSavedIntoItWithItsScanAndTheNewPicture) {
    const TemporaryFolder folder;
    Task task;
    const fs::path project = folder.path() / "head.limner";
    SaveOptions embed;
    embed.embedVolume = true;
    saveDocument(unsaved("saved").document, project, embed, task);
    {
        UnsavedDocument work;
        work.name = "head.limner";
        work.document = openDocument(project, OpenOptions{}, task);
        work.document.figure.styles.at(0).file.clear(); // another picture under the same id
        work.document.figure.styles.at(0).sphere = ball(0);
        RecoverySession(folder.path() / "recovery").write(work, task);
    }
    RecoverySession session(folder.path() / "recovery");
    const Document back = restored(session, unsavedWork(folder.path() / "recovery").at(0));
    EXPECT_EQ(back.path, project);
    EXPECT_TRUE(back.figure.volume->embedded);
    embed.embedVolume = back.figure.volume->embedded;
    saveDocument(back, project, embed, task);
    session.clear();
    const Document again = openDocument(project, OpenOptions{}, task);
    ASSERT_TRUE(again.figure.volume->data);
    EXPECT_TRUE(sameValues(*again.figure.volume->data, *ramp()));
    ASSERT_TRUE(again.figure.styles.at(0).sphere);
    EXPECT_EQ(again.figure.styles[0].sphere->at(0, 0).r, 0) << "the project's old picture has the same name";
    EXPECT_TRUE(again.notes.empty()) << again.notes.front();
}

TEST(Recovery, RubbishInTheFolderIsNeitherOfferedNorHarmful) {
    const TemporaryFolder folder;
    EXPECT_TRUE(unsavedWork(folder.path() / "none").empty());
    std::ofstream(folder.path() / "file") << "x";
    fs::create_directory(folder.path() / "empty");
    fs::create_directory(folder.path() / "broken");
    std::ofstream(folder.path() / "broken" / "session.json") << "{\"name\": 3}";
    EXPECT_TRUE(unsavedWork(folder.path()).empty());
    EXPECT_TRUE(fs::exists(folder.path() / "broken")) << "left for whoever can read it";
}

/// A writer that is killed at any moment leaves the last whole state or the one before; six seeded moments.
TEST(Recovery, AWriterThatIsKilledLeavesAWholeState) {
    Task task;
    for (const int afterMicroseconds : {500, 3000, 9000, 21000, 47000, 90000}) {
        const TemporaryFolder folder;
        int told[2];
        ASSERT_EQ(::pipe(told), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            RecoverySession session(folder.path());
            for (int i = 0; i < 10'000; ++i) {
                session.write(unsaved(std::to_string(i)), task);
                static_cast<void>(!::write(told[1], &i, sizeof i)); // this one is safe
            }
            ::_exit(0);
        }
        int last = -1;
        ASSERT_EQ(::read(told[0], &last, sizeof last), static_cast<ssize_t>(sizeof last));
        ::usleep(static_cast<useconds_t>(afterMicroseconds));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        ::close(told[1]);
        for (int at = 0; ::read(told[0], &at, sizeof at) == static_cast<ssize_t>(sizeof at);)
            last = at;
        ::close(told[0]);
        const std::vector<RecoveryEntry> work = unsavedWork(folder.path());
        ASSERT_EQ(work.size(), 1U);
        RecoverySession session(folder.path());
        const int found = std::stoi(restored(session, work[0]).figure.title);
        EXPECT_GE(found, last);
        EXPECT_LE(found, last + 1);
    }
}

} // namespace
} // namespace limner
