#include "app/cli/style_extract_command.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "core/style/extraction/verdict.h"
#include "core/style/png_writing.h"
#include "core/style/slug.h"
#include "core/style/style_files.h"
#include "core/style/style_library.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>

namespace limner::cli {

namespace {

namespace fs = std::filesystem;

using Facts = nlohmann::ordered_json;

constexpr const char* kExamples = R"(Examples:
  limner style extract plate.tif --detect                        what is round and shaded on it
  limner style extract plate.tif --detect --pick 2 -o ball.png
  limner style extract plate.tif --circle 1210,860,140 --snap -o ball.png --name "Warm ochre"
                 --credit "E. Haeckel, 1904" --licence "public domain" --add
  limner style extract hip.jpg --region bone.png --marks bone.json -o bone-ink.png --difference off.png
  limner style extract --swatches light=#ffe8c8,shadow=#5a3020,rim=#c08060 --light -0.4,0.6 -o clay.png
)";

std::string today() {
    const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
    char text[32];
    std::snprintf(text, sizeof text, "%04d-%02u-%02u", int(date.year()), unsigned(date.month()), unsigned(date.day()));
    return text;
}

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

std::string thousandths(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

Facts ellipseFacts(const Ellipse& e) {
    return isCircle(e) ? Facts{e.centre.x, e.centre.y, e.semiAxes.x}
                       : Facts{e.centre.x, e.centre.y, e.semiAxes.x, e.semiAxes.y, e.degrees};
}

const char* ellipseKind(const Ellipse& e) { return isCircle(e) ? "circle" : "ellipse"; }

void writePicture(const std::string& file, const decltype(Extraction::difference)& picture) {
    if (!file.empty()) {
        writeWholeFile(file, pngBytes({picture.width, picture.height}, picture.pixels));
    }
}

/// To be edited and given back by --ignore.
void writeLettering(const std::string& file, const Artwork& artwork) {
    if (file.empty()) {
        return;
    }
    const auto& whole = artwork.reduced().picture;
    Mask mask = findLettering(artwork.reduced());
    if (mask.empty()) {
        mask = {whole.width, whole.height, std::vector<std::uint8_t>(whole.pixels.size())};
    }
    writeWholeFile(file, pngBytes({mask.width, mask.height}, mask.values));
}

} // namespace

void StyleExtractCommand::declare(CLI::App& app) {
    app.description(
        "Takes a style from a scanned artwork\n"
        "From a ball, an eye, a fruit: by its outline. From any shaded form: by a mask, with marks where\n"
        "its surface faces. Or from a few colours. Says how good it is: how much of the ball was seen, how\n"
        "well the region is explained by it, and how wide the widest gap is that was filled.");
    app.footer(kExamples);
    app.add_option("ART", art_, "The scan: TIFF, PNG, JPEG, PSD, EXR; grey, RGB or CMYK, with or without profile")
        ->option_text(" ");
    options_.declareForm(app);
    options_.declareLook(app);
    declareOutputs(app);
    card_.declare(app);
}

void StyleExtractCommand::declareOutputs(CLI::App& app) {
    app.add_option("-o,--output", out_, "The style: a picture (png); its card is written beside it")
        ->option_text("STYLE");
    app.add_flag("--add", add_, "Put it among your styles");
    app.add_option("--texture", texture_,
                   "Part light from texture, and write the texture as a tile that repeats; named STYLE-texture.png it "
                   "belongs to the style")
        ->option_text("TILE");
    app.add_option("--difference", difference_, "Write where the region is not explained: grey is no difference")
        ->option_text("FILE");
    app.add_option("--lettering", lettering_,
                   "Write a mask of the letters and lines found on the whole artwork, to be edited for --ignore")
        ->option_text("FILE");
}

void StyleExtractCommand::checkSense() const {
    const bool onlyLettering = !options_.hasForm() && !lettering_.empty() && !makesStyle();
    if (!onlyLettering) {
        options_.checkForm();
    }
    const auto refuse = [](const std::string& where, const std::string& why, const std::string& remedy) {
        throw Error(ErrorKind::usage, {"cannot take a style", where, why, remedy});
    };
    if (options_.hasSwatches()) {
        if (!art_.empty() || !texture_.empty() || !difference_.empty() || !lettering_.empty()) {
            refuse(art_, "swatches need no artwork and have neither texture nor difference",
                   "leave out either the artwork or --swatches");
        }
    } else if (art_.empty()) {
        refuse("", "there is no artwork", "name a scan, or colours by --swatches");
    }
    if (!makesStyle() && !options_.detects() && !onlyLettering) {
        refuse("", "nothing says where it is to go", "give -o STYLE.png, or --add for your own styles");
    }
    std::vector<std::string> inputs = options_.inputs();
    inputs.push_back(art_);
    checkOutputs({out_, texture_, difference_, lettering_}, inputs);
}

int StyleExtractCommand::run(Console& console) {
    checkSense();
    return options_.hasSwatches() ? mixSwatches(console) : extractFromArtwork(console);
}

Style StyleExtractCommand::styleOf(const SpherePtr& sphere, const std::string& source) const {
    Style style;
    style.sphere = sphere;
    style.card.name = nameFromFile(!out_.empty() ? out_ : (art_.empty() ? "swatches" : art_));
    style.card.origin = source + " (" + today() + ")";
    card_.applyTo(style.card);
    style.card.id = slugOf(style.card.name);
    return style;
}

void StyleExtractCommand::write(Style& style) const {
    if (!out_.empty()) {
        Style alone = style;
        alone.texture = nullptr; // its file was named apart
        writeStyle(alone, out_);
        style.file = out_;
    }
    if (add_) {
        style.card = StyleLibrary(StyleLibrary::userFolder()).add(style);
    }
}

int StyleExtractCommand::listProposals(const Artwork& artwork, Console& console) const {
    const std::vector<RoundThing> found = roundThings(artwork, console.task());
    if (console.json) {
        Facts list = Facts::array();
        for (const RoundThing& thing : found) {
            list.push_back({{ellipseKind(thing.ellipse), ellipseFacts(thing.ellipse)}, {"score", thing.score}});
        }
        printFacts(console, Facts{{"width", artwork.width()},
                                  {"height", artwork.height()},
                                  {"proposals", list},
                                  {"warnings", console.task().warnings()}});
        return 0;
    }
    std::vector<std::vector<std::string>> rows;
    for (const RoundThing& thing : found) {
        rows.push_back(
            {std::to_string(rows.size() + 1), ellipseWords(thing.ellipse), "score " + thousandths(thing.score)});
    }
    console.print(textTable(rows));
    console.say(found.empty() ? art_ + ": no round shaded thing found; --circle X,Y,R or --region MASK say where one is"
                              : "-o STYLE.png takes the first, --pick N another one");
    return 0;
}

int StyleExtractCommand::extractFromArtwork(Console& console) const {
    Task& task = console.task();
    const Artwork artwork(art_, task);
    if (!makesStyle()) {
        writeLettering(lettering_, artwork);
        return options_.detects() ? listProposals(artwork, console) : 0;
    }
    const PlacedForm form = options_.form(artwork, task);
    ExtractionRequest request = options_.request(artwork, form, task);
    request.separateTexture = !texture_.empty();
    const Extraction extraction = extractStyle(artwork, request, task);
    task.throwIfCancelled(); // before anything is written
    writeLettering(lettering_, artwork);
    writePicture(difference_, extraction.difference);
    if (extraction.texture != nullptr && !texture_.empty()) {
        writeWholeFile(texture_, pngBytes(*extraction.texture));
    } else if (!texture_.empty()) {
        task.warn("the form is too small for a texture; " + texture_ + " was not written");
    }
    for (const std::string& advice :
         verdictOf(extraction.figures, std::holds_alternative<FormRegion>(form.form)).advice) {
        task.warn(advice);
    }
    Style style = styleOf(extraction.sphere, fs::path(art_).filename().string() + ", " + form.words);
    style.texture = extraction.texture;
    write(style);
    report(console, style, form, extraction);
    return 0;
}

void StyleExtractCommand::report(Console& console, const Style& style, const PlacedForm& form,
                                 const Extraction& extraction) const {
    const ExtractionFigures& figures = extraction.figures;
    const Ellipse* ellipse = std::get_if<Ellipse>(&form.form);
    if (console.json) {
        Facts facts{{"coverage", figures.coverage},
                    {"residual_rmse", figures.residualRmse},
                    {"largest_hole_deg", figures.largestHoleDegrees}};
        facts[ellipse != nullptr ? ellipseKind(*ellipse) : "region"] =
            ellipse != nullptr ? ellipseFacts(*ellipse) : Facts(form.words.substr(form.words.find(' ') + 1));
        facts["form_rmse"] = figures.formRmse ? Facts(*figures.formRmse) : Facts(nullptr);
        facts["style"] = {{"id", style.card.id},
                          {"name", style.card.name},
                          {"file", out_.empty() ? Facts(nullptr) : Facts(out_)},
                          {"added", add_}};
        facts["warnings"] = console.task().warnings();
        printFacts(console, facts);
        return;
    }
    const std::string clause = verdictOf(figures, ellipse == nullptr).form;
    std::string text = factLine("taken from", form.words) +
                       factLine("coverage", percent(figures.coverage) + " of the ball was seen") +
                       factLine("residual", thousandths(figures.residualRmse) + " RMSE of the region shaded again") +
                       factLine("widest gap", numberText(std::round(figures.largestHoleDegrees)) + " degrees");
    if (figures.formRmse) {
        text +=
            factLine(ellipse != nullptr ? "placement" : "depth", thousandths(*figures.formRmse) + " RMSE: " + clause);
    }
    text += out_.empty() ? "" : factLine("style", out_);
    text += add_ ? factLine("added as", style.card.id) : "";
    console.print(text);
}

int StyleExtractCommand::mixSwatches(Console& console) const {
    Style style = styleOf(options_.mixed(), "swatches");
    write(style);
    if (console.json) {
        printFacts(console, Facts{{"style",
                                   {{"id", style.card.id},
                                    {"name", style.card.name},
                                    {"file", out_.empty() ? Facts(nullptr) : Facts(out_)},
                                    {"added", add_}}},
                                  {"warnings", console.task().warnings()}});
    }
    console.say((out_.empty() ? "" : out_ + ": a style of swatches") + (out_.empty() || !add_ ? "" : "; ") +
                (add_ ? "added as " + style.card.id : ""));
    return 0;
}

} // namespace limner::cli
