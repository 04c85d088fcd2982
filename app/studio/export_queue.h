#pragma once

#include "app/studio/engine.h"
#include "renderer/export/picture_file.h"
#include "widgets/output_list.h"

#include <QObject>
#include <QPointer>

#include <filesystem>
#include <memory>
#include <vector>

namespace limner {

class Job;

/// Exports of a session, one after the other in the background: each is the figure as it was when it was asked for.
/// One that fails or is stopped keeps what is drawn and goes on from there. On the interface's thread.
class ExportQueue : public QObject {
    Q_OBJECT

  public:
    struct Request {
        std::shared_ptr<const Figure> figure; ///< with its output's size and samples per pixel
        std::filesystem::path path;
        PictureOptions options;
    };

    ExportQueue(Engine engine, QObject* parent);
    /// Stops what runs and waits for it.
    ~ExportQueue() override;

    /// Gives its number.
    int add(Request request);
    /// Stops a running one, or takes a waiting one out of the line.
    void cancel(int id);
    /// Puts a failed or stopped one back into the line.
    void retry(int id);
    /// Takes one off the list; what an unfinished one has kept is dropped.
    void remove(int id);
    /// What is or will be done; for a list.
    [[nodiscard]] std::vector<OutputRow> rows() const;
    [[nodiscard]] std::filesystem::path pathOf(int id) const;
    /// Something runs or waits.
    [[nodiscard]] bool busy() const;
    /// The one that runs; null: none.
    [[nodiscard]] Job* job() const;

  Q_SIGNALS:
    void changed();
    void started(limner::Job* job);
    void written(const QString& path);
    void failed(int id, const limner::Error& error);

  private:
    struct Item {
        Request request;
        OutputRow row;
    };
    void next();
    void ended(int id, OutputRow::State state, const QString& problem);
    Item* find(int id);

    Engine engine_;
    std::shared_ptr<const Backend> backend_;
    std::vector<Item> items_;
    QPointer<Job> job_;
    int running_ = 0; ///< its number; 0: none
    int lastId_ = 0;
};

} // namespace limner
