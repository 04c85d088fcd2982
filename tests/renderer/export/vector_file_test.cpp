#include "renderer/export/vector_file.h"

#include "core/base/error.h"
#include "gradient_backend.h"
#include "renderer/marks/lay_marks.h"
#include "renderer/marks/mark_field.h"
#include "support/mark_crowd.h"
#include "support/small_disk.h"

#include <gtest/gtest.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <expat.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>

#include <unistd.h>

namespace limner {
namespace {

using namespace testing;

/// An element of an XML file, with the elements around it.
struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;
    int parent = -1;
};

struct Xml {
    std::vector<Element> elements;
    std::vector<int> open;

    [[nodiscard]] std::vector<const Element*> all(const std::string& name) const {
        std::vector<const Element*> found;
        for (const Element& element : elements)
            if (element.name == name)
                found.push_back(&element);
        return found;
    }
    /// Labels of Inkscape's layers, the lowest first.
    [[nodiscard]] std::vector<std::string> layers() const {
        std::vector<std::string> labels;
        for (const Element* group : all("g"))
            if (group->attributes.contains("inkscape:groupmode"))
                labels.push_back(group->attributes.at("inkscape:label"));
        return labels;
    }
    /// Of the layer that an element lies in.
    [[nodiscard]] std::string layerOf(const Element& element) const {
        for (int at = element.parent; at >= 0; at = elements[static_cast<std::size_t>(at)].parent) {
            const auto& attributes = elements[static_cast<std::size_t>(at)].attributes;
            if (attributes.contains("inkscape:label"))
                return attributes.at("inkscape:label");
        }
        return "";
    }
};

std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Xml parsed(const std::filesystem::path& path) {
    Xml xml;
    const XML_Parser parser = XML_ParserCreate(nullptr);
    XML_SetUserData(parser, &xml);
    XML_SetElementHandler(
        parser,
        [](void* data, const char* name, const char** attributes) {
            Xml& x = *static_cast<Xml*>(data);
            Element element{name, {}, "", x.open.empty() ? -1 : x.open.back()};
            for (; *attributes != nullptr; attributes += 2)
                element.attributes[attributes[0]] = attributes[1];
            x.open.push_back(static_cast<int>(x.elements.size()));
            x.elements.push_back(std::move(element));
        },
        [](void* data, const char*) { static_cast<Xml*>(data)->open.pop_back(); });
    XML_SetCharacterDataHandler(parser, [](void* data, const char* text, int length) {
        Xml& x = *static_cast<Xml*>(data);
        x.elements[static_cast<std::size_t>(x.open.back())].text.append(text, static_cast<std::size_t>(length));
    });
    const std::string bytes = bytesOf(path);
    EXPECT_EQ(XML_Parse(parser, bytes.data(), static_cast<int>(bytes.size()), 1), XML_STATUS_OK)
        << XML_ErrorString(XML_GetErrorCode(parser)) << " in line " << XML_GetCurrentLineNumber(parser);
    XML_ParserFree(parser);
    return xml;
}

/// A figure of marks, 60 x 45 mm at 254 dpi: ten pixels to the mm.
class VectorFileTest : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            std::filesystem::temp_directory_path() / ("limner-vector-" + std::to_string(::getpid()) + "-" +
                                                      ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        auto figure = std::make_shared<Figure>();
        figure->title = "Ribs & <sternum> \xC3\xBC";
        figure->output.widthMm = 60;
        figure->output.heightMm = 45;
        figure->output.dpi = 254;
        plan_.figure = figure;
        plan_.size = {600, 450};
        setLayersDrawn(false);
        options_.dpi = 254;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void setLayersDrawn(bool drawn) {
        auto marks = std::make_shared<PlanMarks>();
        marks->layersDrawn = drawn;
        plan_.marks = marks;
    }

    ExportFacts write(const Marks& marks, const std::string& name) {
        PendingFile file(folder_ / name);
        const ExportFacts facts =
            writeVectorMarks(marks, plan_, backend_, options_, *vectorFormatOf(name), file, task_);
        file.commit();
        return facts;
    }

    /// The picture that the raster formats get, as an image of three channels.
    [[nodiscard]] OIIO::ImageBuf raster(const Marks& marks) {
        Picture picture(plan_.size);
        if (plan_.marks->layersDrawn)
            picture = backend_.render(plan_, {{0, 0}, plan_.size}, task_).picture;
        layMarks(marks, plan_.size, {{0, 0}, plan_.size}, picture);
        const std::vector<std::byte> png = encodePng(picture, options_);
        std::ofstream(folder_ / "raster.png", std::ios::binary)
            .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
        return load("raster.png");
    }
    [[nodiscard]] OIIO::ImageBuf load(const std::string& name) const {
        OIIO::ImageBuf image((folder_ / name).string());
        EXPECT_TRUE(image.read(0, 0, true, OIIO::TypeDesc::FLOAT)) << name << ": " << image.geterror();
        return OIIO::ImageBufAlgo::channels(image, 3, {0, 1, 2});
    }

    /// Has another program turn a vector file into pixels, and compares with the raster output.
    [[nodiscard]] double differenceOf(const Marks& marks, const std::string& ending) {
        write(marks, "figure." + ending);
        const std::string in = (folder_ / ("figure." + ending)).string();
        const std::string out = (folder_ / "other").string();
        const std::string size = std::to_string(plan_.size.x) + " ";
        const std::string command = ending == "svg"
                                        ? "rsvg-convert --unlimited -w " + size + "-h " + std::to_string(plan_.size.y) +
                                              " -o '" + out + ".png' '" + in + "'"
                                        : "pdftocairo -png -singlefile -scale-to-x " + size + "-scale-to-y " +
                                              std::to_string(plan_.size.y) + " '" + in + "' '" + out + "'";
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
        return OIIO::ImageBufAlgo::compare(raster(marks), load("other.png"), 0, 0).rms_error;
    }

    std::filesystem::path folder_;
    RenderPlan plan_;
    PictureOptions options_;
    GradientBackend backend_;
    Task task_;
};

/// Figures as one draws them: many small dots, lines, lines of changing width.
Marks drawing(int dots, int strokes, int colours) {
    Marks marks = crowd(dots, strokes, colours, 60, 5);
    marks.paperMm = {60, 45};
    marks.groups[0].name = "Stipples - Bone";
    marks.groups[1].name = "Lines";
    for (MarkGroup& group : marks.groups) {
        for (Dot& dot : group.dots)
            dot.radiusMm = 0.08F + 0.05F * dot.radiusMm;
        for (StrokePoint& point : group.points)
            point.widthMm = 0.05F + 0.2F * point.widthMm;
    }
    return marks;
}

bool has(const char* program) {
    return std::system((std::string("command -v ") + program + " >/dev/null").c_str()) == 0;
}

TEST_F(VectorFileTest, SvgHasALayerForEveryGroupAndMillimetres) {
    const Marks marks = drawing(300, 40, 3);
    const ExportFacts facts = write(marks, "a.svg");
    EXPECT_FALSE(facts.layersEmbedded);
    EXPECT_EQ(backend_.calls, 0);
    const Xml xml = parsed(folder_ / "a.svg");
    const Element& root = xml.elements.front();
    EXPECT_EQ(root.name, "svg");
    EXPECT_EQ(root.attributes.at("width"), "60mm");
    EXPECT_EQ(root.attributes.at("height"), "45mm");
    EXPECT_EQ(root.attributes.at("viewBox"), "0 0 60 45");
    EXPECT_EQ(xml.all("title").at(0)->text, plan_.figure->title);
    EXPECT_EQ(xml.layers(), (std::vector<std::string>{"Paper", "Stipples - Bone", "Lines"}));
    const auto circles = xml.all("circle");
    const auto paths = xml.all("path");
    EXPECT_EQ(circles.size(), facts.dots);
    EXPECT_EQ(paths.size(), facts.strokes);
    EXPECT_GT(circles.size(), 100U);
    EXPECT_GT(paths.size(), 10U);
    for (const auto* circle : circles) {
        const std::string layer = xml.layerOf(*circle);
        EXPECT_TRUE(layer == "Lines" || layer == "Stipples - Bone") << layer;
        EXPECT_LT(std::stod(circle->attributes.at("cx")), 61);
        EXPECT_LT(std::stod(circle->attributes.at("r")), 0.3);
    }
    EXPECT_EQ(xml.layerOf(*xml.all("rect").at(0)), "Paper");
    EXPECT_TRUE(xml.all("image").empty());
}

TEST_F(VectorFileTest, LinesOfOneWidthStayLines) {
    Marks marks = paper(60);
    marks.paperMm.y = 45;
    addStroke(marks.groups[0], {{{10, 10}, 0.3F}, {{20, 10.5F}, 0.3F}, {{20, 9.9994F}, 0.3F}}, 0.5F, {255, 0, 128});
    addStroke(marks.groups[0], {{{10, 10}, 0.3F}, {{20, 10}, 0.1F}});
    write(marks, "a.svg");
    const Xml xml = parsed(folder_ / "a.svg");
    const auto paths = xml.all("path");
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_EQ(paths[0]->attributes.at("d"), "M10 10l10 .5 0-.501");
    EXPECT_EQ(paths[0]->attributes.at("stroke-opacity"), ".5");
    const Element& run = xml.elements.at(static_cast<std::size_t>(paths[0]->parent));
    EXPECT_EQ(run.attributes.at("stroke"), "#ff0080");
    EXPECT_EQ(run.attributes.at("stroke-width"), ".3");
    EXPECT_EQ(run.attributes.at("stroke-linecap"), "round");
    EXPECT_EQ(paths[1]->attributes.at("d").back(), 'Z');
    EXPECT_NE(paths[1]->attributes.at("d").find('A'), std::string::npos) << "no round end";
}

TEST_F(VectorFileTest, LayersAreOnePictureAtTheirPlaceInTheOrder) {
    setLayersDrawn(true);
    Marks marks = drawing(100, 10, 1);
    for (const MarkOrder order : {MarkOrder::underLayers, MarkOrder::overLayers}) {
        marks.order = order;
        for (const char* name : {"a.svg", "a.pdf"}) {
            const ExportFacts facts = write(marks, name);
            EXPECT_TRUE(facts.layersEmbedded);
            EXPECT_EQ(facts.samples, 600U * 450U);
        }
        const Xml xml = parsed(folder_ / "a.svg");
        const auto expected = order == MarkOrder::underLayers
                                  ? std::vector<std::string>{"Paper", "Stipples - Bone", "Lines", "Layers"}
                                  : std::vector<std::string>{"Paper", "Layers", "Stipples - Bone", "Lines"};
        EXPECT_EQ(xml.layers(), expected);
        ASSERT_EQ(xml.all("image").size(), 1U);
        EXPECT_EQ(xml.layerOf(*xml.all("image")[0]), "Layers");
    }
}

TEST_F(VectorFileTest, TransparentHasNoPaper) {
    options_.transparent = true;
    write(drawing(10, 2, 1), "a.svg");
    EXPECT_EQ(parsed(folder_ / "a.svg").layers(), (std::vector<std::string>{"Stipples - Bone", "Lines"}));
}

TEST_F(VectorFileTest, OtherProgramsDrawWhatTheRasterShows) {
    if (!has("rsvg-convert") || !has("pdftocairo"))
        GTEST_SKIP() << "librsvg2-bin or poppler-utils is not installed";
    const struct {
        const char* what;
        Marks marks;
        bool layers;
        MarkOrder order;
    } cases[] = {{"black", drawing(3000, 100, 1), false, MarkOrder::underLayers},
                 {"colours", drawing(3000, 100, 4), false, MarkOrder::underLayers},
                 {"under", drawing(2000, 100, 2), true, MarkOrder::underLayers},
                 {"over", drawing(2000, 100, 2), true, MarkOrder::overLayers}};
    options_.background = {0.95, 0.9, 0.8, 1};
    for (const auto& c : cases) {
        setLayersDrawn(c.layers);
        Marks marks = c.marks;
        marks.order = c.order;
        for (const char* ending : {"svg", "pdf"}) {
            const double difference = differenceOf(marks, ending);
            std::cout << "  " << c.what << ' ' << ending << ": RMSE " << difference << '\n';
            EXPECT_LE(difference, 0.01) << c.what << ' ' << ending;
        }
    }
}

TEST_F(VectorFileTest, ADifferenceWouldBeSeen) {
    if (!has("rsvg-convert"))
        GTEST_SKIP() << "librsvg2-bin is not installed";
    const Marks marks = drawing(3000, 100, 1);
    Marks moved = marks;
    for (MarkGroup& group : moved.groups)
        for (Dot& dot : group.dots)
            dot.placeMm.x += 0.05F; // half a pixel
    static_cast<void>(differenceOf(marks, "svg"));
    EXPECT_GT(OIIO::ImageBufAlgo::compare(raster(moved), load("other.png"), 0, 0).rms_error, 0.02);
}

TEST_F(VectorFileTest, AHundredThousandDotsAreSmallAndQuick) {
    Marks marks = drawing(240'000, 0, 1); // more than half of them lie beside the paper
    for (const char* name : {"a.svg", "a.pdf"}) {
        const auto start = std::chrono::steady_clock::now();
        const ExportFacts facts = write(marks, name);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const auto bytes = std::filesystem::file_size(folder_ / name);
        std::cout << "  " << name << ": " << facts.dots << " dots, " << bytes << " bytes, " << seconds << " s\n";
        const double share = static_cast<double>(facts.dots) / 100'000;
        EXPECT_GT(share, 1);
        EXPECT_LT(static_cast<double>(bytes) / share, 15e6);
    }
}

TEST_F(VectorFileTest, PdfNamesItsLayersAndIsAsLargeAsThePaper) {
    write(drawing(10, 2, 1), "a.pdf");
    const std::string pdf = bytesOf(folder_ / "a.pdf");
    EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
    EXPECT_NE(pdf.find("/MediaBox [0 0 170.078740 127.559055]"), std::string::npos);
    EXPECT_NE(pdf.find("/Type /OCG /Name <FEFF00530074006900700070006C006500730020002D00200042006F006E0065>"),
              std::string::npos);
    EXPECT_NE(pdf.find("/Title <FEFF0052006900620073002000260020003C0073007400650072006E0075006D003E002000FC>"),
              std::string::npos);
    // Every object lies where the table says.
    const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref") + 10));
    EXPECT_EQ(pdf.substr(table, 4), "xref");
    const int count = std::stoi(pdf.substr(table + 7));
    const std::size_t first = pdf.find('\n', table + 5) + 1;
    for (int i = 1; i < count; ++i) {
        const std::size_t offset = std::stoul(pdf.substr(first + static_cast<std::size_t>(i) * 20, 10));
        const std::string head = std::to_string(i) + " 0 obj";
        EXPECT_EQ(pdf.substr(offset, head.size()), head);
    }
}

TEST_F(VectorFileTest, WhatIsNotFiniteOrOffThePaperIsNotWritten) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Marks marks = paper(60);
    marks.paperMm.y = 45;
    MarkGroup& group = marks.groups[0];
    for (const float bad : {kNan, kInfinity, -kInfinity, 1e30F, 500.0F, -500.0F}) {
        group.dots.push_back({{bad, 32}, 0, 1, 1, {0, 0, 0}});
        group.dots.push_back({{32, bad}, 0, 1, 1, {9, 0, 0}});
        addStroke(group, {{{bad, 3}, 1}, {{bad, 30}, 1}});
    }
    for (const float bad : {kNan, kInfinity, -1.0F, 0.0F}) {
        group.dots.push_back({{32, 32}, 0, bad, 1, {0, 0, 0}});
        group.dots.push_back({{32, 32}, bad == 0 ? kNan : 0, 1, bad == kInfinity ? 0 : bad, {0, 0, 0}});
        addStroke(group, {{{3, 3}, bad}, {{30, 30}, bad}});
    }
    group.strokes.push_back({1000, 5, 1, {0, 0, 0}});
    for (const char* name : {"a.svg", "a.pdf"}) {
        const ExportFacts facts = write(marks, name);
        EXPECT_EQ(facts.dots, 0U);
        EXPECT_EQ(facts.strokes, 0U);
    }
    EXPECT_EQ(bytesOf(folder_ / "a.svg").find("nan"), std::string::npos);
}

TEST_F(VectorFileTest, AFullDiskLeavesTheOldFileAndSaysWhy) {
    const Marks marks = drawing(20'000, 100, 1);
    for (const rlim_t bytes : {rlim_t{1000}, rlim_t{100'000}})
        for (const char* name : {"a.svg", "a.pdf"}) {
            std::ofstream(folder_ / name) << "old";
            std::optional<Error> error;
            {
                const SmallDisk disk(bytes);
                try {
                    write(marks, name);
                } catch (const Error& e) {
                    error = e;
                }
            }
            ASSERT_TRUE(error.has_value()) << name << ' ' << bytes;
            EXPECT_EQ(error->kind(), ErrorKind::noResources);
            EXPECT_NE(std::string(error->what()).find("File too large"), std::string::npos) << error->what();
            EXPECT_EQ(bytesOf(folder_ / name), "old");
            std::filesystem::remove(folder_ / name);
            EXPECT_TRUE(std::filesystem::is_empty(folder_));
        }
}

TEST_F(VectorFileTest, CancellingLeavesNothing) {
    setLayersDrawn(true);
    backend_.afterTile = [&](Picture&) { task_.cancel(); };
    options_.tile = 64;
    EXPECT_THROW(write(drawing(100, 0, 1), "a.pdf"), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(VectorFileTest, DepthAndMissingFoldersAreRefusedAtOnce) {
    const auto kindOf = [&](const std::filesystem::path& path) {
        try {
            checkExport(path, plan_.size, options_);
        } catch (const Error& error) {
            return error.kind();
        }
        return ErrorKind::cancelled;
    };
    EXPECT_EQ(kindOf(folder_ / "a.SVG"), ErrorKind::cancelled);
    EXPECT_EQ(kindOf(folder_ / "none" / "a.svg"), ErrorKind::usage);
    EXPECT_EQ(kindOf("/dev/null.pdf/a.pdf"), ErrorKind::usage);
    options_.depth = SampleDepth::sixteen;
    EXPECT_EQ(kindOf(folder_ / "a.svg"), ErrorKind::usage);
    EXPECT_EQ(kindOf(folder_ / "a.pdf"), ErrorKind::usage);
}

} // namespace
} // namespace limner
