#pragma once

class QApplication;

namespace limner {

/// The program's own look: light, neutral greys (colours are judged here), the same on every desktop.
void applyStudioTheme(QApplication& application);

} // namespace limner
