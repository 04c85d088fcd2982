#include "widgets/history_list.h"
#include "widgets/missing_bar.h"
#include "widgets/output_list.h"
#include "widgets/recovery_bar.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

namespace limner {
namespace {

Figure withTitle(const std::string& title) {
    Figure figure;
    figure.title = title;
    return figure;
}

TEST(HistoryList, FollowsTheStepsAndSaysWhereTheUserWants) {
    HistoryList list;
    EXPECT_FALSE(list.isEnabled());
    History history(withTitle("0"));
    for (int i = 1; i <= 3; ++i)
        history.apply({withTitle(std::to_string(i)), "Step " + std::to_string(i), {}, false});
    list.setHistory(&history);
    EXPECT_TRUE(list.isEnabled());
    ASSERT_EQ(list.steps()->count(), 4);
    EXPECT_EQ(list.steps()->item(0)->text(), "As it was opened");
    EXPECT_EQ(list.steps()->item(3)->text(), "Step 3");
    EXPECT_EQ(list.steps()->currentRow(), 3);
    history.goTo(1);
    history.apply({withTitle("other"), "Other", {}, false});
    list.setHistory(&history);
    ASSERT_EQ(list.steps()->count(), 3);
    EXPECT_EQ(list.steps()->item(2)->text(), "Other");
    std::size_t wanted = 9;
    QObject::connect(&list, &HistoryList::goWanted, &list, [&](std::size_t at) { wanted = at; });
    list.resize(300, 500);
    list.show();
    QTest::mouseClick(list.steps()->viewport(), Qt::LeftButton, {},
                      list.steps()->visualItemRect(list.steps()->item(1)).center());
    EXPECT_EQ(wanted, 1U);
    list.steps()->setFocus();
    list.steps()->setCurrentRow(0);
    QTest::keyClick(list.steps(), Qt::Key_Return);
    EXPECT_EQ(wanted, 0U) << "the keyboard goes there too";
}

TEST(HistoryList, NamedStatesAreRenamedAndForgotten) {
    HistoryList list;
    History history;
    list.setHistory(&history);
    list.setNames({"a", "b"});
    QStringList heard;
    QObject::connect(&list, &HistoryList::renamed, &list,
                     [&](int at, const QString& name) { heard << QString::number(at) + name; });
    QObject::connect(&list, &HistoryList::forgetWanted, &list, [&](int at) { heard << QString::number(at); });
    list.names()->item(1)->setText("c");
    list.names()->setCurrentRow(0);
    for (QToolButton* button : list.findChildren<QToolButton*>())
        if (button->text() == "Forget")
            button->click();
    EXPECT_EQ(heard, QStringList({"1c", "0"}));
}

TEST(OutputList, OffersWhatEachStateAllows) {
    OutputList list;
    using State = OutputRow::State;
    std::vector<OutputRow> rows;
    for (const State state : {State::queued, State::running, State::done, State::failed, State::stopped}) {
        OutputRow row;
        row.id = static_cast<int>(rows.size()) + 1;
        row.name = "a.png";
        row.state = state;
        row.phase = "Rendering";
        row.fraction = 0.5;
        row.problem = "the disk is full";
        rows.push_back(row);
    }
    list.setRows(rows);
    const auto offered = [&](int id) {
        QStringList names;
        for (const char* what : {"cancel", "retry", "show", "folder", "remove"})
            if (!list.button(id, what)->isHidden())
                names << what;
        return names.join(' ');
    };
    EXPECT_EQ(offered(1), "cancel");
    EXPECT_EQ(offered(2), "cancel");
    EXPECT_EQ(offered(3), "show folder remove");
    EXPECT_EQ(offered(4), "retry remove");
    EXPECT_EQ(offered(5), "retry remove");
    EXPECT_EQ(list.status(2), "Rendering, 50 %");
    EXPECT_EQ(list.status(4), "failed: the disk is full");
    int retried = 0;
    QObject::connect(&list, &OutputList::retryWanted, &list, [&](int id) { retried = id; });
    list.button(4, "retry")->click();
    EXPECT_EQ(retried, 4);
    rows.erase(rows.begin());
    list.setRows(rows);
    EXPECT_EQ(list.button(1, "cancel"), nullptr);
    EXPECT_EQ(offered(3), "show folder remove");
}

TEST(RecoveryBar, ShowsEachWorkWithItsTwoButtons) {
    RecoveryBar bar;
    EXPECT_TRUE(bar.isHidden());
    bar.setRows({{"head <1>", "today", "", {}}, {"foot", "yesterday", "/a/foot.limner", {}}});
    EXPECT_FALSE(bar.isHidden());
    int restored = -1;
    int discarded = -1;
    QObject::connect(&bar, &RecoveryBar::restoreWanted, &bar, [&](int row) { restored = row; });
    QObject::connect(&bar, &RecoveryBar::discardWanted, &bar, [&](int row) { discarded = row; });
    for (QPushButton* button : bar.findChildren<QPushButton*>())
        if (button->accessibleName() == "Restore foot" || button->accessibleName() == "Discard head <1>")
            button->click();
    EXPECT_EQ(restored, 1);
    EXPECT_EQ(discarded, 0);
    bar.setRows({});
    EXPECT_TRUE(bar.isHidden());
}

TEST(MissingBar, AsksForAFileOrAFolder) {
    MissingBar bar;
    bar.setMissing("gone");
    QStringList heard;
    QObject::connect(&bar, &MissingBar::findWanted, &bar, [&] { heard << "file"; });
    QObject::connect(&bar, &MissingBar::findFolderWanted, &bar, [&] { heard << "folder"; });
    bar.find()->click();
    bar.findFolder()->click();
    EXPECT_EQ(heard, QStringList({"file", "folder"}));
}

TEST(MissingBar, ItsSearchStartsAndStops) {
    MissingBar bar;
    EXPECT_TRUE(bar.isHidden());
    bar.setMissing("gone");
    EXPECT_FALSE(bar.isHidden());
    QStringList heard;
    QObject::connect(&bar, &MissingBar::searchWanted, &bar, [&] { heard << "search"; });
    QObject::connect(&bar, &MissingBar::stopWanted, &bar, [&] { heard << "stop"; });
    bar.search()->click();
    bar.setSearching(true);
    bar.search()->click();
    EXPECT_EQ(heard, QStringList({"search", "stop"}));
    bar.setMissing({});
    EXPECT_TRUE(bar.isHidden());
}

} // namespace
} // namespace limner
