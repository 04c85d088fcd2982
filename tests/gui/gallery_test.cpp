// The gallery in the real window: styles onto the picture, and styles on the disk.
#include "gui/studio_window.h"

#include "app/studio/extraction_dialog.h"
#include "app/studio/style_shelf.h"
#include "app/studio/window_gallery.h"
#include "core/project/embedded_volume.h"
#include "core/volume/phantom.h"
#include "widgets/layer_list.h"
#include "widgets/layer_rows.h"
#include "widgets/notice_bar.h"
#include "widgets/style_details.h"
#include "widgets/style_drop.h"
#include "widgets/style_gallery.h"
#include "widgets/style_mime.h"
#include "widgets/transfer_editor_1d.h"

#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QToolButton>

#include <algorithm>
#include <filesystem>

namespace limner {
namespace {

using testing::pumpUntil;

struct GalleryStudio : testing::Studio {
    [[nodiscard]] StyleGallery& gallery() const { return window->gallery(); }
    [[nodiscard]] GalleryList& list() const { return *gallery().list(); }
    [[nodiscard]] StyleShelf& shelf() const { return window->styles().shelf(); }
    bool rested() {
        return pumpUntil([this] { return !shelf().busy() && !list().items().empty(); });
    }
    [[nodiscard]] int fileCount() const {
        const auto folder = std::filesystem::directory_iterator(styles.path().toStdString());
        return static_cast<int>(std::count_if(begin(folder), end(folder),
                                              [](const auto& entry) { return entry.path().extension() == ".png"; }));
    }
    /// Makes a copy of a bundled style; its key.
    std::string duplicate(const std::string& key) {
        QString made;
        const auto connection =
            QObject::connect(&shelf(), &StyleShelf::added, [&](const QString& added) { made = added; });
        gallery().list()->setCurrentKey(key);
        gallery().details()->duplicate()->click();
        EXPECT_TRUE(pumpUntil([&] { return !made.isEmpty(); }));
        QObject::disconnect(connection);
        EXPECT_TRUE(rested());
        return made.toStdString();
    }
    [[nodiscard]] QPointF at(double x, double y) const {
        const QRectF sheet = window->viewport().sheet();
        return sheet.topLeft() + QPointF(x * sheet.width(), y * sheet.height());
    }
};

template <class Event>
bool send(Viewport& viewport, QPointF at, QMimeData& data) {
    Event event(at.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, {});
    event.setAccepted(false);
    QApplication::sendEvent(&viewport, &event);
    return event.isAccepted();
}

/// A style dragged onto the skull in the picture: said before the drop, seen while the hand rests, one step, undone.
TEST(StudioGallery, AStyleIsDroppedOntoTheSkull) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.openSample());
    ASSERT_TRUE(studio.rested());
    studio.window->usePreset("skull", "Skull");
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    ASSERT_TRUE(studio.waitForFinal());
    const Figure start = studio.figure();
    const std::size_t steps = studio.window->document().history().position();
    StyleDrop& drop = studio.window->styles().drop();
    Viewport& viewport = studio.window->viewport();
    const auto unused = std::find_if(studio.list().items().begin(), studio.list().items().end(),
                                     [&](const GalleryItem& item) { return !start.findStyle(item.card.id); });
    QMimeData data;
    data.setData(kStyleMime, QByteArray::fromStdString(unused->key()));
    ASSERT_TRUE(send<QDragEnterEvent>(viewport, studio.at(0.5, 0.5), data));
    drop.waitIdle();
    ASSERT_TRUE(drop.target());
    const Layer& meant = start.layers[drop.target()->layer];
    EXPECT_TRUE(drop.words().startsWith(QString::fromStdString(meant.name))) << drop.words().toStdString();
    EXPECT_TRUE(drop.words().contains(QString::fromStdString(unused->card.name)));
    EXPECT_FALSE(drop.veil().isNull());
    ASSERT_TRUE(pumpUntil([&] { return viewport.picture()->plan->figure->findStyle(unused->card.id) != nullptr; }))
        << "a hand that rests sees it on the whole picture";
    EXPECT_EQ(studio.figure(), start);
    ASSERT_TRUE(send<QDropEvent>(viewport, studio.at(0.5, 0.5), data));
    EXPECT_EQ(studio.window->document().history().position(), steps + 1);
    ASSERT_NE(studio.figure().findStyle(unused->card.id), nullptr);
    EXPECT_FALSE(drop.isVisible());
    ASSERT_TRUE(studio.waitForFinal());
    studio.trigger("edit.undo");
    EXPECT_EQ(studio.figure(), start);
    ASSERT_TRUE(studio.waitForFinal());
}

TEST(StudioGallery, ADragThatLeavesShowsTheFigureAgain) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.openSample());
    ASSERT_TRUE(studio.rested());
    Viewport& viewport = studio.window->viewport();
    const auto styles = studio.figure().styles;
    const auto unused = std::find_if(studio.list().items().begin(), studio.list().items().end(),
                                     [&](const GalleryItem& item) { return !studio.figure().findStyle(item.card.id); });
    QMimeData data;
    data.setData(kStyleMime, QByteArray::fromStdString(unused->key()));
    ASSERT_TRUE(send<QDragEnterEvent>(viewport, studio.at(0.5, 0.5), data));
    ASSERT_TRUE(pumpUntil([&] { return viewport.picture()->plan->figure->styles != styles; }));
    QDragLeaveEvent leave;
    QApplication::sendEvent(&viewport, &leave);
    ASSERT_TRUE(pumpUntil([&] { return studio.hasFinal() && viewport.picture()->plan->figure->styles == styles; }));
    EXPECT_FALSE(studio.window->document().dirty());
}

TEST(StudioGallery, AClickIntoThePictureSelectsWhatLiesThere) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.openSample());
    Edit edit{studio.figure(), "", {}, false};
    Layer hidden = edit.figure.layers.front();
    hidden.visible = false;
    hidden.name = "Hidden";
    edit.figure.layers.insert(edit.figure.layers.begin(), hidden);
    studio.window->document().apply(edit);
    ASSERT_TRUE(studio.waitForFinal());
    ASSERT_EQ(studio.window->layers().selectedLayer(), 0U);
    QTest::mouseClick(&studio.window->viewport(), Qt::LeftButton, {}, studio.at(0.5, 0.5).toPoint());
    ASSERT_TRUE(pumpUntil([&] { return studio.window->layers().selectedLayer() != 0U; }));
    EXPECT_TRUE(studio.figure().layers[studio.window->layers().selectedLayer()].visible);
}

TEST(StudioGallery, FavouritesOutliveTheWindow) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.rested());
    const std::string key = studio.list().items().front().key();
    const QPoint star = studio.list().starRect(studio.list().rowOf(key)).center();
    QTest::mouseClick(studio.list().viewport(), Qt::LeftButton, {}, star);
    EXPECT_TRUE(studio.list().find(key)->favourite);
    ASSERT_TRUE(studio.rested());
    studio.shelf().reload();
    ASSERT_TRUE(studio.rested());
    EXPECT_TRUE(studio.list().find(key)->favourite) << "it is on the disk";
}

/// A copy of a bundled style is the user's own: renamed, removed, and brought back by the notice and by Ctrl+Z.
TEST(StudioGallery, OnesOwnStylesAreRenamedRemovedAndBroughtBack) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.openSample());
    ASSERT_TRUE(studio.rested());
    studio.window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(studio.window.get()));
    const std::string key = studio.duplicate(studio.list().items().front().key());
    EXPECT_TRUE(livesIn(key, StyleHome::mine));
    EXPECT_EQ(studio.fileCount(), 1);
    ASSERT_TRUE(pumpUntil([&] { return !studio.list().find(key)->ball.isNull(); }));
    EXPECT_EQ(studio.list().currentKey(), key) << "it is shown, also when its ball has come";

    QLineEdit* name = studio.gallery().details()->name();
    studio.list().setFocus();
    QTest::keyClick(&studio.list(), Qt::Key_F2);
    QTest::keyClicks(name, "Plate XI");
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_EQ(studio.list().find(key)->card.name, "Plate XI");
    ASSERT_TRUE(studio.rested());
    studio.shelf().reload();
    ASSERT_TRUE(studio.rested());
    EXPECT_EQ(studio.list().find(key)->card.name, "Plate XI") << "it is on the disk";

    studio.list().setFocus();
    studio.list().setCurrentKey(key);
    QTest::keyClick(&studio.list(), Qt::Key_Delete);
    EXPECT_EQ(studio.list().find(key), nullptr);
    ASSERT_TRUE(studio.rested());
    EXPECT_EQ(studio.fileCount(), 0);
    EXPECT_EQ(studio.window->notices().notices(), QStringList{"Removed “Plate XI” from your styles"});
    studio.window->notices().action()->click();
    ASSERT_TRUE(pumpUntil([&] { return studio.list().find(key) != nullptr; }));
    EXPECT_EQ(studio.fileCount(), 1);

    studio.list().setFocus();
    studio.list().setCurrentKey(key);
    QTest::keyClick(&studio.list(), Qt::Key_Delete);
    ASSERT_EQ(studio.list().find(key), nullptr);
    QTest::keyClick(&studio.list(), Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(pumpUntil([&] { return studio.list().find(key) != nullptr; }));
    EXPECT_EQ(studio.window->document().history().position(), 0U);
    EXPECT_TRUE(studio.window->notices().notices().empty());
}

/// After a step of the figure, Ctrl+Z in the gallery is the figure's again.
TEST(StudioGallery, TheNearerUndoCounts) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.openSample());
    ASSERT_TRUE(studio.rested());
    studio.window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(studio.window.get()));
    const std::string bundled = studio.list().items().back().key();
    const std::string key = studio.duplicate(bundled);
    studio.list().setFocus();
    QTest::keyClick(&studio.list(), Qt::Key_Delete);
    ASSERT_EQ(studio.list().find(key), nullptr);
    studio.list().setCurrentKey(bundled);
    QTest::keyClick(&studio.list(), Qt::Key_Return);
    ASSERT_EQ(studio.window->document().history().position(), 1U);
    QTest::keyClick(&studio.list(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(studio.window->document().history().position(), 0U);
    EXPECT_EQ(studio.list().find(key), nullptr);
}

/// One's own style is on the figure as its file, and in the project after it is saved.
TEST(StudioGallery, OnesOwnStyleGoesIntoTheProject) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.openSample());
    ASSERT_TRUE(studio.rested());
    const std::string key = studio.duplicate(studio.list().items().front().key());
    studio.list().setFocus();
    studio.list().setCurrentKey(key);
    QTest::keyClick(&studio.list(), Qt::Key_Return);
    const std::string id = studio.figure().layers[0].transfer.nodes.at(0).style;
    ASSERT_NE(studio.figure().findStyle(id), nullptr);
    EXPECT_TRUE(studio.figure().findStyle(id)->file.starts_with(studio.styles.path().toStdString()));
    const QTemporaryDir folder;
    studio.window->savePath(folder.filePath("head.limner").toStdString());
    ASSERT_TRUE(pumpUntil([&] { return !studio.window->busy(); }));
    const unsigned generation = studio.window->document().generation();
    studio.window->openPath(folder.filePath("head.limner").toStdString());
    ASSERT_TRUE(pumpUntil([&] { return studio.window->document().generation() != generation; }));
    EXPECT_NE(studio.list().rowOf(styleKey(StyleHome::project, id)), nullptr);
    EXPECT_EQ(studio.list().currentKey(), styleKey(StyleHome::project, id)) << "what the layer shows";
}

TEST(StudioGallery, ABallIsImported) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.rested());
    QImage picture(64, 64, QImage::Format_ARGB32);
    picture.fill(Qt::transparent);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (std::hypot(x - 31.5, y - 31.5) < 32)
                picture.setPixelColor(x, y, QColor(200, 255 - 2 * y, 40));
    const QTemporaryDir folder;
    const QString file = folder.filePath("Clay ball.png");
    ASSERT_TRUE(picture.save(file));
    QString key;
    QObject::connect(&studio.shelf(), &StyleShelf::added, [&](const QString& added) { key = added; });
    studio.window->styles().importPath(file.toStdString());
    ASSERT_TRUE(pumpUntil([&] { return !key.isEmpty(); }));
    const GalleryItem* item = studio.list().find(key.toStdString());
    ASSERT_NE(item, nullptr);
    EXPECT_EQ(item->card.origin, "Clay ball.png");
    ASSERT_TRUE(pumpUntil([&] { return !studio.list().find(key.toStdString())->ball.isNull(); }));
    EXPECT_EQ(studio.fileCount(), 1);
}

TEST(StudioGallery, ThePictureOnTheScanFollowsThePointer) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.openSample());
    ASSERT_TRUE(studio.rested());
    StyleDetails& details = *studio.gallery().details();
    details.onScan()->setChecked(true);
    const std::string first = studio.list().items()[0].key();
    studio.list().setCurrentKey(first);
    ASSERT_TRUE(pumpUntil([&] { return !details.scanPicture()->pixmap().isNull(); }));
    const QImage before = details.scanPicture()->pixmap().toImage();
    Q_EMIT studio.list().hovered(QString::fromStdString(studio.list().items()[5].key()));
    ASSERT_TRUE(pumpUntil([&] {
        return !details.scanPicture()->pixmap().isNull() && details.scanPicture()->pixmap().toImage() != before;
    }));
    EXPECT_EQ(studio.window->document().history().position(), 0U);
    details.onScan()->setChecked(false);
    EXPECT_TRUE(details.scanPicture()->pixmap().isNull());
}

/// Tab goes through all of the gallery from top to bottom, and on to the layers.
TEST(StudioGallery, TheKeyboardReachesAllOfIt) {
    GalleryStudio studio;
    ASSERT_TRUE(studio.openSample());
    ASSERT_TRUE(studio.rested());
    studio.window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(studio.window.get()));
    const std::string own = studio.duplicate(studio.list().items().front().key());
    studio.trigger("styles.find");
    const StyleGallery& gallery = studio.gallery();
    const StyleDetails& details = *gallery.details();
    std::vector<QWidget*> reached;
    for (int i = 0; i < 20 && studio.window->focusWidget() != studio.window->layers().list(); ++i) {
        reached.push_back(studio.window->focusWidget());
        QTest::keyClick(studio.window->focusWidget(), Qt::Key_Tab);
    }
    EXPECT_EQ(studio.window->focusWidget(), studio.window->layers().list());
    const std::initializer_list<QWidget*> all{gallery.search(), gallery.favourites(),   gallery.detailsButton(),
                                              gallery.list(),   gallery.importButton(), gallery.extractButton(),
                                              details.onScan(), details.name(),         details.tags(),
                                              details.credit(), details.licence(),      details.remove()};
    auto from = reached.begin();
    for (QWidget* widget : all) {
        from = std::find(from, reached.end(), widget);
        ASSERT_NE(from, reached.end()) << widget->accessibleName().toStdString() << widget->toolTip().toStdString();
    }
}

TEST(StudioGallery, ItsActionsAreInTheMenu) {
    GalleryStudio studio;
    EXPECT_EQ(studio.window->extraction(), nullptr);
    studio.gallery().extractButton()->click();
    ASSERT_NE(studio.window->extraction(), nullptr);
    studio.window->extraction()->close();
    ASSERT_TRUE(pumpUntil([&] { return studio.window->extraction() == nullptr; }));
    studio.trigger("styles.extract");
    ASSERT_NE(studio.window->extraction(), nullptr);
    studio.window->extraction()->close();
    studio.window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(studio.window.get()));
    studio.trigger("styles.find");
    EXPECT_TRUE(studio.gallery().search()->hasFocus());
}

} // namespace
} // namespace limner
