#pragma once

#include "core/figure/themes.h"

#include <QMenu>

namespace limner {

/// The themes it is given; says which was chosen.
class ThemeMenu : public QMenu {
    Q_OBJECT

  public:
    explicit ThemeMenu(QWidget* parent = nullptr);
    void setThemes(const std::vector<ThemeCard>& themes);

  Q_SIGNALS:
    void chosen(const QString& id, const QString& name);
};

} // namespace limner
