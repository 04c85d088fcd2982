#include "app/cli/style_commands.h"

#include "app/cli/console.h"
#include "app/cli/facts.h"
#include "core/figure/description.h"
#include "core/style/ball_picture.h"
#include "core/style/extraction/extract.h"
#include "core/style/find_style.h"
#include "core/style/png_writing.h"
#include "core/style/style_files.h"
#include "core/style/style_library.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace limner::cli {

namespace {

namespace fs = std::filesystem;

using Facts = nlohmann::ordered_json;

constexpr const char* kBundledPrefix = "bundled:";

StyleLibrary userStyles() { return StyleLibrary(StyleLibrary::userFolder()); }

Facts cardFacts(const StyleCard& card, const char* section) {
    return {{"id", card.id},         {"name", card.name},     {"section", section},     {"tags", card.tags},
            {"origin", card.origin}, {"credit", card.credit}, {"licence", card.licence}};
}

/// A style with its card as it is, any other picture as a ball whose ground is to be removed.
Style readForAdding(const std::string& file, const CardOptions& options, Task& task) {
    std::error_code ignored;
    Style style;
    if (fs::exists(cardFileOf(file), ignored)) {
        style = loadWholeStyle(file);
    } else {
        style.sphere = importMatcap(file, task);
        style.card.name = nameFromFile(file);
        style.card.origin = fs::path(file).filename().string();
    }
    if (options.hasName()) {
        style.card.id.clear(); // of the name
    }
    options.applyTo(style.card);
    return style;
}

/// Whether the file is the texture of a style beside it, as all files of a folder may be given.
bool isTextureOfAnother(const fs::path& file) {
    constexpr std::string_view kEnding = "-texture";
    const std::string stem = file.stem().string();
    if (stem.size() <= kEnding.size() || !stem.ends_with(kEnding)) {
        return false;
    }
    const fs::path owner = file.parent_path() / (stem.substr(0, stem.size() - kEnding.size()) + ".png");
    std::error_code ignored;
    return fs::exists(owner, ignored) && fs::exists(cardFileOf(owner), ignored) &&
           !fs::exists(cardFileOf(file), ignored);
}

/// The style and where it is from. Throws Error(usage), with the nearest id, where there is none.
Style styleNamed(const std::string& word, const StyleLibrary& mine) {
    if (std::optional<Style> style = findStyle(word, mine)) {
        return std::move(*style);
    }
    if (word.find('/') != std::string::npos || fs::path(word).has_extension()) {
        throw Error(ErrorKind::badInput, {"cannot read the style", word, "no such file", "check the path"});
    }
    const std::string nearest = description::nearestWord(word, knownStyleIds(mine));
    throw Error(ErrorKind::usage,
                {"cannot find the style", word.substr(0, 60), "there is none with this id",
                 nearest.empty() ? "`limner style list` shows them" : "did you mean " + nearest + "?"});
}

const char* sectionOf(const Style& style, const StyleLibrary& mine) {
    std::error_code ignored;
    if (style.file.starts_with(kBundledPrefix)) {
        return "bundled";
    }
    return fs::equivalent(fs::path(style.file).parent_path(), mine.folder(), ignored) ? "mine" : "file";
}

} // namespace

void StyleAddCommand::declare(CLI::App& app) {
    app.description(
        "Adds pictures of shaded balls to your styles\n"
        "A style that Limner wrote comes with its card and texture. Of any other picture (a matcap, a photo\n"
        "of a ball) the disk is found and the ground behind it removed. A name that is taken gets a number.\n"
        "Your styles lie in ~/.local/share/limner/styles, or where LIMNER_STYLES says.");
    app.footer("Examples:\n  limner style add ball.png\n"
               "  limner style add clay.exr --name \"Red clay\" --tags clay,warm --credit \"A. Painter\" "
               "--licence \"CC BY 4.0\"\n"
               "  limner style add matcaps/*.png --credit \"The matcap's makers\"\n");
    app.add_option("FILE", files_, "Pictures: PNG, EXR, JPEG, TIFF, WebP")->required()->option_text("...");
    card_.declare(app);
}

int StyleAddCommand::run(Console& console) {
    if (files_.size() > 1 && card_.hasName()) {
        throw Error(ErrorKind::usage, {"cannot name several styles alike", "--name",
                                       std::to_string(files_.size()) + " pictures were given", "add them one by one"});
    }
    const StyleLibrary mine = userStyles();
    Facts added = Facts::array();
    std::vector<Error> failures;
    for (const std::string& file : files_) {
        if (files_.size() > 1 && isTextureOfAnother(file)) {
            continue; // it comes with its style
        }
        try {
            const StyleCard card = mine.add(readForAdding(file, card_, console.task()));
            added.push_back({{"file", file}, {"id", card.id}, {"name", card.name}});
            console.say(file + ": added as " + card.id + " (" + card.name + ")");
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::badInput || files_.size() == 1) {
                throw;
            }
            console.task().warn(error.what());
            failures.push_back(error);
        }
    }
    if (!failures.empty()) {
        throw Error(ErrorKind::badInput, {"not all pictures were added", failures.front().text().where,
                                          std::to_string(failures.size()) + " of " + std::to_string(files_.size()) +
                                              " cannot be used: " + failures.front().text().why,
                                          failures.front().text().remedy});
    }
    if (console.json) {
        printFacts(
            console,
            Facts{{"folder", mine.folder().string()}, {"styles", added}, {"warnings", console.task().warnings()}});
    }
    return 0;
}

void StyleShowCommand::declare(CLI::App& app) {
    app.description("Shows what is known of a style, and its ball\n"
                    "One of yours or a bundled one by its id (bundled:ID where both have it), or a style's picture.");
    app.footer("Examples:\n  limner style show ivory-bone\n  limner style show ivory-bone -o ivory.png --size 256\n"
               "  limner style show ball.png --json\n");
    app.add_option("STYLE", style_, "Id, or the picture of a style")->required()->option_text("ID-or-FILE");
    app.add_option("-o,--output", out_, "A picture of the ball, opaque on a clear ground (png)")->option_text("BALL");
    app.add_option("--size", size_, "Edge of that picture in pixels [512]")
        ->option_text("N")
        ->check(CLI::Range(16, 8192).description(""));
}

int StyleShowCommand::run(Console& console) {
    const StyleLibrary mine = userStyles();
    checkOutputs({out_}, {style_});
    const Style style = styleNamed(style_, mine);
    const StyleCard& card = style.card;
    const char* section = sectionOf(style, mine);
    const bool seeThrough = style.sphere->hasDirectionalOpacity();
    if (!out_.empty()) {
        writeWholeFile(out_, pngBytes({size_, size_}, ballPicture(*style.sphere, size_)));
    }
    if (console.json) {
        Facts facts = cardFacts(card, section);
        facts["file"] = style.file;
        facts["size"] = style.sphere->size();
        facts["see_through"] = seeThrough;
        facts["texture"] = style.texture == nullptr ? Facts(nullptr) : Facts(style.texture->size());
        facts["ball"] = out_.empty() ? Facts(nullptr) : Facts(out_);
        printFacts(console, facts);
        return 0;
    }
    const std::string edge = std::to_string(style.sphere->size());
    console.print(factLine("id", card.id) + factLine("name", card.name) + factLine("from", section) +
                  factLine("file", style.file) + factLine("picture", edge + " x " + edge + " pixels") +
                  factLine("see-through", seeThrough ? "in some directions" : "no"));
    const std::pair<const char*, std::string> texts[] = {
        {"texture", style.texture == nullptr ? "" : std::to_string(style.texture->size()) + " pixels, repeating"},
        {"tags", joined(card.tags)},
        {"origin", card.origin},
        {"credit", card.credit},
        {"licence", card.licence}};
    for (const auto& [label, text] : texts) {
        console.print(text.empty() ? "" : factLine(label, text));
    }
    console.print(out_.empty() ? "" : factLine("ball", out_));
    return 0;
}

void StyleListCommand::declare(CLI::App& app) {
    app.description("Lists the lit-sphere styles\n"
                    "Your own and the bundled ones: id, name and what they suit. The id is what a figure's nodes refer "
                    "to.");
    app.footer("Examples:\n  limner style list\n  limner style list --mine\n  limner style list --bundled --json\n");
    app.add_flag("--mine", mine_, "Only your own");
    app.add_flag("--bundled", bundled_, "Only those that come with Limner");
}

int StyleListCommand::run(Console& console) {
    const bool all = mine_ == bundled_;
    StyleLibrary::Listing own;
    if (all || mine_) {
        own = userStyles().list();
    }
    std::vector<std::vector<std::string>> rows;
    Facts list = Facts::array();
    const auto show = [&](const std::vector<StyleCard>& cards, const char* section) {
        for (const StyleCard& card : cards) {
            rows.push_back({card.id, card.name, joined(card.tags)});
            if (all && !own.cards.empty()) {
                rows.back().insert(rows.back().begin() + 2, section);
            }
            list.push_back(cardFacts(card, section));
        }
    };
    show(own.cards, "mine");
    if (all || bundled_) {
        show(bundledStyleCards(), "bundled");
    }
    for (const std::string& problem : own.problems) {
        console.task().warn(problem);
    }
    if (console.json) {
        printFacts(console, Facts{{"styles", list}, {"warnings", console.task().warnings()}});
    } else {
        console.print(textTable(rows));
    }
    if (rows.empty()) {
        console.say("You have no styles of your own yet: `limner style extract` and `limner style add` make them.");
    }
    return 0;
}

void StyleRemoveCommand::declare(CLI::App& app) {
    app.description("Puts styles of yours aside\n"
                    "Figures that use them keep them. The last twenty can be brought back by --restore.");
    app.footer("Examples:\n  limner style remove red-clay\n  limner style remove red-clay --restore\n");
    app.add_option("ID", ids_, "Ids of your styles; `limner style list --mine` shows them")
        ->required()
        ->option_text("...");
    app.add_flag("--restore", restore_, "Bring them back");
}

int StyleRemoveCommand::run(Console& console) {
    const StyleLibrary mine = userStyles();
    Facts done = Facts::array();
    for (const std::string& id : ids_) {
        if (restore_) {
            const StyleCard card = mine.restore(id);
            done.push_back(card.id);
            console.say(id + ": brought back" + (card.id == id ? "" : " as " + card.id));
            continue;
        }
        std::error_code ignored;
        const bool isBundled = findStyle(kBundledPrefix + id, mine) || id.starts_with(kBundledPrefix);
        if (isBundled && !fs::exists(mine.folder() / (id + ".png"), ignored)) {
            throw Error(ErrorKind::usage,
                        {"cannot remove the style", id, "it comes with Limner", "only your own can be removed"});
        }
        mine.remove(id);
        done.push_back(id);
        console.say(id + ": removed; `limner style remove " + id + " --restore` brings it back");
    }
    if (console.json) {
        printFacts(console, Facts{{restore_ ? "restored" : "removed", done}});
    }
    return 0;
}

} // namespace limner::cli
