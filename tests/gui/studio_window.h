#pragma once

#include "app/studio/main_window.h"
#include "app/studio/studio_theme.h"
#include "support/qt/qt_events.h"
#include "widgets/picture_feed.h"
#include "widgets/viewport.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace limner::testing {

/// The real window with a library of styles of its own.
struct Studio {
    Studio() {
        qputenv("LIMNER_STYLES", styles.path().toUtf8());
        qputenv("LIMNER_RECOVERY", styles.filePath("recovery").toUtf8());
        applyStudioTheme(*qApp);
        window = std::make_unique<MainWindow>(makeEngine());
        window->askAboutChanges = [] { return MainWindow::Answer::discard; };
        window->show();
        if (!QTest::qWaitForWindowExposed(window.get()))
            ADD_FAILURE() << "the window does not show";
    }
    [[nodiscard]] const Figure& figure() const { return *window->document().figure(); }
    [[nodiscard]] bool hasFinal() const {
        const auto& picture = window->viewport().picture();
        return picture && picture->facts.final && picture->image.size() == window->viewport().picturePixels();
    }
    bool waitForFinal() {
        return pumpUntil([this] {
            return hasFinal() && window->viewport().picture()->plan->figure->layers == figure().layers &&
                   window->viewport().picture()->plan->figure->camera == figure().camera;
        });
    }
    bool openSample() {
        window->openSample();
        return pumpUntil([this] { return !window->document().empty(); }) && waitForResources() && waitForFinal();
    }
    /// Styles, presets and themes are read beside the window's thread: on a slow machine the sample is there first.
    bool waitForResources() {
        return pumpUntil([this] { return window->findChild<QAction*>("theme.blackboard") != nullptr; });
    }
    void trigger(const char* id) { window->actions().at(id)->trigger(); }
    QTemporaryDir styles;
    std::unique_ptr<MainWindow> window;
};

} // namespace limner::testing
