#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

#include <memory>

namespace limner {

class PictureFeed;
struct Figure;

/// A small live picture of a figure, drawn by a feed of its own.
class FigurePreview : public QWidget {
    Q_OBJECT

  public:
    /// Takes the feed.
    explicit FigurePreview(PictureFeed* feed, QWidget* parent = nullptr);

    /// Null shows the words instead. `draftsOnly`: while a gesture goes on.
    void setFigure(std::shared_ptr<const Figure> figure, bool draftsOnly);
    void setWords(const QString& whileEmpty);
    [[nodiscard]] const QImage& picture() const { return picture_; }
    /// Whether the shown picture is of the newest figure.
    [[nodiscard]] bool upToDate() const { return upToDate_; }

    [[nodiscard]] QSize sizeHint() const override { return {200, 200}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {100, 100}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void want();

    PictureFeed* feed_;
    std::shared_ptr<const Figure> figure_;
    bool draftsOnly_ = false;
    bool upToDate_ = false;
    QImage picture_;
    QString words_;
};

} // namespace limner
