#include "app/studio/studio_theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace limner {

void applyStudioTheme(QApplication& application) {
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    const QColor window(0xec, 0xed, 0xef);
    const QColor ink(0x20, 0x22, 0x26);
    const QColor accent(0x2b, 0x6c, 0xb0);
    QPalette palette;
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::WindowText, ink);
    palette.setColor(QPalette::Base, QColor(0xfc, 0xfc, 0xfd));
    palette.setColor(QPalette::AlternateBase, QColor(0xf3, 0xf4, 0xf6));
    palette.setColor(QPalette::Text, ink);
    palette.setColor(QPalette::Button, QColor(0xf4, 0xf5, 0xf6));
    palette.setColor(QPalette::ButtonText, ink);
    palette.setColor(QPalette::Mid, QColor(0xb4, 0xb7, 0xbc));
    palette.setColor(QPalette::Dark, QColor(0x8c, 0x90, 0x96));
    palette.setColor(QPalette::Highlight, accent);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, accent);
    palette.setColor(QPalette::PlaceholderText, QColor(0x5c, 0x62, 0x6b)); // 5:1 on the window's grey
    palette.setColor(QPalette::ToolTipBase, QColor(0x2a, 0x2d, 0x33));
    palette.setColor(QPalette::ToolTipText, QColor(0xf2, 0xf3, 0xf5));
    for (const auto role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(0x8a, 0x8e, 0x95));
    QApplication::setPalette(palette);
    application.setStyleSheet(
        QStringLiteral("QDockWidget::title { padding: 6px 8px; background: #dfe1e4; font-weight: 600; }"
                       "QDockWidget { font-weight: 600; }"
                       "QDockWidget > QWidget { font-weight: normal; }"
                       "QMainWindow::separator { width: 5px; height: 5px; background: #d5d7db; }"
                       "QMainWindow::separator:hover { background: #9db8d6; }"
                       "QToolBar { spacing: 2px; padding: 3px 6px; border: 0; border-bottom: 1px solid #c9ccd1; }"
                       "QToolBar QToolButton { padding: 4px 8px; }"
                       "QStatusBar { border-top: 1px solid #c9ccd1; }"
                       "QStatusBar::item { border: 0; }"));
}

} // namespace limner
