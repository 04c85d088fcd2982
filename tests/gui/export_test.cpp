// Exports in the real window: the dialog, the line of exports and their panel.
#include "gui/studio_window.h"

#include "app/studio/export_queue.h"
#include "app/studio/window_export.h"
#include "core/project/embedded_volume.h"
#include "core/volume/phantom.h"
#include "renderer/export/finished_bands.h"
#include "support/small_disk.h"
#include "widgets/output_list.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QToolButton>

#include <fstream>
#include <sstream>

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::pumpUntil;
using testing::Studio;
using State = OutputRow::State;

std::string bytesOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

struct Exports {
    Exports() {
        Task task;
        const fs::path scan = folder.filePath("scan.nrrd").toStdString();
        writeNrrd(*makeHeadPhantom(32), scan, task);
        studio.window->openPath(scan);
        EXPECT_TRUE(pumpUntil([&] { return !studio.window->document().empty(); }));
        feature = studio.window->findChild<WindowExport*>();
    }
    [[nodiscard]] fs::path file(const char* name) const { return folder.filePath(name).toStdString(); }
    static ExportDialog::Choice choice(double mm) {
        ExportDialog::Choice choice;
        choice.output = {mm, mm, 254, false}; // ten pixels a millimetre
        choice.ending = "png";
        return choice;
    }
    [[nodiscard]] State state(int at) const { return feature->queue().rows().at(static_cast<std::size_t>(at)).state; }
    bool wait() {
        return pumpUntil([&] { return !feature->busy(); });
    }
    QTemporaryDir folder;
    Studio studio;
    WindowExport* feature = nullptr;
};

TEST(Export, SeveralAreWrittenOneAfterTheOtherAsTheFigureWasThen) {
    Exports on;
    QStringList written;
    QObject::connect(on.feature, &WindowExport::pictureExported, on.studio.window.get(),
                     [&](const QString& path) { written << QFileInfo(path).fileName(); });
    on.feature->exportPath(on.file("a.png"), Exports::choice(20));
    Edit edit{on.studio.figure(), "Paint the paper black", {}, false};
    edit.figure.background.rgba = {0, 0, 0, 1};
    on.studio.window->document().apply(edit);
    on.feature->exportPath(on.file("b.png"), Exports::choice(30));
    EXPECT_EQ(on.state(0), State::running);
    EXPECT_EQ(on.state(1), State::queued);
    EXPECT_EQ(on.feature->list().status(2), "waits");
    ASSERT_TRUE(on.wait());
    EXPECT_EQ(written, QStringList({"a.png", "b.png"}));
    const QImage a(on.folder.filePath("a.png"));
    const QImage b(on.folder.filePath("b.png"));
    EXPECT_EQ(a.size(), QSize(200, 200));
    EXPECT_EQ(b.size(), QSize(300, 300));
    EXPECT_EQ(a.pixelColor(0, 0), QColor(Qt::white)) << "as it was when it was asked for";
    EXPECT_EQ(b.pixelColor(0, 0), QColor(Qt::black));
    EXPECT_EQ(on.studio.figure().output.widthMm, 30) << "the size is the project's";
    EXPECT_FALSE(on.feature->list().button(1, "show")->isHidden());
    on.feature->list().button(1, "remove")->click();
    EXPECT_EQ(on.feature->list().button(1, "remove"), nullptr);
    EXPECT_TRUE(fs::exists(on.file("a.png"))) << "off the list, not off the disk";
}

TEST(Export, AFailedOneSaysWhyAndGoesOnToTheSamePicture) {
    Exports on;
    const fs::path whole = on.file("whole.png");
    on.feature->exportPath(whole, Exports::choice(120));
    ASSERT_TRUE(on.wait());
    const fs::path path = on.file("parts.png");
    {
        const testing::SmallDisk disk(static_cast<rlim_t>(fs::file_size(whole) / 2));
        on.feature->exportPath(path, Exports::choice(120));
        ASSERT_TRUE(on.wait());
    }
    ASSERT_EQ(on.state(1), State::failed);
    EXPECT_TRUE(on.feature->list().status(2).contains("parts.png")) << on.feature->list().status(2).toStdString();
    EXPECT_FALSE(fs::exists(path));
    EXPECT_TRUE(fs::exists(FinishedBands::fileFor(path)));
    on.feature->list().button(2, "retry")->click();
    ASSERT_TRUE(on.wait());
    EXPECT_EQ(on.state(1), State::done);
    EXPECT_TRUE(bytesOf(path) == bytesOf(whole));
    EXPECT_FALSE(fs::exists(FinishedBands::fileFor(path)));
}

TEST(Export, AStoppedOneGoesOnAndARemovedOneLeavesNothing) {
    Exports on;
    on.feature->exportPath(on.file("a.png"), Exports::choice(200));
    on.feature->exportPath(on.file("b.png"), Exports::choice(20));
    on.feature->exportPath(on.file("c.png"), Exports::choice(20));
    on.feature->list().button(3, "cancel")->click();
    EXPECT_EQ(on.state(2), State::stopped);
    on.feature->list().button(1, "cancel")->click();
    ASSERT_TRUE(on.wait());
    EXPECT_EQ(on.state(0), State::stopped);
    EXPECT_EQ(on.state(1), State::done) << "the next one has its turn";
    on.feature->list().button(3, "retry")->click();
    ASSERT_TRUE(on.wait());
    EXPECT_EQ(on.state(2), State::done);
    on.feature->list().button(1, "remove")->click();
    EXPECT_FALSE(fs::exists(FinishedBands::fileFor(on.file("a.png"))));
    EXPECT_FALSE(fs::exists(on.file("a.png")));
}

TEST(Export, TheWindowAsksBeforeItClosesOverARunningOne) {
    Exports on;
    int asked = 0;
    bool leave = false;
    on.feature->askAboutLeaving = [&] {
        ++asked;
        return leave;
    };
    on.feature->exportPath(on.file("a.png"), Exports::choice(300));
    on.studio.window->close();
    EXPECT_EQ(asked, 1);
    EXPECT_TRUE(on.studio.window->isVisible());
    leave = true;
    on.studio.window->close();
    EXPECT_TRUE(pumpUntil([&] { return !on.studio.window->isVisible(); }));
    EXPECT_EQ(asked, 2) << "once is enough, though the unsaved changes were asked about as well";
}

TEST(ExportDialog, SizesByNameAndByUnit) {
    Figure figure;
    figure.output = {180, 90, 300, false}; // it lies
    ExportDialog dialog(figure, 2);
    dialog.units()->setCurrentIndex(0);
    const auto use = [&](const char* part) {
        const int at = dialog.sizes()->findText(part, Qt::MatchContains);
        dialog.sizes()->setCurrentIndex(at);
        Q_EMIT dialog.sizes()->activated(at);
    };
    use("one column");
    EXPECT_EQ(dialog.choice().output.widthMm, 85);
    EXPECT_EQ(dialog.choice().output.heightMm, 42.5) << "the proportions stay";
    use("A4");
    EXPECT_EQ(dialog.choice().output.widthMm, 297) << "the sheet lies as the figure does";
    EXPECT_EQ(dialog.choice().output.heightMm, 210);
    use("A0");
    EXPECT_EQ(dialog.choice().output.widthMm, 1189);
    use("Screen");
    EXPECT_EQ(dialog.choice().output.sizePixels(), glm::ivec2(1920, 1080));
    EXPECT_EQ(dialog.units()->currentText(), "pixels");
    EXPECT_EQ(dialog.width()->value(), 1920);
    dialog.dpi()->setValue(192);
    EXPECT_EQ(dialog.choice().output.sizePixels(), glm::ivec2(1920, 1080)) << "in pixels the pixels stay";
    EXPECT_NEAR(dialog.choice().output.widthMm, 254, 1e-9);
    dialog.units()->setCurrentIndex(1);
    EXPECT_EQ(dialog.width()->value(), 10) << "inches";
    dialog.width()->setValue(5);
    EXPECT_NEAR(dialog.choice().output.widthMm, 127, 1e-9);
    EXPECT_NEAR(dialog.choice().output.heightMm, 127 / (16.0 / 9), 1e-9);
    EXPECT_EQ(dialog.sizes()->currentText(), "Other");
    use("As in the figure");
    EXPECT_EQ(dialog.choice().output, figure.output);
}

TEST(ExportDialog, SaysWhatItTakesAndRemembersTheRest) {
    Figure figure;
    figure.output = {254, 254, 100, false}; // a million pixels
    {
        ExportDialog dialog(figure, 2);
        EXPECT_TRUE(dialog.estimate().contains("about 2 s")) << dialog.estimate().toStdString();
        EXPECT_TRUE(dialog.estimate().contains("memory"));
        for (QComboBox* box : dialog.findChildren<QComboBox*>())
            if (const int tiff = box->findData("tif"); tiff >= 0)
                box->setCurrentIndex(tiff);
        dialog.units()->setCurrentIndex(1);
        dialog.accept();
    }
    ExportDialog dialog(figure, 2);
    EXPECT_EQ(dialog.choice().ending, "tif");
    EXPECT_EQ(dialog.units()->currentIndex(), 1);
    EXPECT_EQ(dialog.choice().output, figure.output);
    dialog.units()->setCurrentIndex(0);
    dialog.accept();
}

} // namespace
} // namespace limner
