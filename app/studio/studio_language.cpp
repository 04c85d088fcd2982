#include "app/studio/studio_language.h"

#include "core/base/resources.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

namespace limner {
namespace {

constexpr auto kSetting = "window/language";

} // namespace

std::span<const StudioLanguage> studioLanguages() {
    static const StudioLanguage kLanguages[] = {
        {"", QCoreApplication::translate("StudioLanguage", "As the desktop")}, {"en", "English"}, {"de", "Deutsch"}};
    return kLanguages;
}

QString chosenStudioLanguage() { return QSettings().value(kSetting).toString(); }

void chooseStudioLanguage(const QString& code) { QSettings().setValue(kSetting, code); }

void applyStudioLanguage(QApplication& application) {
    const QString chosen = chosenStudioLanguage();
    const QLocale locale = chosen.isEmpty() ? QLocale::system() : QLocale(chosen);
    QLocale::setDefault(locale);
    auto* own = new QTranslator(&application);
    if (own->load(locale, "limner", "_", QString::fromStdString((resourcesFolder() / "translations").string())))
        QApplication::installTranslator(own);
    auto* qt = new QTranslator(&application);
    if (qt->load(locale, "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QApplication::installTranslator(qt);
}

} // namespace limner
