#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

/// Runs tests that make widgets: the application stands before the first test's first member and outlives the last.
/// Settings go to a folder of the run's own.
int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    const QApplication application(argc, argv);
    QApplication::setOrganizationName("LimnerTest");
    QApplication::setApplicationName("limner-test");
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    if (!qEnvironmentVariableIsSet("LIMNER_RECOVERY")) // tests leave no unsaved work with the user
        qputenv("LIMNER_RECOVERY", settings.filePath("recovery").toUtf8());
    return RUN_ALL_TESTS();
}
