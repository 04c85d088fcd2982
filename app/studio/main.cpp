#include "app/studio/main_window.h"
#include "app/studio/studio_language.h"
#include "app/studio/studio_theme.h"
#include "app/studio/window_workspace.h"

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
    limner::applyStudioLanguage(application);
    limner::applyStudioTheme(application, limner::chosenStudioTheme());

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
    auto* workspace = window.findChild<limner::WindowWorkspace*>();
    workspace->restoreLast();
    QObject::connect(&application, &QCoreApplication::aboutToQuit, workspace, &limner::WindowWorkspace::keepLast);
    window.show();
    if (!arguments.positionalArguments().isEmpty())
        window.openPath(arguments.positionalArguments().front().toStdString());
    return QApplication::exec();
}
