#pragma once

#include "app/studio/engine.h"
#include "app/studio/studio_document.h"
#include "core/base/error.h"

#include <QPointer>
#include <QString>
#include <Qt>

#include <cstddef>
#include <functional>
#include <vector>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace limner {

class Actions;
class Job;
class LayerList;
class NoticeBar;
class ProgressStrip;
class TransferEditor1d;
class Viewport;

/// What the window lends its features (window_*.h): each is a QObject of its own that is made in window_features.cpp,
/// listens to the document, brings its panel and connects its actions. All of this outlives the features; all on the
/// interface's thread.
struct Workplace {
    QMainWindow* window;
    StudioDocument* document;
    Actions* actions;
    Viewport* viewport;
    LayerList* layers;
    TransferEditor1d* transfer;
    NoticeBar* notices;
    ProgressStrip* progress;
    Engine engine;
    /// A panel of the window; `name` ("dock.view") is what saved layouts go by. It stands as a tab behind the transfer
    /// function where the area is the right one.
    std::function<QDockWidget*(const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area)>
        addDock;
    /// Starts nothing yet: a job that shows its errors and deletes itself; a running one of the slot is cancelled.
    std::function<Job*(QPointer<Job>& slot, const QString& name, std::function<void(Task&)> work)> makeJob;
    std::function<void(const Error& error)> showError;
    /// Opens what `load` gives on a thread of its own, once unsaved changes are saved or given up.
    std::function<void(const QString& name, std::function<Document(Task&)> load, Opened how)> openDocument;
    /// Of the shown picture, 256 pixels square, as a PNG; empty: there is none.
    std::function<std::vector<std::byte>()> thumbnail;
    std::function<void(const QString& message)> tell; ///< a line in the status bar, for some seconds
};

} // namespace limner
