#include "widgets/style_drop.h"

#include "renderer/backend.h"
#include "renderer/plan/planner.h"
#include "support/qt/qt_events.h"
#include "widgets/style_mime.h"
#include "widgets/style_pictures.h"
#include "widgets/test_figure.h"
#include "widgets/viewport.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QTest>

namespace limner {
namespace {

using testing::pumpUntil;

/// A ball of bone within a ball of tissue; bone's nodes stand at 200 and 900 HU, and its core has 1000.
Figure opaqueFigure() {
    Figure figure = testing::smallFigure();
    figure.layers[1].transfer.opacity = {{-200, 0}, {-100, 0.5}, {100, 0.5}, {150, 0}};
    figure.layers[0].transfer.opacity = {{150, 0}, {250, 1}, {1000, 1}};
    return figure;
}

/// A viewport that shows the figure's picture, with drops straight into a history.
struct Dropping {
    explicit Dropping(const Figure& start = opaqueFigure()) {
        viewport.resize(400, 400);
        QObject::connect(&drop, &StyleDrop::edited, [this](const Edit& edit) {
            history.apply(edit);
            show();
        });
        QObject::connect(&drop, &StyleDrop::previewWanted,
                         [this](std::shared_ptr<const Figure> figure) { previews.push_back(std::move(figure)); });
        drop.setSource([this](const std::string& key) {
            auto style = std::make_shared<Style>();
            style->card.id = styleIdOf(key);
            style->card.name = "Ink";
            style->file = key;
            style->sphere = sphere;
            return key == "bundled:ink" ? style : nullptr;
        });
        history = History(start);
        viewport.show();
        QTest::qWait(0);
        show();
    }
    void show() {
        viewport.setFigure(history.current());
        drop.setFigure(history.current());
        PlanRequest request;
        request.size = {viewport.picturePixels().width(), viewport.picturePixels().height()};
        Task task;
        QImage image(viewport.picturePixels(), QImage::Format_RGB32);
        image.fill(Qt::white);
        viewport.setPicture({image, Planner().plan(*history.current(), request, task), {}, {}});
    }
    [[nodiscard]] QPoint at(double x, double y) const {
        const QRectF sheet = viewport.sheet();
        return (sheet.topLeft() + QPointF(x * sheet.width(), y * sheet.height())).toPoint();
    }
    bool enter(const QPoint& place, const char* key = "bundled:ink") {
        data.setData(kStyleMime, key);
        QDragEnterEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, {});
        event.setAccepted(false);
        QApplication::sendEvent(&viewport, &event);
        drop.waitIdle();
        return event.isAccepted();
    }
    void move(const QPoint& place, Qt::KeyboardModifiers modifiers = {}) {
        QDragMoveEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, modifiers);
        QApplication::sendEvent(&viewport, &event);
        drop.waitIdle();
    }
    void dropAt(const QPoint& place, Qt::KeyboardModifiers modifiers = {}) {
        QDropEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, modifiers);
        QApplication::sendEvent(&viewport, &event);
    }
    [[nodiscard]] const std::vector<TransferNode>& bone() const { return history.current()->layers[0].transfer.nodes; }
    QMimeData data;
    Viewport viewport;
    StyleDrop drop{&viewport};
    History history;
    std::shared_ptr<const LitSphere> sphere = testing::plainSphere(0.1F, 0.1F, 0.1F);
    std::vector<std::shared_ptr<const Figure>> previews;
};

/// Bone has two nodes far apart, tissue's veil is thin: the middle of the picture is bone.
Figure thinTissue() {
    Figure figure = opaqueFigure();
    figure.layers[1].transfer.opacity = {{-200, 0}, {-100, 0.01}, {100, 0.01}, {150, 0}};
    return figure;
}

TEST(StyleDrop, SaysWhatIsMeantBeforeTheDrop) {
    Dropping d(thinTissue());
    ASSERT_TRUE(d.enter(d.at(0.5, 0.5)));
    ASSERT_TRUE(d.drop.target());
    EXPECT_EQ(d.drop.target()->layer, 0U);
    EXPECT_TRUE(d.drop.isVisible());
    EXPECT_TRUE(d.drop.words().startsWith("Bone · around ")) << d.drop.words().toStdString();
    EXPECT_TRUE(d.drop.words().contains(" HU → Ink"));
    d.move(d.at(0.5, 0.5), Qt::ShiftModifier);
    EXPECT_EQ(d.drop.words(), "All of Bone → Ink");
    d.move(d.at(0.02, 0.02));
    EXPECT_FALSE(d.drop.target());
    EXPECT_EQ(d.drop.words(), "Nothing here to put a style onto");
    EXPECT_EQ(d.history.position(), 0U) << "nothing is changed by looking";
    QDragLeaveEvent leave;
    QApplication::sendEvent(&d.viewport, &leave);
    EXPECT_FALSE(d.drop.isVisible());
}

TEST(StyleDrop, ADropChangesThatNodeAlone) {
    Dropping d(thinTissue());
    const Figure start = *d.history.current();
    ASSERT_TRUE(d.enter(d.at(0.1, 0.1)));
    d.dropAt(d.at(0.5, 0.5)); // the ray of the drop itself counts
    ASSERT_EQ(d.history.position(), 1U);
    EXPECT_NE(d.bone()[0].style == "ink", d.bone()[1].style == "ink") << "one of the two";
    EXPECT_EQ(d.history.current()->layers[1], start.layers[1]);
    d.history.undo();
    EXPECT_EQ(*d.history.current(), start);
}

TEST(StyleDrop, ShiftMeansTheWholeLayer) {
    Dropping d(thinTissue());
    ASSERT_TRUE(d.enter(d.at(0.5, 0.5)));
    d.dropAt(d.at(0.5, 0.5), Qt::ShiftModifier);
    EXPECT_EQ(d.bone()[0].style, "ink");
    EXPECT_EQ(d.bone()[1].style, "ink");
    EXPECT_EQ(d.history.position(), 1U);
}

/// Where tissue hides the bone, and beside the bone, tissue is meant.
TEST(StyleDrop, TheRayDecidesBetweenLayers) {
    Dropping d;
    ASSERT_TRUE(d.enter(d.at(0.5, 0.5)));
    EXPECT_EQ(d.drop.target()->layer, 1U);
    EXPECT_EQ(d.drop.words(), "Skin → Ink") << "a layer of one node is meant whole";
    d.dropAt(d.at(0.5, 0.5));
    EXPECT_EQ(d.history.current()->layers[1].transfer.nodes[0].style, "ink");
    EXPECT_EQ(d.history.current()->layers[1].shading, Shading::style);
}

TEST(StyleDrop, PaperAndLockedLayersTakeNothing) {
    Figure figure = thinTissue();
    figure.layers[0].locked = true;
    Dropping d(figure);
    ASSERT_TRUE(d.enter(d.at(0.5, 0.5)));
    EXPECT_EQ(d.drop.words(), "Bone is locked");
    d.dropAt(d.at(0.5, 0.5));
    ASSERT_TRUE(d.enter(d.at(0.5, 0.5)));
    d.dropAt(d.at(0.01, 0.01));
    EXPECT_EQ(d.history.position(), 0U);
    EXPECT_FALSE(d.enter(d.at(0.5, 0.5), "mine:gone")) << "a style that is no more";
}

/// The veil lies where the part is seen, and nowhere else.
TEST(StyleDrop, TheVeilShowsThePartThatIsMeant) {
    Dropping d(thinTissue());
    ASSERT_TRUE(d.enter(d.at(0.5, 0.5)));
    const QImage veil = d.drop.veil();
    ASSERT_FALSE(veil.isNull());
    const auto alphaAt = [&](double x, double y) {
        return qAlpha(veil.pixel(static_cast<int>(x * veil.width()), static_cast<int>(y * veil.height())));
    };
    EXPECT_EQ(alphaAt(0.05, 0.05), 0);
    EXPECT_LT(alphaAt(0.5, 0.3), 20) << "tissue: its ball has a radius of 24 mm in a picture of 80";
    int inside = 0;
    int edge = 0;
    for (int y = 0; y < veil.height(); ++y)
        for (int x = 0; x < veil.width(); ++x) {
            edge += qAlpha(veil.pixel(x, y)) == 255 ? 1 : 0;
            inside += qAlpha(veil.pixel(x, y)) > 60 ? 1 : 0;
        }
    EXPECT_GT(inside, 0);
    EXPECT_GT(edge, 40) << "a line around it";
    EXPECT_LT(edge, inside);
}

TEST(StyleDrop, AHandThatRestsSeesTheFigureAsItWouldBe) {
    Dropping d(thinTissue());
    ASSERT_TRUE(d.enter(d.at(0.5, 0.5)));
    ASSERT_TRUE(pumpUntil([&] { return !d.previews.empty(); }));
    ASSERT_NE(d.previews.front(), nullptr);
    EXPECT_NE(d.previews.front()->findStyle("ink"), nullptr);
    EXPECT_EQ(d.history.position(), 0U);
    d.move(d.at(0.02, 0.02));
    ASSERT_EQ(d.previews.size(), 2U);
    EXPECT_EQ(d.previews.back(), nullptr) << "the figure itself again";
    d.move(d.at(0.5, 0.5));
    ASSERT_TRUE(pumpUntil([&] { return d.previews.size() == 3U; }));
    const Figure seen = *d.previews.back();
    d.dropAt(d.at(0.5, 0.5));
    EXPECT_EQ(*d.history.current(), seen) << "what was seen is what comes";
}

TEST(StyleDrop, FilesAreLeftToTheWindow) {
    Dropping d;
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile("scan.nrrd")});
    QDragEnterEvent event(d.at(0.5, 0.5), Qt::CopyAction, &files, Qt::LeftButton, {});
    event.setAccepted(false);
    QApplication::sendEvent(&d.viewport, &event);
    EXPECT_FALSE(event.isAccepted());
}

TEST(TargetWords, NameLabelsByTheirNames) {
    Figure figure = opaqueFigure();
    figure.labels = LabelReference{};
    figure.labels->names["7"] = "Mandible";
    Transfer& transfer = figure.layers[0].transfer;
    transfer.kind = TransferKind::twoDimensional;
    transfer.axes = {"value", "label"};
    transfer.grid = TransferGrid{{0}, {-1, 3, 7}, {{"a"}, {"b"}, {"c"}}};
    const auto words = [&](std::size_t node) {
        StyleTarget target;
        target.node = node;
        return targetWords(figure, target);
    };
    EXPECT_EQ(words(0), "Bone · other labels");
    EXPECT_EQ(words(1), "Bone · label 3");
    EXPECT_EQ(words(2), "Bone · Mandible");
}

TEST(StylePictures, TheFigureIsDrawnSmallInItsFormatAndOnItsPaper) {
    Figure figure = opaqueFigure();
    figure.output.widthMm = 200;
    figure.output.heightMm = 100;
    figure.background.rgba = {0, 0, 1, 1};
    PlanRequest request;
    request.size = {64, 32};
    Task task;
    const auto shown = Planner().plan(figure, request, task);
    StylePictures pictures;
    const QImage before = pictures.figure(*shown, figure, 80, task);
    EXPECT_EQ(before.size(), QSize(80, 40));
    EXPECT_EQ(before.pixelColor(1, 1), QColor(Qt::blue));
    figure.layers[1].transfer.nodes[0].rgb = glm::dvec3(0, 1, 0);
    const QImage after = pictures.figure(*shown, figure, 80, task);
    EXPECT_NE(after.pixelColor(40, 20), before.pixelColor(40, 20));
    task.cancel();
    EXPECT_THROW(pictures.figure(*shown, figure, 80, task), Error);
}

} // namespace
} // namespace limner
