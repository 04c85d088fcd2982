#pragma once

#include <QStringList>
#include <QWidget>

class QVBoxLayout;

namespace limner {

/// What stands where the picture will be while nothing is open: what can be done.
class WelcomePage : public QWidget {
    Q_OBJECT

  public:
    explicit WelcomePage(QWidget* parent = nullptr);
    void setRecent(const QStringList& paths);

  Q_SIGNALS:
    void openWanted();
    void openFolderWanted();
    void sampleWanted();
    void recentWanted(const QString& path);

  private:
    QVBoxLayout* recent_;
    QWidget* recentBox_;
};

} // namespace limner
