#pragma once

#include "core/project/sample_figures.h"

#include <QStringList>
#include <QWidget>

#include <vector>

class QListWidget;
class QVBoxLayout;

namespace limner {

/// What stands where the picture will be while nothing is open: what can be done.
class WelcomePage : public QWidget {
    Q_OBJECT

  public:
    explicit WelcomePage(QWidget* parent = nullptr);
    void setRecent(const QStringList& paths);
    /// Figures that come with Limner and whose scans are on this machine; none hides the list.
    void setFigures(const std::vector<SampleFigure>& figures);
    [[nodiscard]] QListWidget* figures() const { return figures_; }

  Q_SIGNALS:
    void openWanted();
    void openFolderWanted();
    void sampleWanted();
    void recentWanted(const QString& path);
    void figureWanted(const QString& id);

  private:
    void buildLists(QVBoxLayout* column);

    QVBoxLayout* recent_;
    QWidget* recentBox_;
    QListWidget* figures_;
    QWidget* figuresBox_;
};

} // namespace limner
