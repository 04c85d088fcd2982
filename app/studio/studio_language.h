#pragma once

#include <QString>

#include <span>

class QApplication;

namespace limner {

/// A language that the window can speak.
struct StudioLanguage {
    const char* code; ///< "de"; empty: the desktop's
    QString name;     ///< in that language
};

std::span<const StudioLanguage> studioLanguages();
/// The user's choice; empty: the desktop's language.
QString chosenStudioLanguage();
void chooseStudioLanguage(const QString& code);
/// Loads the translations of the chosen language (and Qt's own of its standard buttons); English where there are none.
/// Before the first window is made.
void applyStudioLanguage(QApplication& application);

} // namespace limner
