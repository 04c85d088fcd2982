#pragma once

#include <QString>

#include <string>

namespace limner {

/// A word or sentence that the core has in English for people (labels and help of settings, names and help of presets
/// and themes) in the window's language; as it is where there is no translation. The list of them all, for translators,
/// is resources/translations/core_words.h, which a test keeps complete.
QString coreWord(const std::string& english);

/// The name of a setting as it stands inside a sentence ("Change opacity"): small in English, with its capital in
/// languages that write nouns with one.
QString inSentence(const QString& name);

} // namespace limner
