#pragma once

#include "app/studio/workplace.h"

#include <QByteArray>
#include <QObject>

class QMenu;

namespace limner {

class CommandPalette;
enum class StudioTheme;

/// How the window is arranged and dressed: layouts of its panels, its colours and language, all its commands by name,
/// and their keys. What the user chooses is kept in the program's settings, never in a figure.
class WindowWorkspace : public QObject {
    Q_OBJECT

  public:
    explicit WindowWorkspace(const Workplace& place);

    /// The window as it was left last, and keeping it as it is now: the program's start and end.
    void restoreLast();
    void keepLast() const;
    void saveLayout(const QString& name);
    void useLayout(const QString& name);
    void removeLayout(const QString& name);
    [[nodiscard]] static QStringList layouts();
    /// The panels as the program comes.
    void useStandardLayout();
    void useTheme(StudioTheme theme);
    CommandPalette* showCommands(); ///< over the window; deletes itself
    void showShortcuts();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void buildThemes();
    void buildLanguages();
    void buildBackends();
    void showLayouts();
    void askForLayoutName();
    void showOnlyPicture(bool only);

    Workplace place_;
    QMenu* layouts_;
    QByteArray standard_; ///< state of the window at its first showing
    QByteArray before_;   ///< only the picture is seen: what was seen before
};

} // namespace limner
