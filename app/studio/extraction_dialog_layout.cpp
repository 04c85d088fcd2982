// How the extraction dialog is laid out.
#include "app/studio/extraction_dialog.h"

#include "widgets/artwork_canvas.h"
#include "widgets/artwork_tool_bar.h"
#include "widgets/extraction_form.h"
#include "widgets/figure_preview.h"
#include "widgets/form_parts.h"
#include "widgets/job.h"
#include "widgets/notice_bar.h"
#include "widgets/progress_strip.h"
#include "widgets/style_card_form.h"

#include <QAction>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace limner {
namespace {

constexpr QSize kFirstSize(1340, 860);
constexpr int kFormWidth = 496;

QFrame* rule() {
    auto* line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Plain);
    line->setForegroundRole(QPalette::Mid);
    return line;
}

/// A sheet with a dashed border, as places to drop something have.
class DropPage : public QWidget {
  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QPen dashes(palette().color(QPalette::Mid), 1.5);
        dashes.setDashPattern({5, 4});
        painter.setPen(dashes);
        painter.setBrush(palette().color(QPalette::AlternateBase));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8, 8);
    }
};

QToolButton* buttonOf(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    return button;
}

} // namespace

void ExtractionDialog::build() {
    setObjectName("extraction");
    setWindowTitle(tr("Style from artwork"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    setAcceptDrops(true);
    notices_ = new NoticeBar;
    pages_ = new QStackedWidget;
    canvas_ = new ArtworkCanvas;
    tools_ = new ArtworkToolBar;
    options_ = new ArtworkToolOptions;
    form_ = new ExtractionForm;
    card_ = new StyleCardForm;
    progress_ = new ProgressStrip;
    zoom_ = new QLabel;
    buildActions();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 12);
    layout->setSpacing(8);
    layout->addWidget(buildHead());
    layout->addWidget(buildMiddle(), 1);
    layout->addWidget(rule());
    layout->addWidget(card_);
    connect(work_, &ExtractionWork::started, progress_, &ProgressStrip::follow);
    resize(kFirstSize);
}

void ExtractionDialog::buildActions() {
    const auto make = [this](const QString& text, const QString& tip, const QKeySequence& keys) {
        auto* action = new QAction(text, this);
        action->setShortcut(keys);
        action->setToolTip(keys.isEmpty() ? tip : tr("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
        addAction(action);
        return action;
    };
    undo_ = make(tr("Undo"), tr("Take back the last change"), QKeySequence("Ctrl+Z"));
    redo_ = make(tr("Redo"), tr("Repeat what was taken back"), QKeySequence("Ctrl+Shift+Z"));
    open_ =
        make(tr("Open artwork…"), tr("Open a scanned artwork; it can be dropped here, too"), QKeySequence("Ctrl+O"));
    paste_ = make(tr("Paste"), tr("Take the picture on the clipboard as the artwork"), QKeySequence("Ctrl+V"));
    fit_ = make(tr("Fit"), tr("Show the whole artwork"), QKeySequence("Ctrl+0"));
    pixels_ = make(tr("100 %"), tr("Show one pixel of the artwork as one of the screen"), QKeySequence("Ctrl+1"));
    const auto step = [this](bool (DraftHistory::*way)()) {
        ongoing_ = false;
        if ((history_.*way)())
            showDraft();
    };
    connect(undo_, &QAction::triggered, this, [step] { step(&DraftHistory::undo); });
    connect(redo_, &QAction::triggered, this, [step] { step(&DraftHistory::redo); });
    connect(open_, &QAction::triggered, this, &ExtractionDialog::chooseArtwork);
    connect(paste_, &QAction::triggered, this, &ExtractionDialog::paste);
    connect(fit_, &QAction::triggered, canvas_, &ArtworkCanvas::fit);
    connect(pixels_, &QAction::triggered, canvas_, &ArtworkCanvas::showPixels);
}

QWidget* ExtractionDialog::buildHead() {
    auto* head = new QWidget;
    auto* line = new QHBoxLayout(head);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(6);
    constexpr int kGap = 14;
    for (QAction* action : {open_, paste_})
        line->addWidget(buttonOf(action));
    line->addSpacing(kGap);
    for (QAction* action : {undo_, redo_})
        line->addWidget(buttonOf(action));
    line->addSpacing(kGap);
    line->addWidget(options_);
    line->addStretch(1);
    constexpr int kZoomWidth = 52; // "4000 %"
    zoom_->setMinimumWidth(kZoomWidth);
    zoom_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    zoom_->setAccessibleName(tr("Zoom"));
    line->addWidget(zoom_);
    for (QAction* action : {fit_, pixels_})
        line->addWidget(buttonOf(action));
    return head;
}

QWidget* ExtractionDialog::buildEmptyPage() {
    auto* page = new DropPage;
    auto* words =
        new QLabel(tr("<b>Take styles from an artwork</b><br>Open a scanned plate or a painting, drop the file "
                      "here, or paste a picture."));
    words->setAlignment(Qt::AlignCenter);
    auto* button = new QPushButton(tr("Open artwork…"));
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, open_, &QAction::trigger);
    auto* layout = new QVBoxLayout(page);
    layout->addStretch(1);
    layout->addWidget(words);
    layout->addSpacing(8);
    layout->addWidget(button, 0, Qt::AlignHCenter);
    layout->addStretch(1);
    return page;
}

QWidget* ExtractionDialog::buildMiddle() {
    pages_->addWidget(buildEmptyPage());
    pages_->addWidget(canvas_);
    auto* art = new QWidget;
    auto* stack = new QGridLayout(art);
    stack->setContentsMargins(0, 0, 0, 0);
    stack->addWidget(pages_, 0, 0);
    // Over the artwork, which must not move under the hand.
    stack->addWidget(notices_, 0, 0, Qt::AlignTop);
    stack->addWidget(progress_, 0, 0, Qt::AlignBottom | Qt::AlignRight);
    progress_->setAutoFillBackground(true);
    auto* previewHead = new QLabel(tr("On the figure"));
    form_->pictures()->addWidget(previewHead, 0, 1);
    form_->pictures()->addWidget(preview_, 1, 1);
    form_->pictures()->setColumnStretch(0, 6);
    form_->pictures()->setColumnStretch(1, 5);
    auto* panel = scrolling(form_);
    panel->setFixedWidth(kFormWidth);
    auto* middle = new QWidget;
    auto* line = new QHBoxLayout(middle);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(10);
    line->addWidget(tools_);
    line->addWidget(art, 1);
    line->addWidget(panel);
    return middle;
}

} // namespace limner
