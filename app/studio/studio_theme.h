#pragma once

#include <QString>

class QApplication;

namespace limner {

/// Colours of the window: neutral greys (pictures are judged in it), the same on every desktop.
enum class StudioTheme { light, dark };

/// Dresses the application; may be called again at any time.
void applyStudioTheme(QApplication& application, StudioTheme theme = StudioTheme::light);
/// The one that the user chose last; light at first.
StudioTheme chosenStudioTheme();
void chooseStudioTheme(StudioTheme theme);

} // namespace limner
