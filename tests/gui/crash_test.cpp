// Kills a window that is worked in, at random moments, and looks at what comes back.
#include "gui/studio_window.h"

#include "app/studio/window_recovery.h"
#include "core/project/embedded_volume.h"
#include "core/project/recovery.h"
#include "core/volume/phantom.h"
#include "support/qt/qt_events.h"

#include <QElapsedTimer>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTimer>

#include <iostream>
#include <random>

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::pumpUntil;

constexpr const char* kScan = "LIMNER_TEST_CRASH_SCAN";   // set: this run is the one that is killed
constexpr const char* kTimes = "LIMNER_TEST_CRASH_TIMES"; // how often; the test's own number where it is not set
constexpr int kEditMs = 20;                               // between two changes: faster than a hand
constexpr int kMostLost = 50;                             // changes

/// Works in a window for ever, and prints the number of each change once it is made.
void work(const fs::path& scan) {
    MainWindow window(makeEngine());
    window.show();
    if (scan.empty())
        window.openSample();
    else
        window.openPath(scan);
    pumpUntil([&] { return !window.document().empty(); });
    int count = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &window, [&] {
        Edit edit{*window.document().figure(), "Change", {}, false};
        edit.figure.title = std::to_string(++count);
        window.document().apply(edit);
        std::cout << count << std::endl; // flushed: the reader counts it as made
    });
    QObject::connect(window.findChild<WindowRecovery*>(), &WindowRecovery::kept, &window,
                     [] { std::cout << "kept" << std::endl; });
    timer.start(kEditMs);
    QApplication::exec();
}

/// Starts such a window, and kills it some milliseconds after its first autosave. Gives the newest change that it made.
int workAndDie(const fs::path& scan, const QString& recovery, int afterMs) {
    QProcess child;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(kScan, QString::fromStdString(scan.string()));
    environment.insert("LIMNER_RECOVERY", recovery);
    child.setProcessEnvironment(environment);
    child.start("/proc/self/exe", {"--gtest_filter=Crash.*"}, QIODevice::ReadOnly);
    child.waitForStarted();
    QByteArray said;
    while (!said.contains("kept") && child.waitForReadyRead(60'000))
        said += child.readAllStandardOutput();
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < afterMs)
        if (child.waitForReadyRead(std::max(1, afterMs - static_cast<int>(clock.elapsed()))))
            said += child.readAllStandardOutput();
    child.kill(); // SIGKILL
    child.waitForFinished();
    said += child.readAllStandardOutput();
    int newest = 0;
    for (const QByteArray& line : said.split('\n'))
        newest = std::max(newest, line.trimmed().toInt());
    return newest;
}

TEST(Crash, AtAnyMomentLosesAtMostFiftyChangesAndOffersTheRest) {
    if (qEnvironmentVariableIsSet(kScan)) {
        work(qEnvironmentVariable(kScan).toStdString());
        return;
    }
    const QTemporaryDir folder;
    const fs::path scan = folder.filePath("scan.nrrd").toStdString();
    Task task;
    writeNrrd(*makeHeadPhantom(32), scan, task);
    const int times = qEnvironmentVariableIsSet(kTimes) ? qEnvironmentVariableIntValue(kTimes) : 6;
    std::mt19937 random(8); // the same moments in every run
    int worst = 0;
    int offered = 0;
    for (int i = 0; i < times; ++i) {
        const QString recovery = folder.filePath(QString::number(i));
        const int newest = workAndDie(scan, recovery, static_cast<int>(random() % 2500));
        ASSERT_GT(newest, 0);
        const std::vector<RecoveryEntry> left = unsavedWork(recovery.toStdString());
        ASSERT_EQ(left.size(), 1U) << "crash " << i;
        ++offered;
        const int found = std::stoi(openWork(left[0], task).document.figure.title);
        EXPECT_LE(newest - found, kMostLost) << "crash " << i;
        worst = std::max(worst, newest - found);
    }
    std::cout << times << " crashes, " << offered << " offered, at most " << worst << " changes lost\n";
}

/// The window that comes after a crash shows the offer, and its restored work outlives a crash of its own.
TEST(Crash, OfARestoredWindowLosesNothingEither) {
    if (qEnvironmentVariableIsSet(kScan))
        return;
    const QTemporaryDir folder;
    const fs::path scan = folder.filePath("scan.nrrd").toStdString();
    Task task;
    writeNrrd(*makeHeadPhantom(32), scan, task);
    const QString recovery = folder.filePath("recovery");
    workAndDie(scan, recovery, 100);
    const std::vector<RecoveryEntry> left = unsavedWork(recovery.toStdString());
    ASSERT_EQ(left.size(), 1U);
    qputenv("LIMNER_RECOVERY", recovery.toUtf8());
    std::string title;
    {
        MainWindow window(makeEngine());
        window.show();
        auto* feature = window.findChild<WindowRecovery*>();
        ASSERT_EQ(feature->offered().size(), 1U);
        feature->restore(0);
        ASSERT_TRUE(pumpUntil([&] { return !window.document().empty(); }));
        title = window.document().figure()->title;
        EXPECT_TRUE(unsavedWork(recovery.toStdString()).empty());
    } // torn down with unsaved changes, without being asked
    const std::vector<RecoveryEntry> again = unsavedWork(recovery.toStdString());
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(openWork(again[0], task).document.figure.title, title);
}

} // namespace
} // namespace limner
