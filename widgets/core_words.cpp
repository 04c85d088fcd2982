#include "widgets/core_words.h"

#include <QCoreApplication>

namespace limner {

QString coreWord(const std::string& english) { return QCoreApplication::translate("Core", english.c_str()); }

QString inSentence(const QString& name) {
    //: Names inside a sentence: translate to "small" or to "as they are" (nouns keep their capital), in these words.
    return QCoreApplication::translate("Sentences", "small") == QLatin1String("small") ? name.toLower() : name;
}

} // namespace limner
