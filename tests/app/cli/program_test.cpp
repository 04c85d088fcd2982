#include "program_run.h"

#include "core/base/process.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>

namespace limner {
namespace {

using testing::ProgramRun;
using testing::run;
using testing::WithScan;

int lines(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

/// One line for people, and with --json one object with all parts.
void expectError(std::vector<std::string> arguments, int code, const std::string& hint = "") {
    std::string command;
    for (const std::string& argument : arguments) {
        command += argument + " ";
    }
    SCOPED_TRACE(command);
    const ProgramRun plain = run(arguments);
    EXPECT_EQ(plain.code, code) << plain.err;
    EXPECT_EQ(plain.out, "");
    std::istringstream stream(plain.err);
    int errors = 0;
    for (std::string line; std::getline(stream, line);) {
        errors += line.rfind("limner: ", 0) == 0 ? 1 : 0;
        EXPECT_TRUE(line.rfind("limner: ", 0) == 0 || line.rfind("note: ", 0) == 0) << line;
    }
    EXPECT_EQ(errors, 1) << plain.err;
    EXPECT_NE(plain.err.find(hint), std::string::npos) << plain.err;
    EXPECT_LT(plain.err.size(), 2000U);

    arguments.emplace_back("--json");
    const ProgramRun json = run(arguments);
    EXPECT_EQ(json.code, code);
    EXPECT_EQ(json.out, "");
    ASSERT_EQ(lines(json.err), 1) << json.err;
    const auto object = nlohmann::json::parse(json.err).at("error");
    EXPECT_EQ(object.at("exit_code"), code);
    for (const char* key : {"what", "where", "why", "remedy"}) {
        EXPECT_TRUE(object.at(key).is_string()) << key;
    }
}

// ---- help

TEST(Program, HelpOfEveryCommandHasExamplesAndEndsWell) {
    const std::vector<std::vector<std::string>> commands{{},
                                                         {"render"},
                                                         {"new"},
                                                         {"info"},
                                                         {"validate"},
                                                         {"explain"},
                                                         {"self-test"},
                                                         {"style", "extract"},
                                                         {"style", "add"},
                                                         {"style", "show"},
                                                         {"style", "list"},
                                                         {"style", "remove"},
                                                         {"theme", "list"},
                                                         {"preset", "list"},
                                                         {"figure", "list"}};
    for (auto arguments : commands) {
        arguments.emplace_back("--help");
        const ProgramRun help = run(arguments);
        EXPECT_EQ(help.code, 0);
        EXPECT_EQ(help.err, "");
        EXPECT_NE(help.out.find("Examples:"), std::string::npos) << help.out;
        EXPECT_NE(help.out.find("limner"), std::string::npos);
    }
    EXPECT_EQ(run({"--version"}).out.rfind("limner ", 0), 0U);
}

// ---- wrong usage

TEST(Program, WrongUsageEndsWith2AndNamesTheNearest) {
    expectError({}, 2, "limner --help");
    expectError({"rendr", "x"}, 2, "did you mean render?");
    expectError({"style", "lst"}, 2, "did you mean list?");
    expectError({"render", "a.nrrd", "-o", "b.png", "--widht-mm", "3"}, 2, "did you mean --width-mm?");
    expectError({"render", "a.nrrd"}, 2, "--output");
    expectError({"render", "-o", "b.png"}, 2, "FIGURE-or-VOLUME");
    expectError({"render", "a.nrrd", "-o", "b.png", "--preset", "skul"}, 2, "did you mean skull?");
    expectError({"render", "a.nrrd", "-o", "b.png", "--theme", "grey"}, 2, "gray");
    expectError({"render", "a.nrrd", "-o", "b.png", "--figure", "contours-evn"}, 2, "did you mean contours-even?");
    expectError({"render", "a.nrrd", "-o", "b.png", "--figure", "contours-even", "--preset", "skull"}, 2, "--preset");
    expectError({"render", "a.nrrd", "-o", "b.png", "--view", "top"}, 2, "superior");
    expectError({"render", "a.nrrd", "-o", "b.png", "--depth", "12"}, 2, "float");
    expectError({"render", "a.nrrd", "-o", "b.png", "--background", "#12"}, 2, "#rrggbb");
    expectError({"render", "a.nrrd", "-o", "b.gif"}, 2, "png");
    expectError({"render", "a.nrrd", "-o", "/no/such/folder/b.png"}, 2, "folder");
    expectError({"new", "a.nrrd", "-o", "b.zip"}, 2, ".limner");
}

TEST(Program, HostileSizesAreRefusedBeforeAnythingIsRead) {
    for (const char* size :
         {"0x0", "0x100", "-5x10", "1e9x1e9", "99999999999x2", "nanxnan", "100", "x", "", "10x10x10"}) {
        expectError({"render", "none.nrrd", "-o", "b.png", std::string("--size=") + size}, 2);
    }
    expectError({"render", "none.nrrd", "-o", "b.png", "--size", "1000000001x5"}, 2, "1000000");
    for (const char* option : {"--width-mm", "--height-mm", "--dpi"}) {
        for (const char* value : {"0", "-1", "nan", "inf", "-inf", "1e300", "many"}) {
            expectError({"render", "none.nrrd", "-o", "b.png", std::string(option) + "=" + value}, 2);
        }
    }
    for (const char* value : {"0", "-3", "1e9", "x"}) {
        expectError({"render", "none.nrrd", "-o", "b.png", std::string("--threads=") + value}, 2);
        expectError({"render", "none.nrrd", "-o", "b.png", std::string("--tile=") + value}, 2);
    }
    for (const char* value : {"0", "-4G", "4X", "nan", "1e400"}) {
        expectError({"render", "none.nrrd", "-o", "b.png", std::string("--memory=") + value}, 2);
    }
    expectError({"render", "none.nrrd", "-o", "b.png", "--size", "10x10", "--width-mm", "3"}, 2, "both");
}

// ---- other exit codes

TEST_F(WithScan, EveryOtherFailureHasItsCode) {
    expectError({"render", path("none.nrrd"), "-o", path("b.png")}, 3, "none.nrrd");
    std::ofstream(path("bad.nrrd")) << "no header at all";
    expectError({"render", path("bad.nrrd"), "-o", path("b.png")}, 3, "bad.nrrd");
    expectError({"info", path("bad.nrrd")}, 3, "bad.nrrd");
    std::ofstream(path("bad.json")) << "{ \"limner\": 1, ";
    expectError({"explain", path("bad.json")}, 3, "bad.json");
    expectError({"render", scan(), "-o", path("b.png"), "--background", path("bad.json")}, 3, "bad.json");
    expectError({"render", scan(), "-o", path("b.png"), "--gl", "vulkan"}, 2, "vulkan");
    expectError({"render", scan(), "-o", path("b.png"), "--memory", "20K"}, 5);
    expectError({"render", scan(), "-o", path("b.png"), "--set", "/camra/height_mm=5"}, 2, "camera");
    expectError({"render", scan(), "-o", path("b.png"), "--set", "nonsense"}, 2);
    expectError({"render", scan(), "-o", path("b.png"), "--size", "64x64", "--set", "/camera/direction=[0,0,0]"}, 2);
    EXPECT_EQ(filesLeft(), 3U);
}

// ---- the commands

TEST_F(WithScan, RenderWritesThePictureAndItsFacts) {
    const ProgramRun r = run({"render", scan(), "-o", path("out.png"), "--size", "96x64", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.err, "");
    const auto facts = r.facts();
    EXPECT_EQ(facts.at("width"), 96);
    EXPECT_EQ(facts.at("height"), 64);
    EXPECT_EQ(facts.at("backend"), "cpu");
    EXPECT_GT(facts.at("seconds").get<double>(), 0);
    EXPECT_GT(facts.at("samples").get<std::uint64_t>(), 1000U);
    EXPECT_GT(facts.at("peak_bytes").get<std::uint64_t>(), 1U << 20);
    EXPECT_TRUE(facts.at("warnings").is_array());
    auto in = OIIO::ImageInput::open(path("out.png"));
    ASSERT_NE(in, nullptr);
    EXPECT_EQ(in->spec().width, 96);
    std::vector<std::uint8_t> pixels(96 * 64 * 3);
    ASSERT_TRUE(in->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data()));
    EXPECT_LT(*std::min_element(pixels.begin(), pixels.end()), 200) << "there is no head in the picture";
    EXPECT_EQ(pixels[0], 255) << "the paper is not white";
}

TEST_F(WithScan, InkIsDrawnInSvgAndPdf) {
    const std::string ink = R"(/stipple={"boundary":{},"layer_opacity":"under"})";
    for (const std::string name : {"o.svg", "o.pdf", "o.png"}) {
        const ProgramRun r = run({"render", scan(), "-o", path(name), "--size", "64x64", "--set", ink, "--json"});
        ASSERT_EQ(r.code, 0) << r.err;
        EXPECT_GT(r.facts().at("dots").get<int>(), 10);
        EXPECT_EQ(r.facts().at("strokes"), 0);
        EXPECT_EQ(r.facts().at("layers_embedded"), name != "o.png");
        const ProgramRun said = run({"render", scan(), "-o", path(name), "--size", "64x64", "--set", ink});
        EXPECT_NE((said.out + said.err).find(" dots"), std::string::npos) << said.out << said.err;
        EXPECT_EQ((said.out + said.err).find("embedded as one picture") != std::string::npos, name != "o.png");
    }
    const ProgramRun none = run({"render", scan(), "-o", path("o.png"), "--size", "64x64"});
    EXPECT_EQ((none.out + none.err).find(" dots"), std::string::npos);
    const ProgramRun deep = run({"render", scan(), "-o", path("deep.svg"), "--depth", "16"});
    EXPECT_EQ(deep.code, 2);
    EXPECT_EQ(std::count(deep.err.begin(), deep.err.end(), '\n'), 1) << deep.err;
    EXPECT_FALSE(exists("deep.svg"));
    EXPECT_EQ(run({"render", scan(), "-o", path("none/o.pdf")}).code, 2);
}

TEST_F(WithScan, SizesInMillimetresMakePixelsAndDpi) {
    const ProgramRun r = run({"render", scan(), "-o", path("o.tif"), "--width-mm", "25.4", "--dpi", "100", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.facts().at("width"), 100);
    EXPECT_EQ(r.facts().at("height"), 100);
    auto in = OIIO::ImageInput::open(path("o.tif"));
    ASSERT_NE(in, nullptr);
    EXPECT_EQ(in->spec().get_float_attribute("XResolution"), 100);
}

std::vector<float> pixelsOf(const std::string& path) {
    auto in = OIIO::ImageInput::open(path);
    EXPECT_NE(in, nullptr) << path;
    if (in == nullptr) {
        return {};
    }
    std::vector<float> pixels(in->spec().image_pixels() * static_cast<std::size_t>(in->spec().nchannels));
    EXPECT_TRUE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, pixels.data()));
    return pixels;
}

TEST_F(WithScan, TilesAndThreadsAndKeepingEverythingChangeNoPixel) {
    const auto render = [&](const std::string& name, std::vector<std::string> more) {
        std::vector<std::string> arguments{"render", scan(), "-o", path(name), "--size", "150x130", "--depth", "16"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramRun r = run(arguments);
        EXPECT_EQ(r.code, 0) << r.err;
        return pixelsOf(path(name));
    };
    const auto whole = render("a.png", {});
    EXPECT_EQ(whole, render("b.png", {"--tile", "33"}));
    EXPECT_EQ(whole, render("c.png", {"--threads", "1"}));
    const std::vector<std::string> toTheEnd{"--set", "/quality/early_termination=0"};
    const auto far = render("d.png", toTheEnd);
    const auto kept = render("e.png", {"--no-omit"}); // rays go to the end as well
    ASSERT_EQ(kept.size(), far.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        ASSERT_NEAR(kept[i], far[i], 2.0 / 65535) << i;
        ASSERT_NEAR(kept[i], whole[i], 0.001 + 2.0 / 65535) << i; // the default's early termination
    }
}

TEST_F(WithScan, OptionsChangeThePicture) {
    const auto render = [&](const std::string& name, std::vector<std::string> more) {
        std::vector<std::string> arguments{"render", scan(), "-o", path(name), "--size", "64x64"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramRun r = run(arguments);
        EXPECT_EQ(r.code, 0) << r.err;
        return pixelsOf(path(name));
    };
    const auto plain = render("a.png", {});
    EXPECT_NE(plain, render("view.png", {"--view", "left"}));
    EXPECT_NE(plain, render("preset.png", {"--preset", "skull"}));
    EXPECT_NE(plain, render("set.png", {"--set", "/camera/height_mm=90"}));
    const auto blue = render("blue.png", {"--background", "#0000ff"});
    EXPECT_EQ(blue[0], 0);
    EXPECT_EQ(blue[2], 1);
    const auto picture = render("picture.png", {"--background", path("blue.png")});
    EXPECT_EQ(picture[0], 0);
    EXPECT_EQ(picture[2], 1);
    EXPECT_NE(picture, blue); // the head stands behind the head
    EXPECT_EQ(picture, render("picture set.png",
                              {"--set", "/background/kind=image", "--set", "/background/file=" + path("blue.png")}));
    const auto board = render("board.png", {"--theme", "blackboard"});
    EXPECT_NEAR(board[1], 0x30 / 255.0, 1e-3);
    EXPECT_NE(board, render("board blue.png", {"--theme", "blackboard", "--preset", "skull"}));
    const auto clear = render("clear.png", {"--transparent"});
    ASSERT_EQ(clear.size(), plain.size() / 3 * 4);
    EXPECT_EQ(clear[3], 0);
}

TEST_F(WithScan, InfoKeepsItsNames) {
    const ProgramRun r = run({"info", scan(), "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto f = r.facts();
    EXPECT_EQ(f.at("dims"), nlohmann::json({48, 48, 48}));
    EXPECT_EQ(f.at("spacing_mm").size(), 3U);
    EXPECT_EQ(f.at("origin_mm").size(), 3U);
    EXPECT_EQ(f.at("direction"), nlohmann::json({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}));
    EXPECT_EQ(f.at("type"), "int16");
    EXPECT_EQ(f.at("range").size(), 2U);
    EXPECT_EQ(f.at("non_finite"), 0);
    EXPECT_EQ(f.at("sha256_values").get<std::string>().size(), 64U);
    for (const char* key : {"format", "warnings", "modality", "unit", "histogram_peaks", "size_mm"}) {
        EXPECT_TRUE(f.contains(key)) << key;
    }
    const ProgramRun text = run({"info", scan()});
    EXPECT_NE(text.out.find("48 x 48 x 48"), std::string::npos) << text.out;
}

TEST_F(WithScan, ExplainKeepsItsNames) {
    const ProgramRun r = run({"explain", scan(), "--size", "200x200", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto f = r.facts();
    EXPECT_FALSE(f.at("features_used").empty());
    EXPECT_FALSE(f.at("features_left_out").empty());
    EXPECT_FALSE(f.at("fields").empty());
    EXPECT_GT(f.at("bytes").at("total").get<std::uint64_t>(), 48U * 48U * 48U * 2U);
    EXPECT_GT(f.at("milliseconds").at("measured").at("rendering").get<double>(), 0);
    EXPECT_GT(f.at("milliseconds").at("estimated").at("total").get<double>(), 0);
}

TEST_F(WithScan, ExplainMeasuresWhatIsSaved) {
    const ProgramRun r = run({"explain", scan(), "--size", "64x64", "--savings", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto f = r.facts();
    const auto saved = f.at("savings");
    ASSERT_EQ(saved.at("rules").size(), f.at("features_left_out").size());
    double sum = 0;
    for (std::size_t i = 0; i < saved.at("rules").size(); ++i) {
        const auto& rule = saved.at("rules")[i];
        EXPECT_EQ(rule.at("name"), f.at("features_left_out")[i]);
        EXPECT_FALSE(rule.at("condition").get<std::string>().empty());
        sum += rule.at("milliseconds").get<double>();
    }
    EXPECT_NEAR(saved.at("sum").at("milliseconds").get<double>(), sum, 1e-6);
    EXPECT_GT(saved.at("without_any").at("milliseconds").get<double>(), 0);
    for (const auto& name : f.at("features_not_asked")) {
        EXPECT_EQ(std::count(f.at("features_left_out").begin(), f.at("features_left_out").end(), name), 0) << name;
    }
    const ProgramRun text = run({"explain", scan(), "--size", "64x64", "--savings"});
    EXPECT_NE(text.out.find("all at once"), std::string::npos) << text.out;
    EXPECT_FALSE(run({"explain", scan(), "--size", "64x64", "--json"}).facts().contains("savings"));
}

TEST_F(WithScan, AnnotationsAreDrawnAndExplained) {
    const std::string written = R"(/annotations=[{"kind": "scale-bar", "length_mm": 20}, {"text": "Nowhere"}])";
    const ProgramRun r = run({"explain", scan(), "--size", "64x64", "--json", "--set", written});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto lines = r.facts().at("annotations");
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0], "scale-bar of 20\u00A0mm");
    EXPECT_EQ(lines[1], "label \"Nowhere\": not drawn: it has neither a point nor a place");
    const ProgramRun picture =
        run({"render", scan(), "-o", path("bar.png"), "--size", "64x64", "--json", "--set", written});
    ASSERT_EQ(picture.code, 0) << picture.err;
    EXPECT_EQ(picture.facts().at("annotations"), 1);
}

TEST_F(WithScan, ExplainsWhatIsSeen) {
    const ProgramRun r = run({"explain", scan(), "--size", "64x64", "--visibility", "--json", "--set",
                              "/importance={\"global\": 1, \"weights\": {\"extinction\": 1}}"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto seen = r.facts().at("visibility");
    const std::size_t weights = seen.at("global_weights").size();
    EXPECT_EQ(weights, 5U);
    std::vector<double> sums(weights, 0.0);
    for (const auto& part : seen.at("parts")) {
        ASSERT_EQ(part.at("shares").size(), weights);
        for (std::size_t k = 0; k < weights; ++k) {
            const std::string kind = part.at("kind");
            sums[k] += kind == "layer" || kind == "paper" ? part.at("shares")[k].get<double>() : 0;
        }
    }
    for (const double sum : sums) {
        EXPECT_NEAR(sum, 1, 1e-9);
    }
    const ProgramRun text = run({"explain", scan(), "--size", "64x64", "--visibility"});
    EXPECT_NE(text.out.find("paper"), std::string::npos) << text.out;
}

TEST_F(WithScan, AProjectIsMadeShownCheckedAndRendered) {
    const ProgramRun made = run({"new", scan(), "-o", path("head.limner"), "--preset", "skull", "--json"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_TRUE(made.facts().at("warnings").is_array());

    const ProgramRun info = run({"info", path("head.limner"), "--json"});
    ASSERT_EQ(info.code, 0) << info.err;
    EXPECT_FALSE(info.facts().at("layers").empty());
    EXPECT_TRUE(info.facts().at("volume").at("found"));

    const ProgramRun valid = run({"validate", path("head.limner"), "--json"});
    ASSERT_EQ(valid.code, 0) << valid.out;
    EXPECT_TRUE(valid.facts().at("valid"));

    ASSERT_EQ(run({"render", path("head.limner"), "-o", path("a.png"), "--size", "80x80"}).code, 0);
    ASSERT_EQ(run({"render", scan(), "--preset", "skull", "-o", path("b.png"), "--size", "80x80"}).code, 0);
    EXPECT_EQ(pixelsOf(path("a.png")), pixelsOf(path("b.png"))) << "the project draws another picture than its preset";
}

TEST_F(WithScan, ValidateNamesThePointerAndTheMend) {
    std::ofstream(path("f.json")) << R"({"limner": 1, "camera": {"height_mm": -5}, "colour": 3})";
    const ProgramRun r = run({"validate", path("f.json"), "--json"});
    EXPECT_EQ(r.code, 3);
    const auto f = r.facts();
    EXPECT_FALSE(f.at("valid"));
    std::vector<std::string> pointers;
    for (const auto& problem : f.at("problems")) {
        pointers.push_back(problem.at("pointer"));
        EXPECT_TRUE(problem.contains("why"));
        EXPECT_TRUE(problem.contains("mend"));
    }
    EXPECT_NE(std::find(pointers.begin(), pointers.end(), "/camera/height_mm"), pointers.end());
    EXPECT_NE(std::find(pointers.begin(), pointers.end(), "/colour"), pointers.end());
    EXPECT_NE(run({"validate", path("f.json")}).out.find("/camera/height_mm"), std::string::npos);
}

TEST_F(WithScan, QuietSaysNothing) {
    const ProgramRun r = run({"render", scan(), "-o", path("a.png"), "--size", "32x32", "--quiet"});
    EXPECT_EQ(r.code, 0);
    EXPECT_EQ(r.out, "");
    EXPECT_EQ(r.err, "");
}

TEST(Program, ListsHaveWhatIsThere) {
    const auto styles = run({"style", "list", "--json"}).facts().at("styles");
    EXPECT_GE(styles.size(), 20U);
    const auto presets = run({"preset", "list", "--json"}).facts().at("presets");
    EXPECT_GE(presets.size(), 9U);
    EXPECT_EQ(presets.at(0).at("id"), "auto");
    const auto themes = run({"theme", "list", "--json"}).facts().at("themes");
    EXPECT_GE(themes.size(), 7U);
    for (const char* key : {"id", "name", "help"}) {
        EXPECT_FALSE(themes.at(0).at(key).get<std::string>().empty()) << key;
    }
    EXPECT_EQ(static_cast<std::size_t>(lines(run({"theme", "list"}).out)), themes.size());
    const auto figures = run({"figure", "list", "--json"}).facts().at("figures");
    EXPECT_GE(figures.size(), 12U);
    for (const char* key : {"id", "title", "scan"}) {
        EXPECT_FALSE(figures.at(0).at(key).get<std::string>().empty()) << key;
    }
    EXPECT_EQ(static_cast<std::size_t>(lines(run({"figure", "list"}).out)), figures.size());
    const ProgramRun text = run({"style", "list"});
    EXPECT_EQ(static_cast<std::size_t>(lines(text.out)), styles.size());
}

} // namespace
} // namespace limner
