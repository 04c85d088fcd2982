#pragma once

#include "app/studio/export_dialog.h"
#include "app/studio/workplace.h"

#include <QObject>

#include <filesystem>
#include <functional>

namespace limner {

class ExportQueue;
class OutputList;

/// Writes pictures while work goes on: the export dialog, the line of exports, and their panel.
class WindowExport : public QObject {
    Q_OBJECT

  public:
    explicit WindowExport(const Workplace& place);

    /// Puts an export of the figure as it is into the line; its size becomes the figure's, and is saved with it.
    void exportPath(const std::filesystem::path& path, const ExportDialog::Choice& choice);
    [[nodiscard]] ExportQueue& queue() { return *queue_; }
    [[nodiscard]] OutputList& list() { return *list_; }
    [[nodiscard]] bool busy() const;
    /// Whether the window may be closed though pictures are being written; replaced by tests.
    std::function<bool()> askAboutLeaving;

  Q_SIGNALS:
    void pictureExported(const QString& path);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void chooseAndExport();
    void showRows();
    /// Measured on the screen at one ray per pixel; 0: not known.
    [[nodiscard]] double secondsPerMegaPixel() const;

    Workplace place_;
    ExportQueue* queue_;
    OutputList* list_;
    QDockWidget* panel_;
    bool leaving_ = false; ///< the user wants to, whatever is being written
};

} // namespace limner
