#include "widgets/style_gallery.h"

#include "support/qt/qt_events.h"
#include "widgets/style_details.h"
#include "widgets/style_image.h"
#include "widgets/style_mime.h"
#include "widgets/test_figure.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QTest>
#include <QToolButton>

namespace limner {
namespace {

using testing::pumpUntil;

std::shared_ptr<const Style> someStyle(const std::string& key) {
    auto style = std::make_shared<Style>();
    style->card.id = styleIdOf(key);
    style->card.name = style->card.id;
    style->file = livesIn(key, StyleHome::mine) ? "/styles/" + style->card.id + ".png" : key;
    style->sphere = testing::plainSphere(0.5F, 0.4F, 0.3F);
    return style;
}

std::vector<GalleryItem> someItems() {
    const auto item = [](StyleHome home, const char* name, std::vector<std::string> tags) {
        GalleryItem made;
        made.home = home;
        made.card.name = name;
        made.card.id = QString(name).toLower().replace(' ', '-').toStdString();
        made.card.tags = std::move(tags);
        made.file = someStyle(made.key())->file;
        made.ball = colourBall(Qt::red, kGalleryBallPixels);
        return made;
    };
    return {item(StyleHome::mine, "Old master", {"skeleton", "warm"}),
            item(StyleHome::mine, "Red chalk", {"drawing", "warm"}), item(StyleHome::bundled, "Ink line", {"drawing"}),
            item(StyleHome::bundled, "Ivory bone", {"skeleton"}), item(StyleHome::bundled, "Red chalk", {"drawing"})};
}

/// A gallery over a history, as the window joins them.
struct Gallery {
    Gallery() {
        gallery.resize(264, 820);
        gallery.setSource(someStyle);
        gallery.setItems(someItems());
        QObject::connect(&gallery, &StyleGallery::edited, [this](const Edit& edit) {
            history.apply(edit);
            show(0, std::nullopt);
        });
        show(0, std::nullopt);
        gallery.QWidget::show();
        gallery.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&gallery));
    }
    void show(std::size_t layer, std::optional<std::size_t> node) { gallery.setFigure(history.current(), layer, node); }
    [[nodiscard]] const Transfer& transfer() const { return history.current()->layers[0].transfer; }
    [[nodiscard]] GalleryList& list() { return *gallery.list(); }
    void click(const std::string& key, QPoint at = {}) {
        QListWidgetItem* row = list().rowOf(key);
        ASSERT_NE(row, nullptr);
        const QPoint place = at.isNull() ? list().visualItemRect(row).center() : at;
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, place);
    }
    /// Shown rows of a kind, their texts.
    [[nodiscard]] QStringList shown(GalleryList::Row kind) {
        QStringList texts;
        for (int i = 0; i < list().count(); ++i)
            if (!list().item(i)->isHidden() &&
                list().item(i)->data(GalleryList::kRowRole).toInt() == static_cast<int>(kind))
                texts << list().item(i)->text();
        return texts;
    }
    StyleGallery gallery;
    History history{testing::smallFigure()};
};

TEST(StyleGallery, AClickReplacesTheStyleOfNodeOrLayer) {
    Gallery g;
    const Figure start = *g.history.current();
    g.show(0, 1);
    g.click("bundled:red-chalk");
    EXPECT_EQ(g.transfer().nodes[0].style, "ivory");
    EXPECT_EQ(g.transfer().nodes[1].style, "red-chalk");
    ASSERT_NE(g.history.current()->findStyle("red-chalk"), nullptr);
    EXPECT_EQ(g.history.current()->findStyle("red-chalk")->file, "bundled:red-chalk");
    g.click("bundled:ink-line");
    for (const TransferNode& node : g.transfer().nodes)
        EXPECT_EQ(node.style, "ink-line");
    EXPECT_EQ(g.history.current()->findStyle("ivory"), nullptr) << "bundled styles that nothing uses leave";
    EXPECT_EQ(g.history.position(), 2U);
    g.history.undo();
    g.history.undo();
    EXPECT_EQ(*g.history.current(), start);
}

/// Two homes may have one id: the key tells them apart.
TEST(StyleGallery, OnesOwnStyleIsNotTheBundledOneOfThatName) {
    Gallery g;
    g.click("mine:red-chalk");
    ASSERT_NE(g.history.current()->findStyle("red-chalk"), nullptr);
    EXPECT_EQ(g.history.current()->findStyle("red-chalk")->file, "/styles/red-chalk.png");
    EXPECT_EQ(g.list().currentKey(), "mine:red-chalk");
    EXPECT_EQ(g.shown(GalleryList::Row::heading), (QStringList{"Mine (2)", "Bundled (3)"})) << "it is no project's";
}

TEST(StyleGallery, SearchesNamesAndTags) {
    Gallery g;
    const auto names = [&] { return g.shown(GalleryList::Row::style); };
    EXPECT_EQ(names().size(), 5);
    g.gallery.search()->setText("SKEL");
    EXPECT_EQ(names(), (QStringList{"Old master", "Ivory bone"}));
    g.gallery.search()->setText("draw chalk");
    EXPECT_EQ(names(), (QStringList{"Red chalk", "Red chalk"}));
    g.gallery.search()->setText("master");
    EXPECT_EQ(g.shown(GalleryList::Row::heading), QStringList{"Mine (1)"}) << "headings of nothing go";
    g.gallery.search()->setText("no such thing");
    EXPECT_TRUE(names().empty());
    g.gallery.search()->clear();
    EXPECT_EQ(names().size(), 5);
}

TEST(StyleGallery, TagsNarrowTheList) {
    Gallery g;
    auto* warm = g.gallery.tagMenu()->findChild<QAction*>("tag.warm");
    ASSERT_NE(warm, nullptr);
    EXPECT_EQ(warm->text(), "warm (2)");
    warm->trigger();
    EXPECT_EQ(g.shown(GalleryList::Row::style), (QStringList{"Old master", "Red chalk"}));
    g.gallery.tagMenu()->findChild<QAction*>("tag.drawing")->trigger();
    EXPECT_EQ(g.shown(GalleryList::Row::style), QStringList{"Red chalk"}) << "all of them";
    g.gallery.tagMenu()->actions().front()->trigger();
    EXPECT_EQ(g.shown(GalleryList::Row::style).size(), 5);
}

TEST(StyleGallery, EnterWorksLikeAClick) {
    Gallery g;
    g.show(0, 0);
    g.list().setFocus();
    g.list().setCurrentKey("bundled:ivory-bone");
    QTest::keyClick(&g.list(), Qt::Key_Return);
    EXPECT_EQ(g.transfer().nodes[0].style, "ivory-bone");
}

TEST(StyleGallery, ALockedLayerIsLeftAloneButStylesCanBeLookedAt) {
    Gallery g;
    Edit edit{*g.history.current(), "", {}, false};
    edit.figure.layers[0].locked = true;
    g.history.apply(edit);
    g.show(0, std::nullopt);
    g.click("bundled:ink-line");
    EXPECT_EQ(g.history.position(), 1U);
    EXPECT_EQ(g.gallery.details()->name()->text(), "Ink line");
    EXPECT_FALSE(g.gallery.place());
}

TEST(StyleGallery, StarsAskForFavourites) {
    Gallery g;
    QStringList asked;
    QObject::connect(&g.gallery, &StyleGallery::favouriteWanted,
                     [&](const QString& key, bool on) { asked << key + (on ? " on" : " off"); });
    g.click("bundled:ink-line", g.list().starRect(g.list().rowOf("bundled:ink-line")).center());
    EXPECT_EQ(asked, QStringList{"bundled:ink-line on"});
    EXPECT_EQ(g.history.position(), 0U) << "a star is no click on the style";
    auto items = someItems();
    items[1].favourite = true;
    g.gallery.setItems(items);
    g.list().setFocus();
    g.list().setCurrentKey("mine:red-chalk");
    QTest::keyClick(&g.list(), Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(asked.last(), "mine:red-chalk off");
    g.gallery.favourites()->click();
    EXPECT_EQ(g.shown(GalleryList::Row::style), QStringList{"Red chalk"});
    g.gallery.favourites()->click();
    EXPECT_EQ(g.shown(GalleryList::Row::style).size(), 5);
}

TEST(StyleGallery, HeadingsFoldTheirStylesAway) {
    Gallery g;
    QListWidgetItem* mine = g.list().item(0);
    QTest::mouseClick(g.list().viewport(), Qt::LeftButton, {}, g.list().visualItemRect(mine).center());
    EXPECT_EQ(g.shown(GalleryList::Row::style), (QStringList{"Ink line", "Ivory bone", "Red chalk"}));
    g.list().setFocus();
    g.list().setCurrentItem(mine);
    QTest::keyClick(&g.list(), Qt::Key_Space);
    EXPECT_EQ(g.shown(GalleryList::Row::style).size(), 5);
}

TEST(StyleGallery, SaysHowToGetStylesWhereThereAreNone) {
    Gallery g;
    auto items = someItems();
    items.erase(items.begin(), items.begin() + 2);
    g.gallery.setItems(items);
    EXPECT_EQ(g.shown(GalleryList::Row::note),
              QStringList{"No styles of your own yet. Take one from an artwork, or import a picture."});
    g.gallery.search()->setText("ink");
    EXPECT_TRUE(g.shown(GalleryList::Row::note).empty());
    int imports = 0;
    int extractions = 0;
    QObject::connect(&g.gallery, &StyleGallery::importWanted, [&] { ++imports; });
    QObject::connect(&g.gallery, &StyleGallery::extractRequested, [&] { ++extractions; });
    g.gallery.importButton()->click();
    g.gallery.extractButton()->click();
    EXPECT_EQ(imports, 1);
    EXPECT_EQ(extractions, 1);
}

/// What the figure has from elsewhere is listed, and put on by its own id.
TEST(StyleGallery, TheProjectsOwnStylesAreListed) {
    Gallery g;
    Edit edit{*g.history.current(), "", {}, false};
    edit.figure.styles.push_back({"plate", "styles/plate.png", "Plate XI", "", "", testing::plainSphere(0, 0, 1)});
    edit.figure.styles.push_back(
        {"chalk", "/styles/red-chalk.png", "Red chalk", "", "", testing::plainSphere(1, 0, 0)});
    g.history.apply(edit);
    g.show(0, std::nullopt);
    EXPECT_EQ(g.shown(GalleryList::Row::heading), (QStringList{"Mine (2)", "This project (1)", "Bundled (3)"}));
    ASSERT_NE(g.list().rowOf("project:plate"), nullptr);
    EXPECT_FALSE(g.list().find("project:plate")->ball.isNull());
    g.show(0, std::nullopt);
    EXPECT_NE(g.list().rowOf("project:plate"), nullptr) << "it stays";
    g.gallery.setFigure(nullptr, 0, std::nullopt);
    EXPECT_EQ(g.list().rowOf("project:plate"), nullptr);
}

TEST(StyleGallery, TheCardOfOnesOwnStyleCanBeChanged) {
    Gallery g;
    std::vector<StyleCard> changed;
    QObject::connect(&g.gallery, &StyleGallery::cardChanged, [&](const StyleCard& card) { changed.push_back(card); });
    g.list().setFocus();
    g.list().setCurrentKey("mine:old-master");
    QTest::keyClick(&g.list(), Qt::Key_F2);
    StyleDetails& details = *g.gallery.details();
    ASSERT_TRUE(details.name()->hasFocus());
    QTest::keyClicks(details.name(), "Plate XI");
    QTest::keyClick(details.name(), Qt::Key_Return);
    ASSERT_EQ(changed.size(), 1U);
    EXPECT_EQ(changed[0].id, "old-master");
    EXPECT_EQ(changed[0].name, "Plate XI");
    EXPECT_EQ(changed[0].tags, (std::vector<std::string>{"skeleton", "warm"}));
    details.tags()->setFocus();
    details.tags()->selectAll();
    QTest::keyClicks(details.tags(), " bone,, ink , bone");
    details.licence()->setFocus();
    ASSERT_EQ(changed.size(), 2U);
    EXPECT_EQ(changed[1].tags, (std::vector<std::string>{"bone", "ink"}));
    details.name()->setFocus();
    details.name()->clear();
    QTest::keyClick(details.name(), Qt::Key_Return);
    EXPECT_EQ(changed.size(), 2U) << "a style keeps a name";
    EXPECT_EQ(details.name()->text(), "Plate XI");
}

/// What is typed when another style is chosen is not lost.
TEST(StyleGallery, AnUnfinishedLineIsTakenWhenTheChoiceChanges) {
    Gallery g;
    std::vector<StyleCard> changed;
    QObject::connect(&g.gallery, &StyleGallery::cardChanged, [&](const StyleCard& card) { changed.push_back(card); });
    g.list().setCurrentKey("mine:old-master");
    g.gallery.details()->credit()->setFocus();
    QTest::keyClicks(g.gallery.details()->credit(), "Gautier");
    g.list().setCurrentKey("bundled:ink-line");
    ASSERT_EQ(changed.size(), 1U);
    EXPECT_EQ(changed[0].id, "old-master");
    EXPECT_EQ(changed[0].credit, "Gautier");
}

TEST(StyleGallery, BundledStylesCanOnlyBeDuplicated) {
    Gallery g;
    QStringList asked;
    QObject::connect(&g.gallery, &StyleGallery::duplicateWanted, [&](const QString& key) { asked << "copy " + key; });
    QObject::connect(&g.gallery, &StyleGallery::removeWanted, [&](const QString& key) { asked << "remove " + key; });
    StyleDetails& details = *g.gallery.details();
    g.list().setFocus();
    g.list().setCurrentKey("bundled:ink-line");
    EXPECT_TRUE(details.name()->isReadOnly());
    EXPECT_FALSE(details.remove()->isVisible());
    QTest::keyClick(&g.list(), Qt::Key_Delete);
    details.duplicate()->click();
    EXPECT_EQ(asked, QStringList{"copy bundled:ink-line"});
    g.list().setCurrentKey("mine:red-chalk");
    EXPECT_FALSE(details.name()->isReadOnly());
    EXPECT_FALSE(details.duplicate()->isVisible());
    QTest::keyClick(&g.list(), Qt::Key_Delete);
    details.remove()->click();
    EXPECT_EQ(asked.mid(1), (QStringList{"remove mine:red-chalk", "remove mine:red-chalk"}));
}

TEST(StyleGallery, WhatIsRemovedGivesWayToItsNeighbour) {
    Gallery g;
    g.list().setCurrentKey("mine:old-master");
    auto items = someItems();
    items.erase(items.begin());
    g.gallery.setItems(items);
    EXPECT_EQ(g.list().currentKey(), "mine:red-chalk") << "the keyboard goes on from there";
    EXPECT_EQ(g.gallery.details()->name()->text(), "Red chalk");
}

TEST(StyleGallery, UndoInTheGalleryBringsARemovedStyleBackWhileOffered) {
    Gallery g;
    int restored = 0;
    QObject::connect(&g.gallery, &StyleGallery::restoreWanted, [&] { ++restored; });
    g.list().setFocus();
    QTest::keyClick(&g.list(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(restored, 0) << "the window's undo is meant";
    g.gallery.setRemovalOffered(true);
    QTest::keyClick(&g.list(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(restored, 1);
}

TEST(StyleGallery, PicturesOnTheScanAreAskedForWhatIsPointedAtOrChosen) {
    Gallery g;
    QStringList asked;
    QObject::connect(&g.gallery, &StyleGallery::previewWanted, [&](const QString& key) { asked << key; });
    StyleDetails& details = *g.gallery.details();
    g.list().setCurrentKey("mine:red-chalk");
    QTest::qWait(250);
    EXPECT_TRUE(asked.empty()) << "not asked for";
    details.onScan()->click();
    ASSERT_TRUE(pumpUntil([&] { return asked.size() == 1; }));
    EXPECT_EQ(asked.last(), "mine:red-chalk");
    Q_EMIT g.list().hovered("bundled:ink-line");
    Q_EMIT g.list().hovered("bundled:ivory-bone");
    ASSERT_TRUE(pumpUntil([&] { return asked.size() == 2; }));
    EXPECT_EQ(asked.last(), "bundled:ivory-bone") << "one that is passed over is not";
    QImage picture(40, 40, QImage::Format_RGB32);
    picture.fill(Qt::green);
    g.gallery.setPreview("bundled:ink-line", picture);
    EXPECT_TRUE(details.scanPicture()->pixmap().isNull()) << "of another style";
    g.gallery.setPreview("bundled:ivory-bone", picture);
    EXPECT_EQ(details.scanPicture()->pixmap().toImage().pixelColor(5, 5), QColor(Qt::green));
    details.onScan()->click();
    EXPECT_TRUE(details.scanPicture()->pixmap().isNull());
    EXPECT_EQ(asked.last(), "");
}

TEST(StyleGallery, StylesTravelByTheirKey) {
    Gallery g;
    QListWidgetItem* row = g.list().rowOf("mine:red-chalk");
    const std::unique_ptr<QMimeData> data(g.list().model()->mimeData({g.list().model()->index(g.list().row(row), 0)}));
    EXPECT_EQ(data->data(kStyleMime), "mine:red-chalk");
}

/// Cells share the width in even columns; a heading has it whole.
TEST(StyleGallery, BallsComeInThreeSizes) {
    Gallery g;
    int before = 1000;
    for (const BallSize size : {BallSize::small, BallSize::medium, BallSize::large}) {
        g.gallery.setBallSize(size);
        const auto laidOut = [&] { // a scroll bar that comes or goes takes a second round
            return std::abs(g.list().visualItemRect(g.list().item(0)).width() - g.list().viewport()->width()) <= 4;
        };
        ASSERT_TRUE(pumpUntil([&] { return QTest::qWait(20), laidOut(); }));
        const QRect first = g.list().visualItemRect(g.list().rowOf("bundled:ink-line"));
        const int columns = g.list().viewport()->width() / first.width();
        EXPECT_LT(columns, before);
        EXPECT_GE(columns, 2) << "even large ones stand side by side";
        before = columns;
        const QRect second = g.list().visualItemRect(g.list().rowOf("bundled:ivory-bone"));
        EXPECT_EQ(second.top(), first.top());
        EXPECT_EQ(second.left(), first.left() + first.width());
        g.gallery.grab();
    }
}

TEST(StyleGallery, EveryControlHasANameAndAReason) {
    Gallery g;
    for (const QToolButton* button : g.gallery.findChildren<QToolButton*>()) {
        if (button->parent() == g.gallery.search())
            continue; // Qt's own, that clears it
        EXPECT_FALSE(button->toolTip().isEmpty()) << button->text().toStdString();
        EXPECT_FALSE(button->text().isEmpty() && button->accessibleName().isEmpty());
    }
    for (const QLineEdit* line : g.gallery.findChildren<QLineEdit*>())
        EXPECT_FALSE(line->toolTip().isEmpty()) << line->accessibleName().toStdString();
    for (int i = 0; i < g.list().count(); ++i)
        EXPECT_FALSE(g.list().item(i)->data(Qt::AccessibleTextRole).toString().isEmpty() &&
                     g.list().item(i)->text().isEmpty());
}

} // namespace
} // namespace limner
