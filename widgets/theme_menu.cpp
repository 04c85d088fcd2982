#include "widgets/theme_menu.h"

#include "widgets/core_words.h"

namespace limner {

ThemeMenu::ThemeMenu(QWidget* parent) : QMenu(tr("&Theme"), parent) { setToolTipsVisible(true); }

void ThemeMenu::setThemes(const std::vector<ThemeCard>& themes) {
    clear();
    for (const ThemeCard& card : themes) {
        const QString id = QString::fromStdString(card.id);
        const QString name = coreWord(card.name);
        QAction* action = addAction(name);
        action->setObjectName("theme." + id);
        action->setToolTip(coreWord(card.help));
        action->setStatusTip(action->toolTip());
        connect(action, &QAction::triggered, this, [this, id, name] { Q_EMIT chosen(id, name); });
    }
}

} // namespace limner
