#pragma once

#include <QAbstractButton>
#include <QAccessible>
#include <QWidget>

#include <string>
#include <vector>

namespace limner::testing {

/// What can have the keyboard and has no name that a screen reader could say: class and object name of each, hidden
/// ones too. Parts of Qt's own controls are left out.
inline std::vector<std::string> namelessControls(const QWidget& root) {
    std::vector<std::string> nameless;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        const QWidget* parent = widget->parentWidget();
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const bool later = button && button->text().isEmpty() && button->isHidden(); // is given its words when shown
        const bool inner = widget->objectName().startsWith("qt_") || widget->inherits("QScrollArea") ||
                           widget->inherits("QComboBoxListView") || later ||
                           (parent && parent->inherits("QAbstractSpinBox")) ||
                           (parent && parent->inherits("QMainWindow") && widget->inherits("QTabBar"));
        if (widget->focusPolicy() == Qt::NoFocus || inner)
            continue;
        const QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(widget);
        if (!spoken || spoken->text(QAccessible::Name).isEmpty())
            nameless.push_back(
                std::string(widget->metaObject()->className()) + " \"" + widget->objectName().toStdString() + "\" in " +
                (parent ? parent->metaObject()->className() : "nothing") + ", " + widget->toolTip().toStdString());
    }
    return nameless;
}

} // namespace limner::testing
