// What the window does for documents beside opening and saving them.
#include "gui/studio_window.h"

#include "app/studio/window_documents.h"
#include "app/studio/window_history.h"
#include "app/studio/window_recovery.h"
#include "core/project/embedded_volume.h"
#include "core/project/project_lock.h"
#include "core/volume/phantom.h"
#include "support/test_data.h"
#include "widgets/history_list.h"
#include "widgets/missing_bar.h"
#include "widgets/notice_bar.h"
#include "widgets/recovery_bar.h"

#include <QApplication>
#include <QFileDialog>
#include <QListWidget>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include <fstream>

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::pumpUntil;
using testing::Studio;

/// A window with a small scan from a file, saved as a project.
struct WithProject {
    WithProject() {
        Task task;
        writeNrrd(*makeHeadPhantom(32), scan, task);
        fs::create_directories(project.parent_path());
    }
    /// `path` is there for good.
    void open(Studio& on, const fs::path& path) const {
        const unsigned before = on.window->document().generation();
        on.window->openPath(path);
        ASSERT_TRUE(pumpUntil([&] { return on.window->document().generation() != before; }));
    }
    void save(Studio& on) const {
        on.window->savePath(project);
        ASSERT_TRUE(pumpUntil([&] { return !on.window->busy(); }));
        ASSERT_FALSE(on.window->document().dirty());
    }
    QTemporaryDir folder;
    fs::path scan = folder.filePath("scan.nrrd").toStdString();
    /// Two folders down: what is searched above it is still of this test alone.
    fs::path project = folder.filePath("work/project/head.limner").toStdString();
};

void rename(Studio& studio, const std::string& title) {
    Edit edit{studio.figure(), "Rename to " + title, {}, false};
    edit.figure.title = title;
    studio.window->document().apply(edit);
}

template <class Feature>
Feature& of(Studio& studio) {
    return *studio.window->findChild<Feature*>();
}

TEST(Documents, UnsavedWorkIsKeptOfferedRestoredAndGoneOnceItIsSaved) {
    const WithProject files;
    const QByteArray recovery = files.folder.filePath("recovery").toUtf8();
    qputenv("LIMNER_AUTOSAVE_EDITS", "2");
    {
        Studio studio;
        files.open(studio, files.scan);
        files.save(studio);
    }
    { // a window that is torn down without being closed, as near to a crash as one process gets
        Studio studio;
        qputenv("LIMNER_RECOVERY", recovery);
        studio.window = std::make_unique<MainWindow>(makeEngine());
        files.open(studio, files.project);
        bool kept = false;
        QObject::connect(&of<WindowRecovery>(studio), &WindowRecovery::kept, studio.window.get(), [&] { kept = true; });
        rename(studio, "one");
        EXPECT_FALSE(pumpUntil([&] { return kept; }, 300)) << "one change is not worth the writing yet";
        rename(studio, "two");
        ASSERT_TRUE(pumpUntil([&] { return kept; }));
        EXPECT_TRUE(of<WindowRecovery>(studio).offered().empty());
        EXPECT_TRUE(unsavedWork(recovery.toStdString()).empty()) << "it is not offered while it is worked on";
    }
    Studio studio;
    qputenv("LIMNER_RECOVERY", recovery);
    studio.window = std::make_unique<MainWindow>(makeEngine());
    studio.window->askAboutChanges = [] { return MainWindow::Answer::discard; };
    studio.window->show();
    auto& feature = of<WindowRecovery>(studio);
    ASSERT_EQ(feature.bar().rows(), 1);
    EXPECT_TRUE(feature.bar().isVisible());
    auto* restore = feature.bar().findChild<QPushButton*>();
    ASSERT_NE(restore, nullptr);
    EXPECT_EQ(restore->text(), "Restore");
    restore->click();
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->document().empty(); }));
    EXPECT_EQ(studio.figure().title, "two");
    EXPECT_TRUE(studio.window->document().dirty());
    EXPECT_EQ(studio.window->document().projectPath(), files.project);
    ASSERT_TRUE(pumpUntil([&] { return feature.bar().rows() == 0; }));
    files.save(studio);
    EXPECT_TRUE(fs::is_empty(recovery.toStdString())) << "nothing is unsaved";
    qunsetenv("LIMNER_AUTOSAVE_EDITS");
}

TEST(Documents, DiscardedChangesAreNotOfferedAgain) {
    const WithProject files;
    qputenv("LIMNER_AUTOSAVE_EDITS", "1");
    Studio studio;
    files.open(studio, files.scan);
    bool kept = false;
    QObject::connect(&of<WindowRecovery>(studio), &WindowRecovery::kept, studio.window.get(), [&] { kept = true; });
    rename(studio, "one");
    ASSERT_TRUE(pumpUntil([&] { return kept; }));
    const fs::path recovery = studio.styles.filePath("recovery").toStdString();
    EXPECT_FALSE(fs::is_empty(recovery));
    studio.trigger("file.close"); // and the answer is: discard
    EXPECT_TRUE(pumpUntil([&] { return fs::is_empty(recovery); }));
    qunsetenv("LIMNER_AUTOSAVE_EDITS");
}

TEST(Documents, AProjectThatAnotherOneHasOpenIsSavedUnderAnotherName) {
    const WithProject files;
    Studio studio;
    files.open(studio, files.scan);
    files.save(studio);
    EXPECT_TRUE(projectHolder(files.project)) << "it is held while it is open";
    studio.trigger("file.close");
    EXPECT_FALSE(projectHolder(files.project));
    EXPECT_FALSE(fs::exists(files.project.parent_path() / ".head.limner.lock"));
    auto other = lockProject(files.project);
    files.open(studio, files.project);
    EXPECT_FALSE(studio.window->document().holder().isEmpty());
    EXPECT_TRUE(studio.window->windowTitle().contains("open elsewhere"));
    ASSERT_TRUE(pumpUntil([&] {
        const QStringList& notices = studio.window->notices().notices();
        return !notices.isEmpty() && notices.front().contains("another Limner");
    }));
    rename(studio, "mine");
    const auto saved = fs::last_write_time(files.project);
    studio.window->savePath(files.project);
    EXPECT_FALSE(studio.window->busy()) << "refused with a word";
    EXPECT_EQ(fs::last_write_time(files.project), saved);
    const fs::path copy = files.project.parent_path() / "mine.limner";
    studio.window->savePath(copy);
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    EXPECT_TRUE(studio.window->document().holder().isEmpty());
    EXPECT_EQ(studio.window->document().projectPath(), copy);
}

TEST(Documents, ALockThatACrashLeftBlocksNobody) {
    const WithProject files;
    Studio studio;
    files.open(studio, files.scan);
    files.save(studio);
    studio.trigger("file.close");
    std::ofstream(files.project.parent_path() / ".head.limner.lock") << "process 1 on this machine";
    files.open(studio, files.project);
    EXPECT_TRUE(studio.window->document().holder().isEmpty());
}

TEST(Documents, RevertingIsAChangeThatCanBeUndone) {
    const WithProject files;
    Studio studio;
    files.open(studio, files.scan);
    EXPECT_FALSE(studio.window->actions().at("file.revert")->isEnabled()) << "it was never saved";
    rename(studio, "saved");
    files.save(studio);
    EXPECT_FALSE(studio.window->actions().at("file.revert")->isEnabled()) << "nothing has changed";
    rename(studio, "changed");
    bool reverted = false;
    QObject::connect(&of<WindowDocuments>(studio), &WindowDocuments::reverted, studio.window.get(),
                     [&] { reverted = true; });
    studio.trigger("file.revert");
    ASSERT_TRUE(pumpUntil([&] { return reverted; }));
    EXPECT_EQ(studio.figure().title, "saved");
    EXPECT_TRUE(studio.figure().volume->data);
    EXPECT_FALSE(studio.window->document().dirty());
    studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure().title, "changed");
    EXPECT_TRUE(studio.window->document().dirty());
}

TEST(Documents, ACopyLeavesTheDocumentWhereItIs) {
    const WithProject files;
    Studio studio;
    files.open(studio, files.scan);
    files.save(studio);
    rename(studio, "for the copy");
    const fs::path copy = files.project.parent_path() / "copy.limner";
    bool saved = false;
    QObject::connect(&of<WindowDocuments>(studio), &WindowDocuments::copySaved, studio.window.get(),
                     [&] { saved = true; });
    of<WindowDocuments>(studio).saveCopy(copy);
    ASSERT_TRUE(pumpUntil([&] { return saved; }));
    EXPECT_EQ(studio.window->document().projectPath(), files.project);
    EXPECT_TRUE(studio.window->document().dirty());
    Task task;
    EXPECT_EQ(openDocument(copy, OpenOptions{}, task).figure.title, "for the copy");
}

TEST(Documents, APackedProjectNeedsNoScanAndComesApartAgain) {
    const WithProject files;
    Studio studio;
    files.open(studio, files.scan);
    QAction* pack = studio.window->actions().at("file.pack");
    EXPECT_FALSE(pack->isChecked());
    pack->trigger();
    EXPECT_TRUE(pack->isChecked());
    files.save(studio);
    fs::remove(files.scan);
    files.open(studio, files.project);
    ASSERT_TRUE(studio.figure().volume->data);
    EXPECT_TRUE(pack->isChecked());
    const fs::path out = files.project.parent_path() / "out.nrrd";
    of<WindowDocuments>(studio).unpack(out);
    ASSERT_TRUE(pumpUntil([&] { return !studio.figure().volume->embedded; }));
    files.save(studio);
    Task task;
    const Document again = openDocument(files.project, OpenOptions{}, task);
    ASSERT_TRUE(again.figure.volume->data);
    EXPECT_FALSE(again.figure.volume->embedded);
    EXPECT_EQ(again.figure.volume->path, "out.nrrd");
    EXPECT_TRUE(again.notes.empty()) << again.notes.front();
    studio.trigger("edit.undo");
    EXPECT_TRUE(studio.figure().volume->embedded);
}

TEST(Documents, AScanThatMovedIsFoundByItself) {
    const WithProject files;
    Studio studio;
    files.open(studio, files.scan);
    files.save(studio);
    studio.trigger("file.close");
    const fs::path place = files.project.parent_path() / "scans" / "2024" / "renamed.nrrd";
    fs::create_directories(place.parent_path());
    fs::rename(files.scan, place);
    auto& documents = of<WindowDocuments>(studio);
    bool found = false;
    QObject::connect(&documents, &WindowDocuments::searched, studio.window.get(), [&](bool any) { found = any; });
    files.open(studio, files.project);
    EXPECT_FALSE(studio.figure().volume->data);
    EXPECT_TRUE(documents.missing().text().contains("scan.nrrd"));
    ASSERT_TRUE(pumpUntil([&] { return found; }));
    ASSERT_TRUE(studio.figure().volume->data);
    EXPECT_EQ(fs::weakly_canonical(studio.figure().volume->path), fs::weakly_canonical(place));
    EXPECT_TRUE(documents.missing().isHidden());
    EXPECT_TRUE(studio.window->document().histogram());
    EXPECT_TRUE(studio.waitForFinal());
    files.save(studio);
    Task task;
    EXPECT_EQ(openDocument(files.project, OpenOptions{}, task).figure.volume->path, "scans/2024/renamed.nrrd");
    studio.trigger("edit.undo");
    EXPECT_FALSE(studio.figure().volume->data);
    EXPECT_FALSE(documents.missing().isHidden());
}

TEST(Documents, AScanThatIsNowhereCanBeShownByHand) {
    const WithProject files;
    Studio studio;
    files.open(studio, files.scan);
    files.save(studio);
    studio.trigger("file.close");
    const QTemporaryDir elsewhere;
    const fs::path place = elsewhere.filePath("a.nrrd").toStdString();
    fs::copy_file(files.scan, place);
    fs::remove(files.scan);
    auto& documents = of<WindowDocuments>(studio);
    int searches = 0;
    QObject::connect(&documents, &WindowDocuments::searched, studio.window.get(), [&](bool) { ++searches; });
    files.open(studio, files.project);
    ASSERT_TRUE(pumpUntil([&] { return searches == 1; }));
    EXPECT_FALSE(documents.missing().isHidden());
    EXPECT_EQ(documents.missing().search()->text(), "Search again");
    documents.useFile(place);
    ASSERT_TRUE(pumpUntil([&] { return searches == 2; }));
    ASSERT_TRUE(studio.figure().volume->data);
}

/// A DICOM series is a folder: a dialog for files would only walk into it.
TEST(Documents, AFolderThatIsNowhereCanBeShownByHand) {
    const auto series = testing::testData("dicom/odd/torso128_reference");
    if (!series)
        GTEST_SKIP() << "the test scans are not here";
    const WithProject files;
    const fs::path slices = files.project.parent_path() / "slices";
    fs::copy(*series, slices);
    Studio studio;
    files.open(studio, slices);
    files.save(studio);
    studio.trigger("file.close");
    const QTemporaryDir elsewhere;
    const fs::path place = elsewhere.filePath("renamed").toStdString();
    fs::copy(slices, place);
    fs::remove_all(slices);
    auto& documents = of<WindowDocuments>(studio);
    int searches = 0;
    QObject::connect(&documents, &WindowDocuments::searched, studio.window.get(), [&](bool) { ++searches; });
    files.open(studio, files.project);
    ASSERT_TRUE(pumpUntil([&] { return searches == 1; }));
    QTimer::singleShot(0, studio.window.get(), [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        ASSERT_TRUE(dialog);
        EXPECT_EQ(dialog->fileMode(), QFileDialog::Directory);
        dialog->setDirectory(elsewhere.path());
        dialog->selectFile("renamed");
        static_cast<QDialog*>(dialog)->done(QDialog::Accepted);
    });
    documents.missing().findFolder()->click();
    ASSERT_TRUE(pumpUntil([&] { return searches == 2; }));
    ASSERT_TRUE(studio.figure().volume->data);
    EXPECT_EQ(fs::weakly_canonical(studio.figure().volume->path), fs::weakly_canonical(place));
    EXPECT_TRUE(documents.missing().isHidden());
}

TEST(Documents, StepsAndNamedStatesAreAClickAway) {
    const WithProject files;
    Studio studio;
    files.open(studio, files.scan);
    HistoryList& list = of<WindowHistory>(studio).list();
    EXPECT_EQ(list.steps()->count(), 1);
    for (const char* title : {"one", "two", "three"})
        rename(studio, title);
    ASSERT_EQ(list.steps()->count(), 4);
    EXPECT_EQ(list.steps()->item(2)->text(), "Rename to two");
    EXPECT_TRUE(list.steps()->item(3)->font().bold());
    Q_EMIT list.steps()->itemClicked(list.steps()->item(1));
    EXPECT_EQ(studio.figure().title, "one");
    EXPECT_EQ(list.steps()->count(), 4) << "no step is lost";
    EXPECT_TRUE(list.steps()->item(1)->font().bold());
    of<WindowHistory>(studio).nameState("good one");
    Q_EMIT list.steps()->itemClicked(list.steps()->item(0));
    rename(studio, "other");
    EXPECT_EQ(list.steps()->count(), 2);
    ASSERT_EQ(list.names()->count(), 1);
    Q_EMIT list.names()->itemClicked(list.names()->item(0));
    EXPECT_EQ(studio.figure().title, "one") << "a named state outlives its step";
    studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure().title, "other");
    list.names()->item(0)->setText("better name");
    studio.trigger("file.close");
    EXPECT_EQ(list.names()->count(), 0);
    EXPECT_FALSE(list.isEnabled());
}

} // namespace
} // namespace limner
