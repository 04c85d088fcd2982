#include "app/studio/export_queue.h"

#include "widgets/job.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace limner {

using State = OutputRow::State;

ExportQueue::ExportQueue(Engine engine, QObject* parent)
    : QObject(parent), engine_(std::move(engine)), backend_(engine_.makeBackend()) {}

ExportQueue::~ExportQueue() { delete job_; }

int ExportQueue::add(Request request) {
    const glm::ivec2 size = request.figure->output.sizePixels();
    OutputRow row;
    row.id = ++lastId_;
    row.name = QString::fromStdString(request.path.filename().string());
    row.folder = QString::fromStdString(request.path.parent_path().string());
    row.facts = tr("%1 × %2 pixels").arg(QLocale().toString(size.x), QLocale().toString(size.y));
    request.options.resumable = true;
    items_.push_back({std::move(request), std::move(row)});
    next();
    Q_EMIT changed();
    return lastId_;
}

void ExportQueue::cancel(int id) {
    Item* item = find(id);
    if (item && id == running_ && job_) {
        job_->cancel(); // the rest follows when it has stopped
    } else if (item && item->row.state == State::queued) {
        item->row.state = State::stopped;
        Q_EMIT changed();
    }
}

void ExportQueue::retry(int id) {
    Item* item = find(id);
    if (!item || (item->row.state != State::failed && item->row.state != State::stopped))
        return;
    item->row.state = State::queued;
    item->row.problem.clear();
    item->row.fraction = 0;
    next();
    Q_EMIT changed();
}

void ExportQueue::remove(int id) {
    const Item* item = find(id);
    if (!item || id == running_)
        return;
    if (item->row.state != State::done)
        forgetUnfinished(item->request.path);
    std::erase_if(items_, [id](const Item& other) { return other.row.id == id; });
    Q_EMIT changed();
}

std::vector<OutputRow> ExportQueue::rows() const {
    std::vector<OutputRow> rows;
    for (const Item& item : items_)
        rows.push_back(item.row);
    return rows;
}

std::filesystem::path ExportQueue::pathOf(int id) const {
    for (const Item& item : items_)
        if (item.row.id == id)
            return item.request.path;
    return {};
}

bool ExportQueue::busy() const {
    return std::any_of(items_.begin(), items_.end(), [](const Item& item) {
        return item.row.state == State::queued || item.row.state == State::running;
    });
}

Job* ExportQueue::job() const { return job_; }

ExportQueue::Item* ExportQueue::find(int id) {
    const auto at = std::find_if(items_.begin(), items_.end(), [id](const Item& item) { return item.row.id == id; });
    return at == items_.end() ? nullptr : &*at;
}

void ExportQueue::next() {
    const auto at =
        std::find_if(items_.begin(), items_.end(), [](const Item& item) { return item.row.state == State::queued; });
    if (running_ != 0 || at == items_.end())
        return;
    const int id = running_ = at->row.id;
    at->row.state = State::running;
    at->row.phase.clear();
    job_ = new Job(
        tr("Exporting %1").arg(at->row.name),
        [plan = engine_.plan, backend = backend_, request = at->request](Task& task) {
            const auto made = plan(*request.figure, {}, task);
            exportPicture(*made, *backend, request.path, request.options, task);
        },
        this);
    connect(job_, qOverload<const QString&, double>(&Job::progressed), this,
            [this, id](const QString& phase, double fraction) {
                if (Item* item = find(id)) {
                    item->row.phase = phase;
                    item->row.fraction = fraction;
                    Q_EMIT changed();
                }
            });
    connect(job_, &Job::finished, this, [this, id] { ended(id, State::done, {}); });
    connect(job_, &Job::cancelled, this, [this, id] { ended(id, State::stopped, {}); });
    connect(job_, &Job::failed, this, [this, id](const Error& error) {
        ended(id, State::failed, QString::fromUtf8(error.what()));
        Q_EMIT failed(id, error);
    });
    Q_EMIT started(job_);
    job_->start();
}

void ExportQueue::ended(int id, State state, const QString& problem) {
    job_->deleteLater();
    job_.clear();
    running_ = 0;
    if (Item* item = find(id)) {
        item->row.state = state;
        item->row.problem = problem;
        item->row.fraction = state == State::done ? 1 : 0;
        if (state == State::done)
            Q_EMIT written(QString::fromStdString(item->request.path.string()));
    }
    next();
    Q_EMIT changed();
}

} // namespace limner
