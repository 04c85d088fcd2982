// Styles taken from an artwork, in the real window.
#include "app/studio/extraction_dialog.h"
#include "app/studio/main_window.h"

#include "app/studio/studio_theme.h"
#include "support/qt/nameless_controls.h"
#include "support/qt/qt_events.h"
#include "widgets/artwork_canvas.h"
#include "widgets/artwork_tool_bar.h"
#include "widgets/extraction_form.h"
#include "widgets/figure_preview.h"
#include "widgets/gallery_list.h"
#include "widgets/layer_list.h"
#include "widgets/notice_bar.h"
#include "widgets/slider_row.h"
#include "widgets/style_card_form.h"
#include "widgets/style_gallery.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <numbers>

namespace limner {
namespace {

using testing::pumpUntil;

constexpr int kArtWidth = 480;
constexpr int kArtHeight = 360;
const QPointF kBall(180, 170);
constexpr double kRadius = 90;

/// A red ball, lit from the upper left, on grey-brown paper.
QImage paintedBall() {
    QImage image(kArtWidth, kArtHeight, QImage::Format_RGB32);
    for (int y = 0; y < kArtHeight; ++y)
        for (int x = 0; x < kArtWidth; ++x) {
            const double u = (x + 0.5 - kBall.x()) / kRadius;
            const double v = (kBall.y() - y - 0.5) / kRadius;
            const double z2 = 1 - u * u - v * v;
            const double light = z2 > 0 ? std::max(0.0, (-u + v + 1.2 * std::sqrt(z2)) / std::sqrt(3.44)) : 0;
            image.setPixelColor(x, y,
                                z2 > 0 ? QColor::fromRgbF(static_cast<float>(0.25 + 0.65 * light),
                                                          static_cast<float>(0.08 + 0.45 * light),
                                                          static_cast<float>(0.07 + 0.3 * light))
                                       : QColor(204, 198, 184));
        }
    return image;
}

struct Extracting {
    explicit Extracting(bool withFigure) {
        qputenv("LIMNER_STYLES", folder.filePath("styles").toUtf8());
        applyStudioTheme(*qApp);
        window = std::make_unique<MainWindow>(makeEngine());
        window->askAboutChanges = [] { return MainWindow::Answer::discard; };
        window->show();
        if (withFigure) {
            window->openSample();
            EXPECT_TRUE(pumpUntil([this] { return !window->document().empty(); }));
        }
        window->actions().at("styles.extract")->trigger();
        dialog = window->extraction();
        dialog->askAboutUnadded = [this] {
            ++asked;
            return ExtractionDialog::Answer::cancel;
        };
        EXPECT_TRUE(QTest::qWaitForWindowExposed(dialog));
    }
    ~Extracting() {
        if (dialog)
            dialog->askAboutUnadded = [] { return ExtractionDialog::Answer::discard; };
    }
    [[nodiscard]] QString save(const QImage& image, const QString& name) const {
        const QString path = folder.filePath(name);
        EXPECT_TRUE(image.save(path));
        return path;
    }
    bool open(const QImage& image, const QString& name) {
        const PlatePtr before = dialog->draft().plate;
        dialog->openArtwork(save(image, name).toStdString());
        return pumpUntil([&] { return dialog->draft().plate != before; });
    }
    [[nodiscard]] QPoint at(QPointF place) const {
        return dialog->canvas().view().toWidget({place.x(), place.y()}).toPoint();
    }
    void drag(QPointF from, QPointF to) {
        ArtworkCanvas& canvas = dialog->canvas();
        QTest::mousePress(&canvas, Qt::LeftButton, {}, at(from));
        for (int part = 1; part <= 4; ++part) {
            const QPointF way(at(from + (to - from) * part / 4));
            QMouseEvent move(QEvent::MouseMove, way, canvas.mapToGlobal(way), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(&canvas, &move);
        }
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, at(to));
    }
    bool waitForBall() {
        return pumpUntil([this] {
            const auto& pictures = dialog->form().view()->pictures();
            return !dialog->busy() && pictures && pictures->sphere;
        });
    }
    [[nodiscard]] const LitSphere& sphere() const { return *dialog->form().view()->pictures()->sphere; }

    QTemporaryDir folder;
    std::unique_ptr<MainWindow> window;
    QPointer<ExtractionDialog> dialog;
    int asked = 0;
};

/// A proposal is clicked, the style is added and used: it is on disk and on the layer, and undo in the window takes it
/// off the figure again.
TEST(Extraction, AClickAndTwoButtonsPutAStyleOnTheFigure) {
    Extracting on(true);
    ASSERT_TRUE(on.open(paintedBall(), "painted_ball.png"));
    EXPECT_EQ(on.dialog->card().name()->text(), "Painted ball");
    EXPECT_FALSE(on.dialog->card().add()->isEnabled());
    const auto tryClick = [&] {
        QTest::mouseClick(&on.dialog->canvas(), Qt::LeftButton, {}, on.at(kBall + QPointF(30, 30)));
        return on.dialog->draft().form == FormKind::ellipse;
    };
    ASSERT_TRUE(pumpUntil(tryClick, 20000)) << "the ball is proposed";
    const Ellipse taken = *on.dialog->draft().ellipse;
    EXPECT_NEAR(taken.centre.x, kBall.x(), 3);
    EXPECT_NEAR(taken.centre.y, kBall.y(), 3);
    EXPECT_NEAR(taken.semiAxes.x, kRadius, 4);
    ASSERT_TRUE(on.waitForBall());
    EXPECT_EQ(on.sphere().size(), 512);
    EXPECT_GT(on.sphere().at(-0.5, 0.5).r, on.sphere().at(0.6, -0.6).r + 0.3) << "lit from the upper left";
    EXPECT_TRUE(pumpUntil([&] { return on.dialog->preview().upToDate(); })) << "the figure shows it, too";
    EXPECT_TRUE(on.dialog->unadded());

    QTest::keyClicks(on.dialog->card().credit(), "A. Painter");
    const Figure before = *on.window->document().figure();
    on.dialog->card().addAndUse()->click();
    ASSERT_TRUE(pumpUntil([&] { return !on.dialog->unadded(); }));
    const StyleLibrary::Listing kept = StyleLibrary(on.folder.filePath("styles").toStdString()).list();
    ASSERT_EQ(kept.cards.size(), 1U);
    EXPECT_EQ(kept.cards[0].name, "Painted ball");
    EXPECT_EQ(kept.cards[0].credit, "A. Painter");
    EXPECT_TRUE(kept.cards[0].origin.starts_with("painted_ball.png, ellipse ")) << kept.cards[0].origin;
    const Figure& figure = *on.window->document().figure();
    const Layer& layer = figure.layers.at(on.window->layers().selectedLayer());
    ASSERT_FALSE(layer.transfer.nodes.empty());
    const StyleEntry* entry = figure.findStyle(layer.transfer.nodes.front().style);
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(entry->name, "Painted ball");
    EXPECT_EQ(entry->credit, "A. Painter");
    ASSERT_TRUE(entry->sphere);
    EXPECT_NEAR(entry->sphere->at(0, 0).r, on.sphere().at(0, 0).r, 1e-3) << "as written, with 16 bits";
    const auto homes = [&] {
        std::vector<StyleHome> found;
        for (const GalleryItem& item : on.window->gallery().list()->items())
            if (item.card.name == "Painted ball")
                found.push_back(item.home);
        return found;
    };
    EXPECT_TRUE(pumpUntil([&] { return homes() == std::vector{StyleHome::mine}; }, 20000)) << "in the gallery, once";
    on.window->actions().at("edit.undo")->trigger();
    EXPECT_EQ(on.window->document().figure()->layers, before.layers);

    EXPECT_TRUE(on.dialog->isVisible()) << "open for the next style from the plate";
    EXPECT_EQ(on.dialog->card().name()->text(), "Painted ball 2");
    EXPECT_EQ(on.dialog->card().credit()->text(), "A. Painter");
    on.dialog->card().closeButton()->click();
    EXPECT_EQ(on.asked, 0) << "all is added";
    EXPECT_TRUE(pumpUntil([&] { return on.dialog.isNull(); }));
}

/// Undo and redo inside the dialog bring back both the form and what comes of it; the window's figure is not touched.
TEST(Extraction, UndoIsTheDialogsOwn) {
    Extracting on(true);
    ASSERT_TRUE(on.open(paintedBall(), "painted_ball.png"));
    on.drag(kBall, kBall + QPointF(kRadius, 0));
    ASSERT_TRUE(on.waitForBall());
    const auto whole = on.dialog->form().view()->pictures();
    on.dialog->form().turn()->slider()->setValue(270); // 90 degrees
    EXPECT_EQ(on.dialog->draft().edits.turnDegrees, 90);
    ASSERT_TRUE(on.waitForBall());
    EXPECT_GT(on.sphere().at(-0.5, -0.5).r, on.sphere().at(0.5, 0.5).r + 0.2) << "from the lower left now";
    on.dialog->undoAction()->trigger();
    EXPECT_EQ(on.dialog->draft().edits.turnDegrees, 0);
    ASSERT_TRUE(on.waitForBall());
    EXPECT_GT(on.sphere().at(-0.5, 0.5).r, on.sphere().at(0.5, -0.5).r + 0.2);
    on.dialog->undoAction()->trigger();
    EXPECT_EQ(on.dialog->draft().form, FormKind::none);
    EXPECT_FALSE(on.dialog->form().view()->pictures());
    EXPECT_FALSE(on.dialog->card().add()->isEnabled());
    on.dialog->redoAction()->trigger();
    ASSERT_TRUE(on.waitForBall());
    EXPECT_EQ(on.dialog->form().view()->pictures()->sphere->size(), whole->sphere->size());
    EXPECT_FALSE(on.window->document().history().canUndo());
}

TEST(Extraction, BlankPaperIsSaidInALineAndNothingCanBeAdded) {
    Extracting on(false);
    QImage blank(300, 200, QImage::Format_RGB32);
    blank.fill(QColor(240, 236, 224));
    ASSERT_TRUE(on.open(blank, "blank.png"));
    on.drag({150, 100}, {200, 100});
    ASSERT_TRUE(pumpUntil([&] { return !on.dialog->notices().notices().isEmpty(); }));
    EXPECT_FALSE(on.dialog->card().add()->isEnabled());
    EXPECT_FALSE(on.dialog->unadded());
    EXPECT_FALSE(on.dialog->form().view()->pictures());
    on.dialog->undoAction()->trigger();
    EXPECT_EQ(on.dialog->draft().form, FormKind::none);
}

TEST(Extraction, WhatIsNoPictureLeavesTheArtworkThatThereIs) {
    Extracting on(false);
    ASSERT_TRUE(on.open(paintedBall(), "painted_ball.png"));
    const PlatePtr plate = on.dialog->draft().plate;
    QFile text(on.folder.filePath("words.png"));
    ASSERT_TRUE(text.open(QIODevice::WriteOnly));
    text.write("no picture");
    text.close();
    on.dialog->openArtwork(text.fileName().toStdString());
    ASSERT_TRUE(pumpUntil([&] { return !on.dialog->notices().notices().isEmpty(); }));
    EXPECT_EQ(on.dialog->draft().plate, plate);
}

TEST(Extraction, AnOutlinedFormWithItsMarksGivesAStyle) {
    Extracting on(false);
    ASSERT_TRUE(on.open(paintedBall(), "painted_ball.png"));
    on.dialog->tools().button(ToolKind::region)->click();
    ArtworkCanvas& canvas = on.dialog->canvas();
    QTest::mousePress(&canvas, Qt::LeftButton, {}, on.at(kBall + QPointF(1.1 * kRadius, 0)));
    for (int i = 1; i <= 48; ++i) {
        const double angle = 2 * std::numbers::pi * i / 48;
        const QPointF way(on.at(kBall + QPointF(std::cos(angle), std::sin(angle)) * 1.1 * kRadius));
        QMouseEvent move(QEvent::MouseMove, way, canvas.mapToGlobal(way), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&canvas, &move);
    }
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, on.at(kBall + QPointF(1.1 * kRadius, 0)));
    ASSERT_TRUE(pumpUntil([&] { return on.dialog->draft().form == FormKind::region; }));
    const Mask& region = *on.dialog->draft().region;
    EXPECT_TRUE(region.has(180, 170));
    EXPECT_TRUE(region.has(180, 170 - 80));
    EXPECT_FALSE(region.has(30, 30));
    ASSERT_TRUE(on.waitForBall());
    EXPECT_GT(on.sphere().at(-0.4, 0.4).r, on.sphere().at(0.5, -0.5).r + 0.2);
    on.dialog->tools().button(ToolKind::normal)->click();
    on.drag(kBall, kBall);
    ASSERT_EQ(on.dialog->draft().marks.normals.size(), 1U);
    EXPECT_TRUE(on.waitForBall());
    EXPECT_EQ(on.asked, 0);
    on.dialog->card().closeButton()->click();
    EXPECT_EQ(on.asked, 1) << "the style has not been added";
    EXPECT_TRUE(on.dialog && on.dialog->isVisible());
}

TEST(Extraction, PastedPicturesAndPickedColoursGiveAStyle) {
    Extracting on(false);
    QApplication::clipboard()->setImage(paintedBall());
    on.dialog->paste();
    ASSERT_TRUE(pumpUntil([&] { return on.dialog->draft().plate != nullptr; }));
    EXPECT_EQ(on.dialog->draft().plate->size(), QSize(kArtWidth, kArtHeight));
    on.dialog->tools().button(ToolKind::picker)->click();
    QTest::mouseClick(&on.dialog->canvas(), Qt::LeftButton, {}, on.at(kBall + QPointF(-40, -40)));
    QTest::mouseClick(&on.dialog->canvas(), Qt::LeftButton, {}, on.at(kBall + QPointF(60, 60)));
    ASSERT_TRUE(on.waitForBall());
    const double before = on.sphere().at(0.6, 0.6).r;
    ExtractionView* view = on.dialog->form().view();
    const QRectF ball = view->ballRect();
    QTest::mouseClick(view, Qt::LeftButton, {}, (ball.center() + QPointF(0.5, -0.5) * ball.width() / 2).toPoint());
    EXPECT_NEAR(on.dialog->draft().swatches.towardsLight.x, 0.5, 0.03);
    EXPECT_NEAR(on.dialog->draft().swatches.towardsLight.y, 0.5, 0.03);
    ASSERT_TRUE(pumpUntil([&] { return !on.dialog->busy(); }));
    EXPECT_GT(on.sphere().at(0.6, 0.6).r, before) << "the light has come round";
}

TEST(Extraction, LettersChooseToolsButNotWhileTyping) {
    Extracting on(false);
    ASSERT_TRUE(on.open(paintedBall(), "painted_ball.png"));
    on.dialog->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(on.dialog));
    on.dialog->canvas().setFocus();
    QTest::keyClick(&on.dialog->canvas(), Qt::Key_R);
    EXPECT_EQ(on.dialog->canvas().tool(), ToolKind::region);
    on.dialog->card().name()->setFocus();
    QTest::keyClick(on.dialog->card().name(), Qt::Key_C);
    EXPECT_EQ(on.dialog->canvas().tool(), ToolKind::region);
    EXPECT_TRUE(on.dialog->card().name()->text().endsWith('c'));
    QTest::keyClick(&on.dialog->canvas(), Qt::Key_Escape);
    EXPECT_TRUE(on.dialog->isVisible()) << "Escape gives up what is begun, not the dialog";
}

/// What cannot be looked through by eye: every control can be reached and has a name to be read out.
TEST(Extraction, ControlsHaveNames) {
    Extracting on(false);
    for (const std::string& control : testing::namelessControls(*on.dialog))
        ADD_FAILURE() << control;
}

} // namespace
} // namespace limner
