#include "app/studio/window_history.h"

#include "app/studio/action_table.h"
#include "widgets/history_list.h"

#include <QAction>
#include <QInputDialog>
#include <QMainWindow>

namespace limner {

WindowHistory::WindowHistory(const Workplace& place) : QObject(place.window), place_(place), list_(new HistoryList) {
    place_.addDock("dock.history", tr("History"), list_, Qt::RightDockWidgetArea);
    connect(list_, &HistoryList::goWanted, place_.document, &StudioDocument::goTo);
    connect(list_, &HistoryList::nameWanted, this, &WindowHistory::askName);
    connect(place_.actions->at("edit.name-state"), &QAction::triggered, this, &WindowHistory::askName);
    connect(list_, &HistoryList::namedWanted, this, &WindowHistory::goToNamed);
    connect(list_, &HistoryList::renamed, this,
            [this](int at, const QString& name) { named_.at(static_cast<std::size_t>(at)).name = name; });
    connect(list_, &HistoryList::forgetWanted, this, [this](int at) {
        named_.erase(named_.begin() + at);
        showNames();
    });
    connect(place_.document, &StudioDocument::changed, this, &WindowHistory::show);
    show();
}

void WindowHistory::show() {
    const StudioDocument& document = *place_.document;
    if (generation_ != document.generation()) {
        generation_ = document.generation();
        named_.clear();
        showNames();
    }
    list_->setHistory(document.empty() ? nullptr : &document.history());
    place_.actions->at("edit.name-state")->setEnabled(!document.empty());
}

void WindowHistory::showNames() {
    QStringList names;
    for (const Named& named : named_)
        names << named.name;
    list_->setNames(names);
}

void WindowHistory::askName() {
    if (place_.document->empty())
        return;
    const QString name = QInputDialog::getText(place_.window, tr("Name this state"), tr("Name:"), QLineEdit::Normal,
                                               tr("State %1").arg(named_.size() + 1));
    if (!name.trimmed().isEmpty())
        nameState(name.trimmed());
}

void WindowHistory::nameState(const QString& name) {
    if (place_.document->empty())
        return;
    named_.push_back({name, place_.document->figure()});
    showNames();
}

void WindowHistory::goToNamed(int place) {
    if (place < 0 || place >= static_cast<int>(named_.size()))
        return;
    const Named& named = named_[static_cast<std::size_t>(place)];
    place_.document->apply({*named.figure, tr("Go to “%1”").arg(named.name).toStdString(), {}, false});
}

} // namespace limner
