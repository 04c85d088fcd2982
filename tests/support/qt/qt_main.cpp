#include "support/qt/timed_application.h"

#include <gtest/gtest.h>

#include <QSettings>
#include <QTemporaryDir>

namespace {

/// Tells the application which test its events belong to.
class Names : public ::testing::EmptyTestEventListener {
  public:
    explicit Names(limner::testing::TimedApplication* application) : application_(application) {}
    void OnTestStart(const ::testing::TestInfo& test) override {
        application_->startTest(std::string(test.test_suite_name()) + "." + test.name());
    }

  private:
    limner::testing::TimedApplication* application_;
};

} // namespace

/// Runs tests that make widgets: the application stands before the first test's first member and outlives the last.
/// Settings go to a folder of the run's own.
int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    limner::testing::TimedApplication application(argc, argv);
    QApplication::setOrganizationName("LimnerTest");
    QApplication::setApplicationName("limner-test");
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    if (!qEnvironmentVariableIsSet("LIMNER_RECOVERY")) // tests leave no unsaved work with the user
        qputenv("LIMNER_RECOVERY", settings.filePath("recovery").toUtf8());
    ::testing::UnitTest::GetInstance()->listeners().Append(new Names(&application));
    const int failed = RUN_ALL_TESTS();
    application.report();
    return failed;
}
