#include "app/studio/main_window.h"
#include "app/studio/studio_theme.h"

#include <QApplication>
#include <QCommandLineParser>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace {

/// Whether only text is asked for, which needs no display.
bool asksForText(int argc, char** argv) {
    constexpr std::string_view kText[] = {"-h", "--help", "--help-all", "-v", "--version"};
    return std::any_of(argv + 1, argv + argc, [&](const char* argument) {
        return std::find(std::begin(kText), std::end(kText), argument) != std::end(kText);
    });
}

} // namespace

int main(int argc, char** argv) {
    if (asksForText(argc, argv)) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    QApplication::setOrganizationName("Limner");
    QApplication::setApplicationName("limner-studio");
    QApplication::setApplicationDisplayName("Limner Studio");
    QApplication::setApplicationVersion(LIMNER_VERSION);
    limner::applyStudioTheme(application);

    QCommandLineParser arguments;
    arguments.setApplicationDescription(
        QCoreApplication::translate("main", "Makes print-ready illustrations of CT and MR scans."));
    arguments.addHelpOption();
    arguments.addVersionOption();
    arguments.addPositionalArgument(
        "file", QCoreApplication::translate("main", "A scan, a folder of slices, a project or a figure to open."),
        "[file]");
    arguments.process(application);

    limner::MainWindow window(limner::makeEngine());
    window.show();
    if (!arguments.positionalArguments().isEmpty())
        window.openPath(arguments.positionalArguments().front().toStdString());
    return QApplication::exec();
}
