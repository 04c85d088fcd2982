#include "widgets/notice_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <utility>

namespace limner {

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent), text_(new QLabel), action_(new QToolButton), more_(new QToolButton), close_(new QToolButton) {
    setFrameShape(QFrame::NoFrame);
    setAutoFillBackground(true);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text_->setAccessibleName(tr("Notices"));
    action_->setAutoRaise(false);
    action_->setVisible(false);
    more_->setAutoRaise(true);
    close_->setAutoRaise(true);
    close_->setText(tr("Dismiss"));
    close_->setToolTip(tr("Hide this notice"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 5, 6, 5);
    layout->setSpacing(6);
    layout->addWidget(text_, 1);
    layout->addWidget(action_);
    layout->addWidget(more_);
    layout->addWidget(close_);
    connect(close_, &QToolButton::clicked, this, [this] { setNotices({}, Kind::information); });
    connect(action_, &QToolButton::clicked, this, [this] {
        const auto then = std::exchange(then_, nullptr);
        setNotices({}, Kind::information);
        if (then)
            then();
    });
    connect(more_, &QToolButton::clicked, this, [this] {
        expanded_ = !expanded_;
        display();
    });
    display();
}

void NoticeBar::setNotices(const QStringList& lines, Kind kind) {
    lines_ = lines;
    lines_.removeDuplicates();
    then_ = nullptr;
    expanded_ = false;
    kind_ = kind;
    dress();
    display();
}

void NoticeBar::dress() {
    QPalette colours = palette();
    const bool dark = parentWidget() && parentWidget()->palette().color(QPalette::Window).lightness() < 128;
    const QColor calm = dark ? QColor(0x2b, 0x3d, 0x52) : QColor(0xe4, 0xee, 0xf8);
    const QColor alarm = dark ? QColor(0x5a, 0x30, 0x2b) : QColor(0xfb, 0xe5, 0xdf);
    const QColor wanted = kind_ == Kind::problem ? alarm : calm;
    if (colours.color(QPalette::Window) == wanted)
        return;
    colours.setColor(QPalette::Window, wanted);
    setPalette(colours);
}

void NoticeBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
        dress(); // the window went from light to dark
    QFrame::changeEvent(event);
}

void NoticeBar::offer(const QString& line, const QString& action, std::function<void()> then) {
    setNotices({line}, Kind::information);
    then_ = std::move(then);
    action_->setText(action);
    display();
}

void NoticeBar::display() {
    setVisible(!lines_.isEmpty());
    action_->setVisible(then_ != nullptr);
    more_->setVisible(lines_.size() > 1);
    more_->setText(expanded_ ? tr("Less") : tr("%1 more").arg(lines_.size() - 1));
    text_->setText(lines_.isEmpty() ? QString() : expanded_ ? lines_.join('\n') : lines_.front());
}

} // namespace limner
