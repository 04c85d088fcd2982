// The gallery's styles as files.
#include "app/studio/style_shelf.h"

#include "core/base/error.h"
#include "support/qt/qt_events.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>

namespace limner {
namespace {

using testing::pumpUntil;

Style plainStyle(const std::string& id) {
    Style style;
    style.card.id = id;
    style.card.name = id;
    style.file = "bundled:" + id;
    style.sphere = std::make_shared<const LitSphere>(16, std::vector<Rgba>(256, Rgba{0.5F, 0.4F, 0.3F, 1}));
    return style;
}

struct Shelf {
    explicit Shelf(const QString& folder) : shelf(folder.toStdString()) {
        QObject::connect(&shelf, &StyleShelf::failed, [this](const Error& error) { failures << error.what(); });
        QObject::connect(&shelf, &StyleShelf::problemsFound, [this](const QStringList& lines) { problems += lines; });
        shelf.setBundled({plainStyle("clay")});
        shelf.reload();
    }
    bool rested() {
        return pumpUntil([this] { return !shelf.busy(); });
    }
    [[nodiscard]] std::optional<GalleryItem> item(const std::string& key) const {
        for (const GalleryItem& one : shelf.items())
            if (one.key() == key)
                return one;
        return std::nullopt;
    }
    StyleShelf shelf;
    QStringList failures;
    QStringList problems;
};

/// What is asked for one after the other is written in that order, also where the window closes meanwhile.
TEST(StyleShelf, WritesAllThatWasAskedForBeforeItGoes) {
    const QTemporaryDir folder;
    {
        Shelf s(folder.path());
        s.shelf.add("Adding", [](Task&) { return plainStyle("ochre"); });
        s.shelf.add("Adding", [](Task&) { return plainStyle("umber"); });
        ASSERT_TRUE(pumpUntil([&] { return s.item("mine:umber").has_value(); }));
        StyleCard card = s.item("mine:ochre")->card;
        for (const char* name : {"First", "Second", "Third"}) {
            card.name = name;
            s.shelf.change(card);
        }
        s.shelf.setFavourite("mine:ochre", true);
        s.shelf.setFavourite("bundled:clay", true);
        EXPECT_EQ(s.item("mine:ochre")->card.name, "Third") << "seen at once";
        s.shelf.remove("umber");
        s.shelf.restore();
        s.shelf.add("Adding", [](Task&) { return plainStyle("sienna"); });
    }
    Shelf again(folder.path());
    ASSERT_TRUE(again.rested());
    ASSERT_TRUE(again.item("mine:ochre"));
    EXPECT_EQ(again.item("mine:ochre")->card.name, "Third");
    EXPECT_TRUE(again.item("mine:ochre")->favourite);
    EXPECT_TRUE(again.item("mine:umber"));
    EXPECT_TRUE(again.item("mine:sienna"));
    EXPECT_TRUE(again.item("bundled:clay")->favourite);
    EXPECT_TRUE(again.failures.empty());
    EXPECT_EQ(again.shelf.style("mine:ochre")->file, folder.filePath("ochre.png").toStdString());
    EXPECT_EQ(again.shelf.style("bundled:clay")->file, "bundled:clay");
}

/// A folder that cannot be made: the words are told, and what was shown too early is taken back.
TEST(StyleShelf, WhatCannotBeWrittenIsNotShown) {
    const QTemporaryDir folder;
    QFile inTheWay(folder.filePath("file"));
    ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
    inTheWay.close();
    Shelf s(folder.filePath("file/styles"));
    ASSERT_TRUE(s.rested());
    s.shelf.setFavourite("bundled:clay", true);
    s.shelf.add("Adding", [](Task&) { return plainStyle("ochre"); });
    ASSERT_TRUE(s.rested());
    EXPECT_EQ(s.failures.size(), 2);
    EXPECT_FALSE(s.item("bundled:clay")->favourite);
    EXPECT_FALSE(s.item("mine:ochre"));
    EXPECT_EQ(s.shelf.style("mine:ochre"), nullptr);
}

TEST(StyleShelf, BrokenFilesAreToldAndTheOthersListed) {
    const QTemporaryDir folder;
    {
        Shelf s(folder.path());
        s.shelf.add("Adding", [](Task&) { return plainStyle("ochre"); });
        s.shelf.add("Adding", [](Task&) { return plainStyle("umber"); });
        ASSERT_TRUE(s.rested());
    }
    QFile picture(folder.filePath("umber.json"));
    ASSERT_TRUE(picture.open(QIODevice::WriteOnly));
    picture.write("{ this is no card");
    picture.close();
    Shelf s(folder.path());
    ASSERT_TRUE(s.rested());
    EXPECT_TRUE(s.item("mine:ochre"));
    EXPECT_FALSE(s.problems.empty());
    EXPECT_TRUE(
        std::any_of(s.problems.begin(), s.problems.end(), [](const QString& line) { return line.contains("umber"); }));
    ASSERT_TRUE(pumpUntil([&] { return !s.item("mine:ochre")->ball.isNull(); }));
}

TEST(StyleShelf, RemovedStylesComeBackLastOneFirst) {
    const QTemporaryDir folder;
    Shelf s(folder.path());
    for (const char* id : {"ochre", "umber"})
        s.shelf.add("Adding", [id](Task&) { return plainStyle(id); });
    ASSERT_TRUE(s.rested());
    s.shelf.remove("ochre");
    s.shelf.remove("umber");
    ASSERT_TRUE(s.rested());
    EXPECT_FALSE(s.item("mine:ochre") || s.item("mine:umber"));
    s.shelf.restore();
    ASSERT_TRUE(s.rested());
    EXPECT_TRUE(s.item("mine:umber"));
    EXPECT_FALSE(s.item("mine:ochre"));
    EXPECT_TRUE(s.shelf.canRestore());
    s.shelf.restore();
    ASSERT_TRUE(s.rested());
    EXPECT_TRUE(s.item("mine:ochre"));
    EXPECT_FALSE(s.shelf.canRestore());
    EXPECT_TRUE(s.failures.empty());
}

} // namespace
} // namespace limner
