#include "widgets/core_words.h"

#include <QCoreApplication>

namespace limner {

QString coreWord(const std::string& english) { return QCoreApplication::translate("Core", english.c_str()); }

} // namespace limner
