#pragma once

#include <QListWidget>

namespace limner {

/// The rows of the layer list: a check mark, a picture, a name, and at the right end two switches, solo and lock. Rows
/// are dragged to another place; the list itself changes nothing, it says what is wanted.
class LayerRows : public QListWidget {
    Q_OBJECT

  public:
    static constexpr int kSoloRole = Qt::UserRole;
    static constexpr int kLockRole = Qt::UserRole + 1;
    static constexpr const char* kMime = "application/x-limner-layer"; ///< a row's number in decimal

    explicit LayerRows(QWidget* parent = nullptr);

    /// Where a row's switches are, in the viewport's coordinates.
    [[nodiscard]] QRect soloRect(int row) const;
    [[nodiscard]] QRect lockRect(int row) const;

  Q_SIGNALS:
    void soloClicked(int row);
    void lockClicked(int row);
    void moveWanted(int from, int to);

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void startDrag(Qt::DropActions actions) override;
    void dropEvent(QDropEvent* event) override;
    [[nodiscard]] QStringList mimeTypes() const override { return {kMime}; }
    [[nodiscard]] QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
    [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    bool viewportEvent(QEvent* event) override;

  private:
    /// Whether a press on a row's switches was taken.
    bool pressSwitch(const QPoint& position);
};

} // namespace limner
