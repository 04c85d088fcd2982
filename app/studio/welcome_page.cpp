#include "app/studio/welcome_page.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace limner {
namespace {

QLabel* wrapped(const QString& text) {
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    return label;
}

} // namespace

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent), recent_(new QVBoxLayout), recentBox_(new QWidget) {
    constexpr int kColumn = 480;
    auto* column = new QWidget;
    column->setFixedWidth(kColumn);
    auto* layout = new QVBoxLayout(column);
    layout->setSpacing(10);

    auto* title = new QLabel(tr("Limner"));
    QFont large = font();
    large.setPointSizeF(font().pointSizeF() * 2.4);
    large.setWeight(QFont::DemiBold);
    title->setFont(large);
    layout->addWidget(title);
    layout->addWidget(wrapped(tr("From a CT or MR scan to a print-ready illustration.")));
    layout->addSpacing(10);

    auto* open = new QPushButton(tr("Open a scan or project…"));
    open->setDefault(true);
    open->setMinimumHeight(38);
    auto* folder = new QPushButton(tr("Open a folder of slices…"));
    auto* sample = new QPushButton(tr("Try the sample head"));
    sample->setToolTip(tr("A built-in head with skin, skull and vessels; nothing is downloaded"));
    auto* row = new QHBoxLayout;
    row->setSpacing(10);
    row->addWidget(folder);
    row->addWidget(sample);
    layout->addWidget(open);
    layout->addLayout(row);
    layout->addSpacing(4);
    auto* formats = wrapped(tr("Or drop it here: a DICOM folder or file, NIfTI, NRRD, MetaImage, VTK, TIFF or PNG "
                               "stacks, InVesalius, or a .limner project."));
    formats->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(formats);

    auto* recentLayout = new QVBoxLayout(recentBox_);
    recentLayout->setContentsMargins(0, 12, 0, 0);
    recentLayout->setSpacing(2);
    auto* heading = new QLabel(tr("Recent"));
    QFont bold = font();
    bold.setBold(true);
    heading->setFont(bold);
    recentLayout->addWidget(heading);
    recentLayout->addLayout(recent_);
    layout->addWidget(recentBox_);
    recentBox_->setVisible(false);

    auto* centre = new QHBoxLayout(this);
    centre->addStretch(1);
    centre->addWidget(column, 0, Qt::AlignVCenter);
    centre->addStretch(1);
    connect(open, &QPushButton::clicked, this, &WelcomePage::openWanted);
    connect(folder, &QPushButton::clicked, this, &WelcomePage::openFolderWanted);
    connect(sample, &QPushButton::clicked, this, &WelcomePage::sampleWanted);
}

void WelcomePage::setRecent(const QStringList& paths) {
    while (QLayoutItem* item = recent_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const QString& path : paths) {
        auto* button = new QPushButton(QFileInfo(path).fileName());
        button->setFlat(true);
        button->setStyleSheet(QStringLiteral("text-align: left; padding: 3px 6px;"));
        button->setToolTip(path);
        button->setCursor(Qt::PointingHandCursor);
        connect(button, &QPushButton::clicked, this, [this, path] { Q_EMIT recentWanted(path); });
        recent_->addWidget(button);
    }
    recentBox_->setVisible(!paths.isEmpty());
}

} // namespace limner
