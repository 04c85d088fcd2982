#include "gradient_backend.h"
#include "renderer/annotations/area_fill.h"
#include "renderer/export/picture_file.h"

#include <gtest/gtest.h>

#include <OpenImageIO/imagebuf.h>

#include <glm/geometric.hpp>

#include <expat.h>

#include <cstdlib>
#include <fstream>

#include <unistd.h>

namespace limner {
namespace {

using testing::GradientBackend;
namespace fs = std::filesystem;

/// A small figure, 120 x 90 mm, with one annotation of every kind; 1 mm of the patient is 1 mm on paper.
Figure letteredFigure() {
    Figure figure;
    figure.title = "Thorax";
    figure.output = {120, 90, 127, false}; // five pixels to the mm
    figure.camera.heightMm = 90;
    const auto add = [&](const char* kind, const std::string& text) -> Annotation& {
        Annotation& annotation = figure.annotations.emplace_back();
        annotation.kind = kind;
        annotation.text = text;
        return annotation;
    };
    add("title", "");
    add("caption", "Seen from the front; σ<sup>2</sup> & <b>more</b>.");
    add("label", "Clavicle").anchorMm = glm::dvec3(-20, 0, 10);
    add("label", "Ligamentum <i>longum</i>").anchorMm = glm::dvec3(20, 0, 15);
    add("label", "Μυς α-β").anchorMm = glm::dvec3(15, 0, -10);
    add("scale-bar", "").lengthMm = 40;
    add("orientation", "");
    return figure;
}

RenderPlan planOf(const Figure& figure) {
    RenderPlan plan;
    plan.figure = std::make_shared<const Figure>(figure);
    plan.size = figure.output.sizePixels();
    return plan;
}

class Annotations : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("limner-annotations-" + std::to_string(::getpid()) + "-" +
                                               ::testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    ExportFacts write(const Figure& figure, const std::string& name, int tile = 0) {
        PictureOptions options = pictureOptions(figure);
        options.tile = tile;
        return exportPicture(planOf(figure), backend_, folder_ / name, options, task_);
    }
    [[nodiscard]] std::vector<float> pixels(const std::string& name) const {
        OIIO::ImageBuf image((folder_ / name).string());
        EXPECT_TRUE(image.read(0, 0, true, OIIO::TypeDesc::FLOAT)) << image.geterror();
        std::vector<float> out(static_cast<std::size_t>(image.spec().width * image.spec().height) *
                               static_cast<std::size_t>(image.nchannels()));
        image.get_pixels(image.roi(), OIIO::TypeDesc::FLOAT, out.data());
        return out;
    }
    [[nodiscard]] std::string bytesOf(const std::string& name) const {
        std::ifstream file(folder_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    fs::path folder_;
    GradientBackend backend_;
    Task task_;
};

TEST_F(Annotations, AreTheSameInTilesOfAnySize) {
    const Figure figure = letteredFigure();
    EXPECT_EQ(write(figure, "whole.exr").annotations, 7U);
    const std::vector<float> whole = pixels("whole.exr");
    Figure bare = figure;
    bare.annotations.clear();
    write(bare, "bare.exr");
    EXPECT_NE(pixels("bare.exr"), whole);
    for (const int tile : {7, 64, 133}) {
        write(figure, "tiled.exr", tile);
        EXPECT_EQ(pixels("tiled.exr"), whole) << tile;
    }
}

TEST_F(Annotations, CoverWhatTheirAreaIs) {
    Figure figure;
    figure.output = {100, 50, 254, false}; // ten pixels to the mm
    figure.camera.heightMm = 50;
    Annotation& bar = figure.annotations.emplace_back();
    bar.kind = "scale-bar";
    bar.lengthMm = 40;
    bar.at = {0.2, 0.5};
    const DrawnAnnotations drawn = drawAnnotations(figure, {glm::dvec3(1)});
    ASSERT_EQ(drawn.bars.size(), 1U);
    EXPECT_NEAR(drawn.bars[0].box.lowMm.x, 20, 1e-9) << "`at` is its left end";
    EXPECT_NEAR(drawn.bars[0].box.highMm.x, 60, 1e-9);
    const auto inkOf = [&](glm::ivec2 size) {
        Picture picture(size);
        layAnnotations(drawn, size, {{0, 0}, size}, picture);
        double ink = 0;
        for (std::size_t i = 3; i < picture.rgba().size(); i += 4) {
            ink += picture.rgba()[i];
        }
        return ink / size.x / size.y;
    };
    EXPECT_NEAR(inkOf({1000, 500}), inkOf({333, 177}), 2e-4) << "the same drawing at any size";
    const double barOnly = drawn.bars[0].box.sizeMm().x * drawn.bars[0].box.sizeMm().y / 5000;
    EXPECT_GT(inkOf({1000, 500}), barOnly);
}

TEST(AreaFill, IsExact) {
    const std::vector<glm::dvec2> triangle{{1, 1}, {5, 1}, {1, 4}};
    const std::size_t count = 3;
    const Coverage area = fillArea(triangle, {&count, 1}, 0, 10);
    double sum = 0;
    for (const float share : area.shares) {
        sum += share;
    }
    EXPECT_NEAR(sum, 6, 1e-5);
    EXPECT_EQ(area.origin, glm::ivec2(1, 1));
    EXPECT_FLOAT_EQ(area.shares[0], 1) << "the pixel in the right angle's corner";
    const std::vector<glm::dvec2> ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1, 3}, {3, 3}, {3, 1}};
    const std::size_t counts[] = {4, 4};
    const Coverage hole = fillArea(ring, counts, 0, 4);
    EXPECT_FLOAT_EQ(hole.shares[0], 1);
    EXPECT_FLOAT_EQ(hole.shares[static_cast<std::size_t>(hole.size.x) + 1], 0);
    const std::vector<glm::dvec2> square{{0.25, 0.5}, {0.75, 0.5}, {0.75, 1.5}, {0.25, 1.5}};
    const std::size_t four = 4;
    EXPECT_FLOAT_EQ(fillArea(square, {&four, 1}, 0, 1).shares[0], 0.25F);
}

TEST_F(Annotations, StandInSvgAsText) {
    const Figure figure = letteredFigure();
    write(figure, "figure.svg");
    struct Seen {
        std::string text, layer;
        std::string annotations; ///< what stands in that layer
    } seen;
    const XML_Parser parser = XML_ParserCreate(nullptr);
    XML_SetUserData(parser, &seen);
    XML_SetElementHandler(
        parser,
        [](void* data, const char* name, const char** attributes) {
            Seen& s = *static_cast<Seen*>(data);
            for (; *attributes != nullptr; attributes += 2) {
                if (std::string(attributes[0]) == "inkscape:label") {
                    s.layer = attributes[1];
                }
            }
            s.annotations += std::string(name) == "text" ? "\n" : "";
        },
        [](void*, const char*) {});
    XML_SetCharacterDataHandler(parser, [](void* data, const char* text, int length) {
        Seen& s = *static_cast<Seen*>(data);
        (s.layer == "Annotations" ? s.annotations : s.text).append(text, static_cast<std::size_t>(length));
    });
    const std::string bytes = bytesOf("figure.svg");
    EXPECT_EQ(XML_Parse(parser, bytes.data(), static_cast<int>(bytes.size()), 1), XML_STATUS_OK);
    XML_ParserFree(parser);
    for (const char* words :
         {"Thorax", "Seen from the front; σ2 & more.", "Clavicle", "Ligamentum longum", "Μυς α-β", "40\u00A0mm"}) {
        EXPECT_NE(seen.annotations.find(words), std::string::npos) << words << " in " << seen.annotations;
    }
    EXPECT_EQ(seen.text.find("Clavicle"), std::string::npos);
    EXPECT_EQ(
        std::system(
            ("rsvg-convert -o " + (folder_ / "svg.png").string() + " " + (folder_ / "figure.svg").string()).c_str()),
        0);
}

TEST_F(Annotations, StandInPdfAsText) {
    write(letteredFigure(), "figure.pdf");
    ASSERT_EQ(
        std::system(("pdftotext -layout " + (folder_ / "figure.pdf").string() + " " + (folder_ / "words.txt").string())
                        .c_str()),
        0);
    const std::string words = bytesOf("words.txt");
    for (const char* wanted : {"Thorax", "Seen from the front", "Clavicle", "Ligamentum longum", "Μυς α-β", "40 mm"}) {
        EXPECT_NE(words.find(wanted), std::string::npos) << wanted << " in " << words;
    }
    EXPECT_NE(bytesOf("figure.pdf").find("/OCG"), std::string::npos);
    ASSERT_EQ(std::system(
                  ("pdffonts " + (folder_ / "figure.pdf").string() + " > " + (folder_ / "fonts.txt").string()).c_str()),
              0);
    const std::string fonts = bytesOf("fonts.txt");
    EXPECT_NE(fonts.find("DejaVuSans"), std::string::npos) << fonts;
    EXPECT_NE(fonts.find("yes yes yes"), std::string::npos) << "embedded, a subset, with its letters: " << fonts;
}

TEST_F(Annotations, LookAlikeInPicturesAndPages) {
    Figure figure = letteredFigure();
    figure.background.rgba = {1, 1, 1, 1};
    write(figure, "figure.png");
    write(figure, "figure.pdf");
    ASSERT_EQ(std::system(("pdftoppm -r 127 -png -singlefile " + (folder_ / "figure.pdf").string() + " " +
                           (folder_ / "page").string())
                              .c_str()),
              0);
    const OIIO::ImageBuf picture((folder_ / "figure.png").string());
    const OIIO::ImageBuf page((folder_ / "page.png").string());
    ASSERT_EQ(picture.spec().width, page.spec().width);
    // Around the title, where the ground of both is the same gradient: the mean darkness is that of the same letters.
    const auto mean = [](const OIIO::ImageBuf& image) {
        double sum = 0;
        for (int y = 20; y < 55; ++y) {
            for (int x = 230; x < 370; ++x) {
                sum += image.getchannel(x, y, 0, 0);
            }
        }
        return sum / (35 * 140);
    };
    EXPECT_NEAR(mean(picture), mean(page), 0.02);
}

TEST(DrawnAnnotations, SayWhyOneIsNotThere) {
    Figure figure;
    Annotation& hidden = figure.annotations.emplace_back();
    hidden.text = "Behind";
    hidden.anchorMm = glm::dvec3(1000, 0, 0);
    figure.annotations.emplace_back().text = "Nowhere";
    figure.annotations.emplace_back().anchorMm = glm::dvec3(0);
    Annotation& bar = figure.annotations.emplace_back();
    bar.kind = "scale-bar";
    figure.camera.projection = Projection::perspective;
    const DrawnAnnotations drawn = drawAnnotations(figure, {});
    const std::vector<std::string> lines = describeAnnotations(figure, drawn);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0], "label \"Behind\": not drawn: its point is not in the picture");
    EXPECT_EQ(lines[1], "label \"Nowhere\": not drawn: it has neither a point nor a place");
    EXPECT_EQ(lines[2], "label: not drawn: it says nothing");
    EXPECT_EQ(lines[3], "scale-bar of 20\u00A0mm: true in the plane through the camera's target only: the view is a "
                        "perspective");
    EXPECT_EQ(drawn.count(), 1U);
}

TEST(DrawnAnnotations, TellWherePlacesAreSoThatTheyCanBeKept) {
    Figure figure = letteredFigure();
    const DrawnAnnotations before = drawAnnotations(figure, {});
    for (const AnnotationPlace& place : before.places) {
        figure.annotations[place.index].at = place.at;
    }
    const DrawnAnnotations after = drawAnnotations(figure, {});
    for (std::size_t i = 0; i < before.places.size(); ++i) {
        EXPECT_NEAR(glm::distance(before.places[i].box.lowMm, after.places[i].box.lowMm), 0, 1e-9) << i;
    }
}

TEST(DrawnAnnotations, TakeTheInkThatShowsOnThePaper) {
    Figure figure = letteredFigure();
    EXPECT_EQ(drawAnnotations(figure, {glm::dvec3(1)}).texts[0].rgb, InkColour(0));
    EXPECT_EQ(drawAnnotations(figure, {glm::dvec3(0.1)}).texts[0].rgb, InkColour(255));
    figure.annotations[0].rgb = glm::dvec3(1, 0, 0);
    EXPECT_EQ(drawAnnotations(figure, {glm::dvec3(1)}).texts[0].rgb, InkColour(255, 0, 0));
}

} // namespace
} // namespace limner
