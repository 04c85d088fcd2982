#include "widgets/output_list.h"

#include "widgets/form_parts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

QString stateText(const OutputRow& row) {
    switch (row.state) {
    case OutputRow::State::queued: return OutputList::tr("waits");
    case OutputRow::State::running:
        return row.phase.isEmpty() ? OutputList::tr("begins")
                                   : OutputList::tr("%1, %2 %").arg(row.phase).arg(std::floor(100 * row.fraction));
    case OutputRow::State::done: return OutputList::tr("done");
    case OutputRow::State::failed: return OutputList::tr("failed: %1").arg(row.problem);
    case OutputRow::State::stopped: return OutputList::tr("stopped; “Go on” continues where it was");
    }
    return {};
}

} // namespace

OutputList::OutputList(QWidget* parent)
    : QWidget(parent), list_(new QVBoxLayout),
      none_(new QLabel(tr("No picture has been exported yet. “Export” writes one while you go on working; several wait "
                          "for each other here."))) {
    none_->setWordWrap(true);
    none_->setForegroundRole(QPalette::PlaceholderText);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(8, 8, 8, 8);
    column->addWidget(none_);
    list_->setSpacing(10);
    column->addLayout(list_);
    column->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scrolling(content));
}

OutputList::Line OutputList::makeLine(int id) {
    constexpr int kSteps = 1000; // finer than a bar's pixels
    Line line;
    line.id = id;
    line.box = new QWidget;
    line.name = new QLabel;
    line.name->setMinimumWidth(1); // a long name must not widen the panel
    line.status = new QLabel;
    line.status->setWordWrap(true);
    line.status->setTextInteractionFlags(Qt::TextSelectableByMouse);
    line.bar = new QProgressBar;
    line.bar->setRange(0, kSteps);
    line.bar->setTextVisible(false);
    line.bar->setMaximumHeight(8);
    line.cancel = textButton(tr("Stop"), tr("Stop this; what is drawn already is kept for going on"));
    line.retry = textButton(tr("Go on"), tr("Write this picture again, from where it stopped"));
    line.show = textButton(tr("Show"), tr("Open the picture in the program that your desktop has for it"));
    line.folder = textButton(tr("Folder"), tr("Open the folder that the picture is in"));
    line.remove = textButton(tr("Remove"), tr("Take this off the list; a finished picture stays where it is"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    for (QToolButton* button : {line.cancel, line.retry, line.show, line.folder, line.remove})
        buttons->addWidget(button);
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(line.box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    layout->addWidget(line.name);
    layout->addWidget(line.bar);
    layout->addWidget(line.status);
    layout->addLayout(buttons);
    connect(line.cancel, &QToolButton::clicked, this, [this, id] { Q_EMIT cancelWanted(id); });
    connect(line.retry, &QToolButton::clicked, this, [this, id] { Q_EMIT retryWanted(id); });
    connect(line.show, &QToolButton::clicked, this, [this, id] { Q_EMIT showWanted(id); });
    connect(line.folder, &QToolButton::clicked, this, [this, id] { Q_EMIT folderWanted(id); });
    connect(line.remove, &QToolButton::clicked, this, [this, id] { Q_EMIT removeWanted(id); });
    return line;
}

void OutputList::setRows(const std::vector<OutputRow>& rows) {
    std::erase_if(lines_, [&](const Line& line) {
        const bool gone =
            std::none_of(rows.begin(), rows.end(), [&](const OutputRow& row) { return row.id == line.id; });
        if (gone) {
            list_->removeWidget(line.box);
            line.box->hide();
            line.box->deleteLater(); // its button may be the one that was pressed
        }
        return gone;
    });
    for (const OutputRow& row : rows) {
        if (!find(row.id)) {
            lines_.push_back(makeLine(row.id));
            list_->insertWidget(0, lines_.back().box); // the newest is what one looks for
        }
        showRow(*find(row.id), row);
    }
    none_->setVisible(rows.empty());
}

void OutputList::showRow(const Line& line, const OutputRow& row) {
    using State = OutputRow::State;
    line.name->setText(QString("<b>%1</b> · %2").arg(row.name.toHtmlEscaped(), row.facts.toHtmlEscaped()));
    line.name->setToolTip(row.folder);
    line.status->setText(stateText(row));
    const bool active = row.state == State::queued || row.state == State::running;
    const bool ended = row.state == State::failed || row.state == State::stopped;
    line.bar->setVisible(active);
    line.bar->setValue(static_cast<int>(std::clamp(row.fraction, 0.0, 1.0) * line.bar->maximum()));
    line.bar->setAccessibleName(tr("Progress of %1").arg(row.name));
    line.cancel->setVisible(active);
    line.retry->setVisible(ended);
    line.show->setVisible(row.state == State::done);
    line.folder->setVisible(row.state == State::done);
    line.remove->setVisible(!active);
}

const OutputList::Line* OutputList::find(int id) const {
    const auto at = std::find_if(lines_.begin(), lines_.end(), [&](const Line& line) { return line.id == id; });
    return at == lines_.end() ? nullptr : &*at;
}

QToolButton* OutputList::button(int id, const QString& what) const {
    const Line* line = find(id);
    if (!line)
        return nullptr;
    return what == "cancel"   ? line->cancel
           : what == "retry"  ? line->retry
           : what == "show"   ? line->show
           : what == "folder" ? line->folder
                              : line->remove;
}

QString OutputList::status(int id) const {
    const Line* line = find(id);
    return line ? line->status->text() : QString();
}

} // namespace limner
