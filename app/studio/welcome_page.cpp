#include "app/studio/welcome_page.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
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

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent), recent_(new QVBoxLayout), recentBox_(new QWidget), figures_(new QListWidget),
      figuresBox_(new QWidget) {
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

    buildLists(layout);
    auto* centre = new QHBoxLayout(this);
    centre->addStretch(1);
    centre->addWidget(column, 0, Qt::AlignVCenter);
    centre->addStretch(1);
    connect(open, &QPushButton::clicked, this, &WelcomePage::openWanted);
    connect(folder, &QPushButton::clicked, this, &WelcomePage::openFolderWanted);
    connect(sample, &QPushButton::clicked, this, &WelcomePage::sampleWanted);
}

void WelcomePage::buildLists(QVBoxLayout* column) {
    constexpr int kFiguresHeight = 132; // six rows; more scroll
    const auto section = [&](QWidget* box, const QString& title) {
        auto* layout = new QVBoxLayout(box);
        layout->setContentsMargins(0, 12, 0, 0);
        layout->setSpacing(2);
        auto* heading = new QLabel(title);
        QFont bold = font();
        bold.setBold(true);
        heading->setFont(bold);
        layout->addWidget(heading);
        column->addWidget(box);
        box->setVisible(false);
        return layout;
    };
    section(recentBox_, tr("Recent"))->addLayout(recent_);
    section(figuresBox_, tr("Sample figures"))->addWidget(figures_);
    figures_->setFixedHeight(kFiguresHeight);
    figures_->setFrameShape(QFrame::NoFrame);
    figures_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // long titles end in dots, the tip has them whole
    figures_->setAccessibleName(tr("Sample figures"));
    figures_->setToolTip(
        tr("Figures that come with Limner, on the head CT of this machine; Enter or a double click opens"));
    connect(figures_, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { Q_EMIT figureWanted(item->data(Qt::UserRole).toString()); });
}

void WelcomePage::setFigures(const std::vector<SampleFigure>& figures) {
    figures_->clear();
    for (const SampleFigure& figure : figures) {
        auto* item = new QListWidgetItem(QString::fromStdString(figure.title), figures_);
        item->setData(Qt::UserRole, QString::fromStdString(figure.id));
        item->setToolTip(item->text());
    }
    figuresBox_->setVisible(!figures.empty());
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
