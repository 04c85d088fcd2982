#include "app/studio/main_window.h"

#include "app/studio/extraction_dialog.h"
#include "app/studio/window_gallery.h"
#include "widgets/figure_preview.h"
#include "widgets/layer_list.h"
#include "widgets/layer_panel.h"
#include "widgets/picture_feed.h"
#include "widgets/transfer_editor_1d.h"

/// The window's dialog that takes styles from artwork: it follows the figure and what is chosen in it.

namespace limner {

ExtractionDialog* MainWindow::extraction() const { return extraction_; }

void MainWindow::extractStyle() {
    if (!extraction_) {
        auto* preview = new FigurePreview(new PictureFeed(engine_.plan, engine_.makeBackend()));
        extraction_ = new ExtractionDialog(preview, StyleLibrary(StyleLibrary::userFolder()), this);
        extraction_->setAttribute(Qt::WA_DeleteOnClose);
        const auto follow = [this] {
            extraction_->setFigure(document_->figure(), layers_->selectedLayer(), transfer_->selectedNode());
        };
        connect(document_, &StudioDocument::changed, extraction_.data(), follow);
        connect(layerPanel_, &LayerPanel::layerSelected, extraction_.data(), follow);
        connect(transfer_, &TransferEditor1d::selectionChanged, extraction_.data(), follow);
        connect(extraction_.data(), &ExtractionDialog::edited, this,
                [this](const Edit& edit) { document_->apply(edit); });
        connect(extraction_.data(), &ExtractionDialog::styleAdded, &styles_->shelf(), &StyleShelf::takeIn);
        follow();
    }
    extraction_->show();
    extraction_->raise();
    extraction_->activateWindow();
}

} // namespace limner
