#include "core/base/error.h"
#include "core/figure/figure_json.h"
#include "core/figure/migration.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>
#include <sstream>

namespace limner {
namespace {

using Json = nlohmann::json;

std::string exampleText() {
    std::ifstream file(std::string(LIMNER_SOURCE_DIR) + "/tests/core/figure/example_figure.json");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Every key of `want` with an equal value in `have`; more keys are welcome.
void expectContains(const Json& want, const Json& have, const std::string& pointer) {
    if (want.is_object()) {
        ASSERT_TRUE(have.is_object()) << pointer;
        for (const auto& [key, value] : want.items()) {
            ASSERT_TRUE(have.contains(key)) << pointer << "/" << key;
            expectContains(value, have[key], pointer + "/" + key);
        }
    } else if (want.is_array()) {
        ASSERT_TRUE(have.is_array()) << pointer;
        ASSERT_EQ(want.size(), have.size()) << pointer;
        for (std::size_t i = 0; i < want.size(); ++i) {
            expectContains(want[i], have[i], pointer + "/" + std::to_string(i));
        }
    } else {
        EXPECT_EQ(want, have) << pointer;
    }
}

/// The one line of the error that reading gives; fails the test where there is none.
std::string readError(const std::string& text) {
    try {
        readFigure(text, "f.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        EXPECT_LT(std::string(error.what()).size(), 1000u);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << text.substr(0, 100);
    return "";
}

TEST(FigureJson, ReadsAndWritesEveryKeyOfTheSpecificationsExample) {
    std::vector<Problem> notes;
    const Figure figure = readFigure(exampleText(), "example", &notes);
    EXPECT_TRUE(notes.empty()) << notes.front().pointer;
    EXPECT_TRUE(figure.unknown.empty());
    ASSERT_EQ(figure.layers.size(), 2u);
    EXPECT_EQ(figure.layers[0].transfer.nodes.size(), 2u);
    ASSERT_TRUE(figure.layers[1].transfer.grid);
    EXPECT_EQ(figure.layers[1].transfer.grid->styles[1][0], "line");
    EXPECT_EQ(figure.labels->names.at("1"), "mandible");
    const std::string text = writeFigure(figure);
    expectContains(Json::parse(exampleText()), Json::parse(text), "");
    EXPECT_EQ(readFigure(text, "again"), figure);
    EXPECT_EQ(writeFigure(readFigure(text, "again")), text);
}

TEST(FigureJson, PlanesTexturesAndLabelColoursComeBackAsTheyWere) {
    Figure figure;
    figure.labels.emplace().colours = {{"1", "#ff0000"}, {"12", "#00ff7f"}};
    StyleEntry& style = figure.styles.emplace_back();
    style.id = "marble";
    style.file = "bundled:marble";
    style.role = "bone";
    style.texture = StyleTexture{"styles/veins.png", 12.5, 0.75, nullptr};
    Layer& layer = figure.layers.emplace_back();
    layer.contours.emplace().curvature = CurvatureEstimator::normals;
    layer.transfer.kind = TransferKind::twoDimensional;
    layer.transfer.axes = {"distance", "label"};
    layer.transfer.grid = TransferGrid{{0, 40}, {-1, 3}, {{"marble", "#102030"}, {"#ffffff", "marble"}}};
    layer.transfer.opacity = {{0, 1}, {40, 0.5}};
    layer.transfer.opacity2d = {{"mask", {0, 40}, {-1, 3}, 0.5, 0, 2, {0, 0.25, 1, 0.5}},
                                {"polygon", {0, 10, 5}, {-1, 3, 3}, 1, 0.125, 0, {}}};
    layer.transfer.distance = DistanceOrigin{glm::dvec3(1, -2, 3.5), 0};
    figure.layers.push_back(layer);
    figure.layers[1].transfer.distance = DistanceOrigin{std::nullopt, 4};
    figure.layers.emplace_back().transfer.axis = "curvature";
    figure.quality.interpolation = Interpolation::smooth;
    std::vector<Problem> notes;
    const std::string text = writeFigure(figure);
    EXPECT_EQ(readFigure(text, "", &notes), figure);
    EXPECT_TRUE(notes.empty()) << notes.front().pointer;
    const Json written = Json::parse(text);
    const Json& transfer = written["layers"][0]["transfer"];
    EXPECT_EQ(transfer["nodes"]["styles"][0][1], "#102030");
    EXPECT_EQ(transfer["opacity_2d"][0]["columns"], 2);
    EXPECT_EQ(transfer["opacity_2d"][0]["values"], Json::parse("[0, 0.25, 1, 0.5]"));
    EXPECT_FALSE(transfer["opacity_2d"][1].contains("columns"));
    EXPECT_EQ(transfer["distance"]["from_mm"], Json::parse("[1, -2, 3.5]"));
    EXPECT_EQ(written["layers"][1]["transfer"]["distance"]["label"], 4);
    EXPECT_EQ(written["layers"][2]["transfer"]["axis"], "curvature");
    EXPECT_EQ(written["styles"][0]["texture"]["size_mm"], 12.5);
    EXPECT_EQ(written["labels"]["colours"]["12"], "#00ff7f");
    EXPECT_NE(readError(R"({"limner": 1, "layers": [{"transfer": {"kind": "2d", "axes": ["value", "smell"]}}]})")
                  .find("/layers/0/transfer/axes/1"),
              std::string::npos);
}

TEST(FigureJson, KeysStandInTheDocumentsOrder) {
    const auto written = nlohmann::ordered_json::parse(writeFigure(readFigure(exampleText(), "")));
    const auto example = nlohmann::ordered_json::parse(exampleText());
    std::vector<std::string> want;
    std::vector<std::string> have;
    for (const auto& item : example.items()) {
        want.push_back(item.key());
    }
    for (const auto& item : written.items()) {
        have.push_back(item.key());
    }
    EXPECT_EQ(want, have);
}

TEST(FigureJson, EmptyObjectsMeanDefaults) {
    const Figure figure = readFigure(R"({"limner": 1, "stipple": {}, "camera": {}, "layers": [{"contours": {}}]})", "");
    EXPECT_EQ(figure.stipple, Stipple{});
    EXPECT_EQ(figure.camera, Camera{});
    ASSERT_EQ(figure.layers.size(), 1u);
    EXPECT_EQ(figure.layers[0].contours, Contours{});
    EXPECT_EQ(readFigure(R"({"limner": 1})", ""), Figure{});
    EXPECT_EQ(readFigure(writeFigure(Figure{}), ""), Figure{});
}

TEST(FigureJson, UnknownMembersSurvive) {
    Json document = Json::parse(exampleText());
    document["limner"] = 1.2;
    document["future"] = {{"deep", {1, 2.5, nullptr, "x"}}};
    document["camera"]["roll_deg"] = 12;
    document["layers"][1]["fur"] = {{"length_mm", 3}};
    document["layers"][0]["contours"]["wob/ble~"] = true;
    std::vector<Problem> notes;
    const Figure figure = readFigure(document.dump(), "", &notes);
    EXPECT_EQ(notes.size(), 4u);
    for (const Problem& note : notes) {
        EXPECT_FALSE(note.fatal);
    }
    expectContains(document, Json::parse(writeFigure(figure)), "");
    EXPECT_EQ(readFigure(writeFigure(figure), ""), figure);

    Figure without = figure;
    without.layers[0].contours.reset();
    const Json written = Json::parse(writeFigure(without));
    EXPECT_TRUE(written["layers"][0]["contours"].is_null());
    EXPECT_EQ(written["layers"][1]["fur"]["length_mm"], 3);
}

TEST(FigureJson, SuggestsTheNearestKey) {
    std::vector<Problem> notes;
    readFigure(R"({"limner": 1, "camera": {"hieght_mm": 3}})", "", &notes);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].pointer, "/camera/hieght_mm");
    EXPECT_NE(notes[0].mend.find("height_mm"), std::string::npos);
}

TEST(FigureJson, NewerMajorVersionsAreRefused) {
    EXPECT_NE(readError(R"({"limner": 2})").find("newer Limner"), std::string::npos);
    EXPECT_NE(readError(R"({"limner": 1e300})").find("newer Limner"), std::string::npos);
    EXPECT_NE(readError(R"({"limner": "one"})").find("/limner"), std::string::npos);
    EXPECT_NE(readError(R"({"limner": -1})").find("/limner"), std::string::npos);
}

TEST(FigureJson, OlderVersionsAreMigrated) {
    std::vector<Problem> notes;
    const Figure draft = readFigure(R"({"title": "Draft"})", "", &notes);
    EXPECT_EQ(draft.title, "Draft");
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].pointer, "/limner");
    EXPECT_EQ(readFigure(R"({"limner": 0, "title": "Draft"})", "").title, "Draft");

    const MigrationStep steps[] = {{3, [](const std::string& text) { return text + "b"; }},
                                   {2, [](const std::string& text) { return text + "a"; }}};
    EXPECT_EQ(migrated("x", 2, 4, steps), "xab");
    EXPECT_EQ(migrated("x", 4, 4, steps), "x");
    EXPECT_THROW(migrated("x", 1, 4, steps), Error);
}

TEST(FigureJson, WrongTypesAndRangesNameTheirPlace) {
    const std::pair<const char*, const char*> cases[] = {
        {R"({"limner": 1, "title": 3})", "/title"},
        {R"({"limner": 1, "camera": []})", "/camera"},
        {R"({"limner": 1, "camera": {"height_mm": 0}})", "/camera/height_mm"},
        {R"({"limner": 1, "camera": {"height_mm": "240"}})", "/camera/height_mm"},
        {R"({"limner": 1, "camera": {"height_mm": null}})", "/camera/height_mm"},
        {R"({"limner": 1, "camera": {"projection": "fisheye"}})", "/camera/projection"},
        {R"({"limner": 1, "camera": {"up": [0, 1]}})", "/camera/up"},
        {R"({"limner": 1, "camera": {"up": [0, 1, "z"]}})", "/camera/up/2"},
        {R"({"limner": 1, "clip": {"box_mm": [[0, 0, 0]]}})", "/clip/box_mm"},
        {R"({"limner": 1, "layers": {}})", "/layers"},
        {R"({"limner": 1, "layers": [{}, {"opacity": 1.5}]})", "/layers/1/opacity"},
        {R"({"limner": 1, "layers": [{"labels": [1, 2.5]}]})", "/layers/0/labels/1"},
        {R"({"limner": 1, "layers": [{"labels": [1e12]}]})", "/layers/0/labels/0"},
        {R"({"limner": 1, "layers": [{"transfer": {"nodes": 7}}]})", "/layers/0/transfer/nodes"},
        {R"({"limner": 1, "labels": {"names": {"1": 2}}})", "/labels/names/1"},
        {R"({"limner": 1, "output": {"transparent": "yes"}})", "/output/transparent"},
        {R"({"limner": 1, "title": "a\u0000b"})", "/title"},
    };
    for (const auto& [text, pointer] : cases) {
        const std::string line = readError(text);
        EXPECT_NE(line.find(std::string("f.json ") + pointer + ":"), std::string::npos) << line;
        const std::vector<Problem> problems = validateText(text);
        ASSERT_FALSE(problems.empty());
        EXPECT_EQ(problems[0].pointer, pointer);
        EXPECT_TRUE(problems[0].fatal);
        EXPECT_FALSE(problems[0].mend.empty());
    }
}

TEST(FigureJson, AllProblemsAreListed) {
    const auto problems = validateText(R"({"limner": 1, "title": 3, "camera": {"height_mm": -1, "colour": 2}})");
    ASSERT_EQ(problems.size(), 3u);
    EXPECT_EQ(problems[1].pointer, "/camera/height_mm");
    EXPECT_FALSE(problems[2].fatal);
}

TEST(FigureJson, HostileTextsGiveOneLine) {
    const std::string many(2000000, '[');
    EXPECT_NE(readError(many).find("nested"), std::string::npos);
    std::string objects;
    for (int i = 0; i < 100000; ++i) {
        objects += "{\"a\":";
    }
    EXPECT_NE(readError(objects).find("nested"), std::string::npos);
    EXPECT_NE(readError(R"({"limner": 1, "title": "a", "title": "b"})").find("/title"), std::string::npos);
    EXPECT_NE(readError(R"({"limner": 1, "camera": {"up": 1, "up": 2}})").find("/camera/up"), std::string::npos);
    EXPECT_NE(readError(R"({"limner": 1, "camera": {"height_mm": 1e999}})").find("too large"), std::string::npos);
    readError(R"({"limner": 1, "camera": {"height_mm": NaN}})");
    readError(R"({"limner": 1, "camera": {"height_mm": Infinity}})");
    readError("");
    readError("[1, 2]");
    readError("\"figure\"");
    readError("null");
    readError("{\"limner\": 1");
    readError("{\"limner\": 1, \"title\": \"\xff\xfe\"}");
    readError(std::string("{\"limner\": 1}\0", 14));
    readError("{\"limner\": 1, \"title\": \"" + std::string(100000, 'x') + "\"}");
    EXPECT_NE(readError(std::string(100 << 20, ' ')).find("16 MiB"), std::string::npos);

    std::string long_list = "{\"limner\": 1, \"layers\": [{}";
    for (int i = 0; i < 70000; ++i) {
        long_list += ",{}";
    }
    EXPECT_NE(readError(long_list + "]}").find("/layers"), std::string::npos);
    std::string numbers = "{\"limner\": 1, \"x\": [0";
    for (int i = 0; i < 1100000; ++i) {
        numbers += ",0";
    }
    EXPECT_NE(readError(numbers + "]}").find("million"), std::string::npos);
    std::string keys = "{\"limner\": 1, \"k\": 1";
    for (int i = 0; i < 50000; ++i) {
        keys += ",\"k" + std::to_string(i) + "\": 1";
    }
    EXPECT_EQ(readFigure(keys + "}", "").unknown.size(), 50001u);
}

TEST(FigureJson, NumbersThatAreNotFiniteAreNotWritten) {
    Figure figure;
    figure.layers.emplace_back().transfer.opacity = {{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 1}};
    try {
        writeFigure(figure);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.text().where, "/layers/0/transfer/opacity/1/0");
    }
}

TEST(FigureJson, NumbersAreExact) {
    Figure figure;
    figure.camera.heightMm = 0.1 + 0.2;
    figure.camera.targetMm = {-0.0, 1e-300, 123456789.123456789};
    const Figure again = readFigure(writeFigure(figure), "");
    EXPECT_EQ(again, figure);
    EXPECT_TRUE(std::signbit(again.camera.targetMm.x));
}

} // namespace
} // namespace limner
