// The list of the core's words for translators, and what the translations make of them.
#include "widgets/core_words.h"

#include "core/base/resources.h"
#include "core/figure/parameters.h"
#include "core/figure/part_presets.h"
#include "core/figure/presets.h"
#include "core/figure/stipple_presets.h"
#include "core/figure/themes.h"
#include "renderer/plan/leave_out.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QTranslator>
#include <QXmlStreamReader>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

namespace limner {
namespace {

std::set<std::string> allWords() {
    std::set<std::string> words;
    for (const Parameter& parameter : parameterTable())
        words.insert({parameter.label, parameter.help});
    for (const PresetCard& card : bundledPresets())
        words.insert({card.name, card.help});
    for (const ThemeCard& card : bundledThemes())
        words.insert({card.name, card.help});
    for (const auto& preset : stipplePresets())
        words.insert({preset.name, preset.help});
    for (const auto& preset : tonePresets())
        words.insert({preset.name, preset.help});
    for (const auto& preset : positionPresets())
        words.insert({preset.name, preset.help});
    for (const LeaveOutRule& rule : leaveOutRules())
        words.insert(rule.name);
    words.erase("");
    return words;
}

std::string listOf(const std::set<std::string>& words) {
    std::string text = "// For lupdate: the core's words (widgets/core_words.h). Written by "
                       "resources/translations/update.\n// clang-format off\n";
    for (const std::string& word : words) {
        std::string escaped;
        for (const char c : word)
            escaped += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
        text += "QT_TRANSLATE_NOOP(\"Core\", \"" + escaped + "\")\n";
    }
    return text;
}

TEST(CoreWords, TheTranslatorsListIsComplete) {
    const std::string wanted = listOf(allWords());
    if (const char* path = std::getenv("LIMNER_UPDATE_WORDS"))
        std::ofstream(path) << wanted;
    std::ifstream file(LIMNER_SOURCE_DIR "/resources/translations/core_words.h");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(text, wanted) << "run resources/translations/update";
}

/// What a text says to a program: placeholders, mnemonics, line ends. A translation must keep the first.
QStringList placeholdersOf(const QString& text) {
    static const QRegularExpression kPlace("%(?:[0-9]+|n)");
    QStringList places;
    for (auto match = kPlace.globalMatch(text); match.hasNext();)
        places << match.next().captured();
    places.sort();
    places.removeDuplicates();
    return places;
}

TEST(Translations, GermanIsCompleteAndKeepsPlaceholders) {
    QFile file(LIMNER_SOURCE_DIR "/resources/translations/limner_de.ts");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString source;
    int messages = 0;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == u"source")
            source = xml.readElementText();
        else if (xml.name() == u"translation") {
            ++messages;
            EXPECT_NE(xml.attributes().value("type"), u"unfinished") << source.toStdString();
            const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
            EXPECT_FALSE(text.isEmpty()) << source.toStdString();
            EXPECT_EQ(placeholdersOf(text), placeholdersOf(source)) << source.toStdString();
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    EXPECT_GT(messages, 1000);
}

TEST(Translations, TheCompiledCatalogueSpeaksGerman) {
    QTranslator german;
    ASSERT_TRUE(german.load("limner_de", QString::fromStdString((resourcesFolder() / "translations").string())));
    QCoreApplication::installTranslator(&german);
    EXPECT_EQ(QCoreApplication::translate("Actions", "&Open…"), QString::fromUtf8("&Öffnen …"));
    std::set<std::string> same;
    for (const std::string& word : allWords())
        if (coreWord(word).toStdString() == word && word.find(' ') != std::string::npos)
            same.insert(word);
    EXPECT_TRUE(same.empty()) << *same.begin();
    QCoreApplication::removeTranslator(&german);
    EXPECT_EQ(coreWord("no such word"), "no such word");
}

} // namespace
} // namespace limner
