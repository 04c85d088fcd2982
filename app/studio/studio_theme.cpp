#include "app/studio/studio_theme.h"

#include <QApplication>
#include <QPalette>
#include <QSettings>
#include <QStyleFactory>

namespace limner {
namespace {

constexpr auto kSetting = "window/theme";

/// The colours that a theme is made of. Text on `window` and `base` has a contrast of at least 4.5:1 in both.
struct Colours {
    QRgb window, base, alternate, button, ink, faint, disabled, mid, dark, accent, link, tip, tipText, title;
};

constexpr Colours kLight{0xffecedef, 0xfffcfcfd, 0xfff3f4f6, 0xfff4f5f6, 0xff202226, 0xff5c626b, 0xff8a8e95,
                         0xffb4b7bc, 0xff8c9096, 0xff2b6cb0, 0xff2b6cb0, 0xff2a2d33, 0xfff2f3f5, 0xffdfe1e4};
constexpr Colours kDark{0xff2b2d31, 0xff1f2124, 0xff26282c, 0xff393c41, 0xffe3e5e8, 0xffa4a9b0, 0xff7b8087,
                        0xff4a4e55, 0xff15171a, 0xff3d7fc4, 0xff7db4ec, 0xff45494f, 0xfff2f3f5, 0xff35383d};

QPalette paletteOf(const Colours& c) {
    QPalette palette;
    const std::pair<QPalette::ColorRole, QRgb> roles[] = {{QPalette::Window, c.window},
                                                          {QPalette::WindowText, c.ink},
                                                          {QPalette::Base, c.base},
                                                          {QPalette::AlternateBase, c.alternate},
                                                          {QPalette::Text, c.ink},
                                                          {QPalette::Button, c.button},
                                                          {QPalette::ButtonText, c.ink},
                                                          {QPalette::Mid, c.mid},
                                                          {QPalette::Midlight, c.title},
                                                          {QPalette::Dark, c.dark},
                                                          {QPalette::Highlight, c.accent},
                                                          {QPalette::Link, c.link},
                                                          {QPalette::PlaceholderText, c.faint},
                                                          {QPalette::ToolTipBase, c.tip},
                                                          {QPalette::ToolTipText, c.tipText},
                                                          {QPalette::HighlightedText, 0xffffffff},
                                                          {QPalette::BrightText, 0xffffffff}};
    for (const auto& [role, colour] : roles)
        palette.setColor(role, QColor(colour));
    for (const auto role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(c.disabled));
    return palette;
}

/// In the palette's words, so that it is the same for both.
constexpr auto kSheet = "QDockWidget::title { padding: 6px 8px; background: palette(midlight); font-weight: 600; }"
                        "QDockWidget { font-weight: 600; }"
                        "QDockWidget > QWidget { font-weight: normal; }"
                        "QMainWindow::separator { width: 5px; height: 5px; background: palette(midlight); }"
                        "QMainWindow::separator:hover { background: palette(highlight); }"
                        "QToolBar { spacing: 2px; padding: 3px 6px; border: 0; border-bottom: 1px solid palette(mid); }"
                        "QToolBar QToolButton { padding: 4px 8px; }"
                        "QMainWindow > QTabBar { font-size: 9pt; }" // the panels' names stand in full
                        "QStatusBar { border-top: 1px solid palette(mid); }"
                        "QStatusBar::item { border: 0; }";

} // namespace

void applyStudioTheme(QApplication& application, StudioTheme theme) {
    const Colours& colours = theme == StudioTheme::dark ? kDark : kLight;
    QApplication::setPalette(paletteOf(colours));
    if (application.styleSheet() != kSheet)
        QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    application.setStyleSheet(kSheet); // also again: it dresses every widget in the new palette
}

StudioTheme chosenStudioTheme() {
    return QSettings().value(kSetting).toString() == "dark" ? StudioTheme::dark : StudioTheme::light;
}

void chooseStudioTheme(StudioTheme theme) {
    QSettings().setValue(kSetting, theme == StudioTheme::dark ? "dark" : "light");
}

} // namespace limner
