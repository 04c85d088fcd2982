#pragma once

#include "core/project/history.h"
#include "core/project/project.h"
#include "core/volume/histogram.h"

#include <QObject>
#include <QString>

#include <memory>

namespace limner {

/// How a document came to be open.
enum class Opened {
    fresh,    ///< as it is in its file
    restored, ///< unsaved work of a session that ended without warning: it is in no file yet
};

/// The document of a window: the figure with its history, where it is kept, and whether it differs from that. All on
/// the interface's thread. Whatever changes, one signal says so.
class StudioDocument : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    [[nodiscard]] bool empty() const { return !open_; }
    /// Null where nothing is open.
    [[nodiscard]] std::shared_ptr<const Figure> figure() const { return open_ ? history_.current() : nullptr; }
    [[nodiscard]] const History& history() const { return history_; }
    [[nodiscard]] const std::shared_ptr<const Histogram>& histogram() const { return histogram_; }
    [[nodiscard]] const Document& source() const { return source_; }
    /// The project's path; empty for the fresh figure of a scan.
    [[nodiscard]] std::filesystem::path projectPath() const { return projectPath_; }
    /// For titles: the project's or the scan's file name.
    [[nodiscard]] QString name() const;
    [[nodiscard]] bool dirty() const { return open_ && history_.stateId() != savedState_; }
    /// A drag is going on: drafts are enough.
    [[nodiscard]] bool gestureOngoing() const { return ongoing_; }
    /// Counts documents, so that work started for an earlier one is not applied to a later one.
    [[nodiscard]] unsigned generation() const { return generation_; }

    /// Restored work has its project's path in `document.path`, and is dirty.
    void open(Document document, std::shared_ptr<const Histogram> histogram, Opened how = Opened::fresh);
    [[nodiscard]] Opened opened() const { return opened_; }
    void close();
    void apply(const Edit& edit);
    void undo();
    void redo();
    /// Goes to a state of the history by its place there.
    void goTo(std::size_t position);
    /// What was found of a scan that was missing when the document was opened. The edit that brings it follows.
    void setScan(std::shared_ptr<const Histogram> histogram, ImportReport report);
    /// Which other program has the project open; empty: none. Saving then asks for another name.
    void setHolder(const QString& holder);
    [[nodiscard]] const QString& holder() const { return holder_; }
    /// The document as it is, for a worker that writes it.
    [[nodiscard]] Document snapshot() const;
    /// It was written as it was in that state.
    void setSaved(const std::filesystem::path& path, History::StateId state);

  Q_SIGNALS:
    void changed();

  private:
    bool open_ = false;
    Document source_; ///< as it was opened; its figure is not the current one
    std::filesystem::path projectPath_;
    std::shared_ptr<const Histogram> histogram_;
    History history_;
    History::StateId savedState_ = 0;
    bool ongoing_ = false;
    Opened opened_ = Opened::fresh;
    QString holder_;
    unsigned generation_ = 0;
};

/// Whether a path names a project or a bare figure rather than a scan.
bool isProject(const std::filesystem::path& path);

} // namespace limner
