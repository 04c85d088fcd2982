#include "widgets/command_palette.h"

#include "widgets/action_match.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QLineEdit>
#include <QListWidget>
#include <QTest>

namespace limner {
namespace {

TEST(ActionMatch, WordStartsBeatInsidesAndThoseBeatScatteredLetters) {
    const auto start = matchScore("exp", "Export picture");
    const auto inside = matchScore("port", "Export picture");
    const auto letters = matchScore("exc", "Export picture");
    ASSERT_TRUE(start && inside && letters);
    EXPECT_GT(*start, *inside);
    EXPECT_GT(*inside, *letters);
    EXPECT_FALSE(matchScore("xyz", "Export picture"));
    EXPECT_FALSE(matchScore("export lens", "Export picture")) << "every word counts";
    EXPECT_TRUE(matchScore("picture export", "Export picture")) << "in any order";
    EXPECT_TRUE(matchScore("", "Export picture"));
}

TEST(ActionMatch, CaseAndAccentsDoNotCountAndTheShorterNameWins) {
    EXPECT_TRUE(matchScore("grosse", QStringLiteral("Größe ändern")));
    EXPECT_TRUE(matchScore("ANDERN", QStringLiteral("Größe ändern")));
    EXPECT_GT(*matchScore("save", "Save"), *matchScore("save", "Save as another file"));
}

struct Palette {
    Palette() {
        for (QAction* action : {&save, &saveAs, &exporting}) {
            action->setObjectName(action->text());
            QObject::connect(action, &QAction::triggered, [this, action] { done << action->text(); });
        }
        saveAs.setShortcut(QKeySequence("Ctrl+Shift+S"));
        exporting.setEnabled(false);
        dialog = new CommandPalette({{"File", &save}, {"File", &saveAs}, {"File", &exporting}}, nullptr);
        dialog->show();
    }
    QAction save{"&Save"}, saveAs{"Save &as…"}, exporting{"&Export picture…"};
    QStringList done;
    QPointer<CommandPalette> dialog;
};

TEST(CommandPalette, TypingAndEnterPerformsTheBestMatch) {
    Palette palette;
    EXPECT_EQ(palette.dialog->list()->count(), 3);
    QTest::keyClicks(palette.dialog->search(), "sav");
    ASSERT_EQ(palette.dialog->list()->count(), 2);
    EXPECT_EQ(palette.dialog->list()->item(0)->text(), "File: Save");
    EXPECT_TRUE(palette.dialog->list()->item(1)->text().contains("Ctrl+Shift+S"));
    QTest::keyClick(palette.dialog->search(), Qt::Key_Down);
    QTest::keyClick(palette.dialog->search(), Qt::Key_Return);
    EXPECT_EQ(palette.done, QStringList("Save &as…"));
    QTest::qWait(0);
    EXPECT_TRUE(palette.dialog.isNull()) << "it is gone once the command is given";
}

TEST(CommandPalette, WhatCannotBeDoneStandsLastAndDoesNothing) {
    Palette palette;
    EXPECT_EQ(palette.dialog->list()->item(2)->text(), "File: Export picture");
    QTest::keyClicks(palette.dialog->search(), "export");
    QTest::keyClick(palette.dialog->search(), Qt::Key_Return);
    EXPECT_TRUE(palette.done.isEmpty());
    ASSERT_FALSE(palette.dialog.isNull());
    QTest::keyClick(palette.dialog->search(), Qt::Key_Escape);
    QTest::qWait(0);
    EXPECT_TRUE(palette.dialog.isNull());
}

} // namespace
} // namespace limner
