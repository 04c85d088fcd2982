#include "app/studio/studio_document.h"

#include <utility>

namespace limner {

bool isProject(const std::filesystem::path& path) {
    return path.extension() == ".limner" || path.extension() == ".json";
}

QString StudioDocument::name() const {
    if (!open_)
        return {};
    if (!projectPath_.empty())
        return QString::fromStdString(projectPath_.filename().string());
    const auto& volume = history_.current()->volume;
    const std::filesystem::path scan = volume ? volume->path : std::string();
    const std::filesystem::path last = scan.has_filename() ? scan.filename() : scan.parent_path().filename();
    return last.empty() ? tr("Untitled") : QString::fromStdString(last.string());
}

void StudioDocument::open(Document document, std::shared_ptr<const Histogram> histogram, Opened how) {
    source_ = std::move(document);
    histogram_ = std::move(histogram);
    projectPath_ = isProject(source_.path) ? source_.path : std::filesystem::path();
    history_ = History(source_.figure);
    // A scan's first figure can be had again at any time; no state has the number 0.
    savedState_ = how == Opened::fresh ? history_.stateId() : 0;
    opened_ = how;
    holder_.clear();
    open_ = true;
    ongoing_ = false;
    ++generation_;
    Q_EMIT changed();
}

void StudioDocument::close() {
    source_ = {};
    histogram_.reset();
    projectPath_.clear();
    holder_.clear();
    history_ = History();
    open_ = false;
    ++generation_;
    Q_EMIT changed();
}

void StudioDocument::apply(const Edit& edit) {
    if (!open_)
        return;
    const bool settles = ongoing_ && !edit.ongoing;
    ongoing_ = edit.ongoing;
    if (history_.apply(edit) || settles)
        Q_EMIT changed();
}

void StudioDocument::undo() {
    ongoing_ = false;
    if (history_.undo())
        Q_EMIT changed();
}

void StudioDocument::redo() {
    ongoing_ = false;
    if (history_.redo())
        Q_EMIT changed();
}

void StudioDocument::goTo(std::size_t position) {
    ongoing_ = false;
    if (history_.goTo(position))
        Q_EMIT changed();
}

void StudioDocument::setScan(std::shared_ptr<const Histogram> histogram, ImportReport report) {
    histogram_ = std::move(histogram);
    source_.volumeReport = std::move(report);
}

void StudioDocument::setHolder(const QString& holder) {
    if (holder_ == holder)
        return;
    holder_ = holder;
    Q_EMIT changed();
}

Document StudioDocument::snapshot() const {
    Document document = source_;
    document.figure = *history_.current();
    document.path = projectPath_.empty() ? source_.path : projectPath_;
    return document;
}

void StudioDocument::setSaved(const std::filesystem::path& path, History::StateId state) {
    projectPath_ = path;
    savedState_ = state;
    history_.endMerge(); // a gesture that goes on does not reach back into what was saved
    Q_EMIT changed();
}

} // namespace limner
