#include "widgets/missing_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace limner {

MissingBar::MissingBar(QWidget* parent)
    : QFrame(parent), text_(new QLabel), find_(new QToolButton), findFolder_(new QToolButton),
      search_(new QToolButton) {
    setObjectName("missing");
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    setBackgroundRole(QPalette::Base); // it stands out from the grey around the sheet
    text_->setWordWrap(true);
    text_->setAccessibleName(tr("Missing file"));
    find_->setText(tr("Find file…"));
    find_->setToolTip(tr("Show where the file is now"));
    findFolder_->setText(tr("Find folder…"));
    findFolder_->setToolTip(tr("Show where the folder of slices is now"));
    auto* hide = new QToolButton;
    hide->setText(tr("Not now"));
    hide->setAutoRaise(true);
    hide->setToolTip(tr("Hide this; the project stays as it is and looks for the file when it is opened again"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 5, 6, 5);
    layout->setSpacing(6);
    layout->addWidget(text_, 1);
    layout->addWidget(find_);
    layout->addWidget(findFolder_);
    layout->addWidget(search_);
    layout->addWidget(hide);
    connect(find_, &QToolButton::clicked, this, &MissingBar::findWanted);
    connect(findFolder_, &QToolButton::clicked, this, &MissingBar::findFolderWanted);
    connect(search_, &QToolButton::clicked, this, [this] {
        if (searching_)
            Q_EMIT stopWanted();
        else
            Q_EMIT searchWanted();
    });
    connect(hide, &QToolButton::clicked, this, &QWidget::hide);
    setSearching(false);
    setVisible(false);
}

void MissingBar::setMissing(const QString& text) {
    text_->setText(text);
    setVisible(!text.isEmpty());
}

void MissingBar::setSearching(bool searching) {
    searching_ = searching;
    search_->setText(searching ? tr("Stop searching") : tr("Search again"));
    search_->setToolTip(searching ? tr("Stop looking for the file")
                                  : tr("Look beside the project, above it and in the folders of recent files"));
}

QString MissingBar::text() const { return text_->text(); }

} // namespace limner
