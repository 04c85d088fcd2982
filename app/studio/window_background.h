#pragma once

#include "app/studio/workplace.h"

#include <QObject>

#include <filesystem>

class QColor;

namespace limner {

/// What lies behind the figure: a plain paper or a picture.
class WindowBackground : public QObject {
    Q_OBJECT

  public:
    explicit WindowBackground(const Workplace& place);
    /// A plain paper; takes a background picture away.
    void usePaper(const QColor& colour);
    /// Lays the figure over a picture, read by a job; the paper shows where that is clear.
    void usePicture(const std::filesystem::path& path);
    [[nodiscard]] bool busy() const { return !job_.isNull(); }

  private:
    void choosePaper();
    void choosePicture();

    Workplace place_;
    QPointer<Job> job_;
};

} // namespace limner
