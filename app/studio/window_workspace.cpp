#include "app/studio/window_workspace.h"

#include "app/studio/action_table.h"
#include "app/studio/shortcuts_dialog.h"
#include "app/studio/studio_backend.h"
#include "app/studio/studio_language.h"
#include "app/studio/studio_theme.h"
#include "widgets/command_palette.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

namespace limner {
namespace {

constexpr int kLayoutVersion = 1; // a later arrangement of panels is not filled with an older one
constexpr auto kLayoutGroup = "layouts";
constexpr auto kLast = "window/state";
constexpr auto kLastPlace = "window/geometry";

/// All commands that the menus show, with the menu's name; separators and menus inside menus are gone through.
void collect(const QMenu& menu, const QString& where, std::vector<CommandPalette::Command>& commands) {
    for (QAction* action : menu.actions()) {
        if (action->isSeparator() || action->text().isEmpty())
            continue;
        if (const QMenu* inner = action->menu())
            collect(*inner, plainText(*action), commands);
        else
            commands.push_back({where, action});
    }
}

} // namespace

WindowWorkspace::WindowWorkspace(const Workplace& place)
    : QObject(place.window), place_(place), layouts_(new QMenu(place.window)) {
    const auto on = [this](const char* id, auto handler) {
        connect(place_.actions->at(id), &QAction::triggered, this, handler);
    };
    on("window.commands", [this] { showCommands(); });
    on("window.shortcuts", [this] { showShortcuts(); });
    QAction* only = place_.actions->at("window.only-picture");
    only->setCheckable(true);
    on("window.only-picture", [this](bool hide) { showOnlyPicture(hide); });
    QAction* full = place_.actions->at("window.full-screen");
    full->setCheckable(true);
    on("window.full-screen", [this](bool fill) {
        place_.window->setWindowState(place_.window->windowState().setFlag(Qt::WindowFullScreen, fill));
    });
    place_.actions->at("window.layouts")->setMenu(layouts_);
    buildThemes();
    buildLanguages();
    buildBackends();
    showLayouts();
    place_.window->installEventFilter(this);
}

bool WindowWorkspace::eventFilter(QObject* watched, QEvent* event) {
    if (watched == place_.window && event->type() == QEvent::Show && standard_.isEmpty())
        standard_ = place_.window->saveState(kLayoutVersion);
    if (watched == place_.window && event->type() == QEvent::WindowStateChange)
        place_.actions->at("window.full-screen")->setChecked(place_.window->isFullScreen());
    return QObject::eventFilter(watched, event);
}

void WindowWorkspace::restoreLast() {
    if (standard_.isEmpty())
        standard_ = place_.window->saveState(kLayoutVersion);
    const QSettings settings;
    place_.window->restoreGeometry(settings.value(kLastPlace).toByteArray());
    place_.window->restoreState(settings.value(kLast).toByteArray(), kLayoutVersion);
}

void WindowWorkspace::keepLast() const {
    QSettings settings;
    settings.setValue(kLastPlace, place_.window->saveGeometry());
    settings.setValue(kLast, before_.isEmpty() ? place_.window->saveState(kLayoutVersion) : before_);
}

QStringList WindowWorkspace::layouts() {
    QSettings settings;
    settings.beginGroup(kLayoutGroup);
    return settings.childKeys();
}

void WindowWorkspace::saveLayout(const QString& name) {
    QSettings settings;
    settings.beginGroup(kLayoutGroup);
    settings.setValue(QString(name).replace('/', u'∕'), place_.window->saveState(kLayoutVersion)); // '/' makes groups
    settings.endGroup();
    showLayouts();
}

void WindowWorkspace::useLayout(const QString& name) {
    const QByteArray state = QSettings().value(QString(kLayoutGroup) + "/" + name).toByteArray();
    if (!place_.window->restoreState(state, kLayoutVersion))
        place_.tell(tr("The layout “%1” is of another version of the program").arg(name));
    before_.clear();
    place_.actions->at("window.only-picture")->setChecked(false);
}

void WindowWorkspace::removeLayout(const QString& name) {
    QSettings().remove(QString(kLayoutGroup) + "/" + name);
    showLayouts();
}

void WindowWorkspace::useStandardLayout() {
    place_.window->restoreState(standard_, kLayoutVersion);
    before_.clear();
    place_.actions->at("window.only-picture")->setChecked(false);
}

void WindowWorkspace::showLayouts() {
    layouts_->clear();
    const QStringList names = layouts();
    for (const QString& name : names)
        layouts_->addAction(name, this, [this, name] { useLayout(name); });
    layouts_->addSeparator();
    layouts_->addAction(tr("&Standard"), this, &WindowWorkspace::useStandardLayout);
    layouts_->addAction(tr("&Keep this layout…"), this, &WindowWorkspace::askForLayoutName);
    QMenu* remove = layouts_->addMenu(tr("&Remove"));
    remove->setEnabled(!names.isEmpty());
    for (const QString& name : names)
        remove->addAction(name, this, [this, name] { removeLayout(name); });
}

void WindowWorkspace::askForLayoutName() {
    const QString name = QInputDialog::getText(place_.window, tr("Keep this layout"), tr("Name of the layout"));
    if (!name.trimmed().isEmpty())
        saveLayout(name.trimmed());
}

void WindowWorkspace::buildThemes() {
    auto* menu = new QMenu(place_.window);
    auto* group = new QActionGroup(this);
    for (const auto& [theme, text] : {std::pair{StudioTheme::light, tr("&Light")}, {StudioTheme::dark, tr("&Dark")}}) {
        QAction* action = menu->addAction(text, this, [this, theme = theme] { useTheme(theme); });
        action->setObjectName(theme == StudioTheme::dark ? "theme.dark" : "theme.light");
        action->setCheckable(true);
        action->setChecked(theme == chosenStudioTheme());
        group->addAction(action);
    }
    place_.actions->at("window.theme")->setMenu(menu);
}

void WindowWorkspace::useTheme(StudioTheme theme) {
    chooseStudioTheme(theme);
    applyStudioTheme(*qApp, theme);
}

void WindowWorkspace::buildLanguages() {
    auto* menu = new QMenu(place_.window);
    auto* group = new QActionGroup(this);
    for (const StudioLanguage& language : studioLanguages()) {
        const QString code = language.code;
        QAction* action = menu->addAction(language.name, this, [this, code] {
            chooseStudioLanguage(code);
            place_.tell(tr("The language changes when Limner is started again"));
        });
        action->setCheckable(true);
        action->setChecked(code == chosenStudioLanguage());
        group->addAction(action);
    }
    place_.actions->at("window.language")->setMenu(menu);
}

void WindowWorkspace::buildBackends() {
    auto* menu = new QMenu(place_.window);
    auto* group = new QActionGroup(this);
    for (const StudioBackend& backend : studioBackends()) {
        const QString code = backend.code;
        QAction* action = menu->addAction(backend.name, this, [this, code] {
            chooseStudioBackend(code);
            place_.tell(tr("What draws changes when Limner is started again; now: %1").arg(studioBackendInForce()));
        });
        action->setCheckable(true);
        action->setChecked(code == chosenStudioBackend());
        group->addAction(action);
    }
    place_.actions->at("window.backend")->setMenu(menu);
}

void WindowWorkspace::showOnlyPicture(bool only) {
    if (only) {
        before_ = place_.window->saveState(kLayoutVersion);
        for (QDockWidget* panel : place_.window->findChildren<QDockWidget*>())
            panel->hide();
    } else if (!before_.isEmpty()) {
        place_.window->restoreState(before_, kLayoutVersion);
        before_.clear();
    }
}

CommandPalette* WindowWorkspace::showCommands() {
    std::vector<CommandPalette::Command> commands;
    for (const QAction* action : place_.window->menuBar()->actions())
        if (const QMenu* menu = action->menu())
            collect(*menu, plainText(*action), commands);
    auto* palette = new CommandPalette(std::move(commands), place_.window);
    const QPoint top = place_.window->mapToGlobal(QPoint(place_.window->width() / 2, 0));
    constexpr int kUnderTheMenus = 80;
    palette->move(top + QPoint(-palette->width() / 2, kUnderTheMenus));
    palette->show();
    return palette;
}

void WindowWorkspace::showShortcuts() {
    auto* dialog = new ShortcutsDialog(place_.actions, place_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

} // namespace limner
