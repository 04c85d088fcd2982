#include "app/cli/program.h"

#include "app/cli/accuracy_command.h"
#include "app/cli/console.h"
#include "app/cli/doctor_command.h"
#include "app/cli/explain_command.h"
#include "app/cli/help_formatter.h"
#include "app/cli/info_command.h"
#include "app/cli/interrupt.h"
#include "app/cli/list_commands.h"
#include "app/cli/new_command.h"
#include "app/cli/render_command.h"
#include "app/cli/self_test_command.h"
#include "app/cli/style_commands.h"
#include "app/cli/style_extract_command.h"
#include "app/cli/thumbnail_command.h"
#include "app/cli/validate_command.h"
#include "core/base/error.h"
#include "core/figure/description.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <new>
#include <ostream>

namespace limner::cli {

namespace {

constexpr const char* kAbout = R"(Limner makes print-ready illustrations from CT, MRI and other scanned volumes.)";

constexpr const char* kFooter = R"(Examples:
  limner render head.nii.gz -o head.png          a scan becomes a picture, nothing else needed
  limner new head.nii.gz -o head.limner          a project, to be changed in limner-studio
  limner info dicom-folder                       what the scan is

`limner COMMAND --help` shows the options of a command, with examples.
Lengths are in mm, angles in degrees, colours sRGB from 0 to 1, values in the scan's own unit.
Exit codes: 0 done, 2 wrong usage, 3 bad input file, 4 no OpenGL, 5 out of memory or disk,
            6 drawn, but not to the tolerance, 7 the accuracy reference is not good enough,
            8 pixels that are not finite numbers, 9 a formula or an order failed, 130 cancelled.
)";

/// The parser with all commands, and which of them was asked for.
class Parser {
  public:
    explicit Parser(Console& console) : console_(console), app_(kAbout, "limner") {
        app_.footer(kFooter);
        app_.set_version_flag("--version", "limner " LIMNER_VERSION, "Show the version");
        app_.set_help_flag("-h,--help", "Show this help");
        app_.require_subcommand(1);
        app_.formatter(makeHelpFormatter());
        add(app_, "render", std::make_unique<RenderCommand>());
        add(app_, "new", std::make_unique<NewCommand>());
        add(app_, "thumbnail", std::make_unique<ThumbnailCommand>());
        add(app_, "info", std::make_unique<InfoCommand>());
        add(app_, "validate", std::make_unique<ValidateCommand>());
        add(app_, "explain", std::make_unique<ExplainCommand>());
        add(app_, "accuracy", std::make_unique<AccuracyCommand>());
        add(app_, "self-test", std::make_unique<SelfTestCommand>());
        add(app_, "doctor", std::make_unique<DoctorCommand>());
        CLI::App& style = *group("style", "Extracts, adds, shows, lists and removes lit-sphere styles");
        add(style, "extract", std::make_unique<StyleExtractCommand>());
        add(style, "add", std::make_unique<StyleAddCommand>());
        add(style, "show", std::make_unique<StyleShowCommand>());
        add(style, "list", std::make_unique<StyleListCommand>());
        add(style, "remove", std::make_unique<StyleRemoveCommand>());
        add(*group("theme", "Lists the themes (theme list)"), "list", std::make_unique<ThemeListCommand>());
        add(*group("figure", "Lists the sample figures (figure list)"), "list", std::make_unique<FigureListCommand>());
        add(*group("preset", "Lists the presets (preset list)"), "list", std::make_unique<PresetListCommand>());
    }

    /// Throws CLI::Error.
    void parse(std::vector<std::string> arguments) {
        std::reverse(arguments.begin(), arguments.end()); // the parser takes them from the back
        app_.parse(arguments);
    }

    int run() {
        for (const Entry& entry : entries_) {
            if (entry.parser->parsed()) {
                return entry.command->run(console_);
            }
        }
        return static_cast<int>(ErrorKind::usage); // not reached: the parser asks for a command
    }

    /// What --help shows where the parser stopped.
    [[nodiscard]] std::string help() const { return app_.help(); }

    [[nodiscard]] Error usageError(const CLI::ParseError& error) const {
        const CLI::App& app = *asked();
        ErrorText text{"wrong usage", "", error.what(), "see `" + fullName(app) + " --help`"};
        const std::vector<std::string> strange = app_.remaining(true);
        if (!strange.empty()) {
            text.why = "\"" + strange.front().substr(0, 60) + "\" is not known here";
            const std::string nearest = description::nearestWord(strange.front(), knownWords(app));
            if (!nearest.empty()) {
                text.remedy = "did you mean " + nearest + "?";
            }
        }
        return {ErrorKind::usage, text};
    }

  private:
    struct Entry {
        CLI::App* parser;
        std::unique_ptr<Command> command;
    };

    CLI::App* group(const std::string& name, const std::string& help) {
        CLI::App* app = app_.add_subcommand(name, help)->group("Commands");
        app->require_subcommand(1);
        return app;
    }

    void add(CLI::App& parent, const std::string& name, std::unique_ptr<Command> command) {
        CLI::App* app = parent.add_subcommand(name)->group("Commands");
        command->declare(*app);
        app->add_flag("--quiet", console_.quiet, "Only errors: no progress, no notes");
        app->add_flag("--json", console_.json,
                      "Facts as one JSON object on standard output, errors as one on "
                      "standard error");
        entries_.push_back({app, std::move(command)});
    }

    /// The deepest command that was named.
    [[nodiscard]] const CLI::App* asked() const {
        const CLI::App* app = &app_;
        while (!app->get_subcommands().empty()) {
            app = app->get_subcommands().front();
        }
        return app;
    }

    static std::string fullName(const CLI::App& app) {
        return (app.get_parent() == nullptr ? "" : fullName(*app.get_parent()) + " ") + app.get_name();
    }

    /// Options and commands that may stand here.
    static std::vector<std::string> knownWords(const CLI::App& app) {
        std::vector<std::string> words;
        for (const CLI::Option* option : app.get_options()) {
            for (const std::string& name : option->get_lnames()) {
                words.push_back("--" + name);
            }
        }
        for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
            words.push_back(command->get_name());
        }
        return words;
    }

    Console& console_;
    CLI::App app_;
    std::vector<Entry> entries_;
};

int runParsed(Parser& parser, Console& console) {
    const InterruptGuard guard(console.task());
    const int code = parser.run();
    console.flush();
    return code;
}

/// Every failure ends here, as one line and an exit code.
template <typename Work>
int reportFailures(Console& console, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        console.fail(error);
        return static_cast<int>(error.kind());
    } catch (const std::bad_alloc&) {
        const Error error(ErrorKind::noResources, {"out of memory", "", "", "close other programs or make it smaller"});
        console.fail(error);
        return static_cast<int>(error.kind());
    } catch (const std::exception& error) {
        constexpr int kInternal = 1; // none of the documented codes: a fault of the program
        console.fail({static_cast<ErrorKind>(kInternal),
                      {"internal error", "", error.what(), "please report it with what you did"}});
        return kInternal;
    }
}

} // namespace

int runProgram(const std::vector<std::string>& arguments, const ProgramStreams& streams) {
    Console console({streams.out, streams.err, streams.terminal});
    // For errors of the parser too, which stops at the first thing that is wrong.
    console.json = std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
    return reportFailures(console, [&] {
        Parser parser(console);
        try {
            parser.parse(arguments);
        } catch (const CLI::CallForHelp&) {
            console.print(parser.help());
            console.flush();
            return 0;
        } catch (const CLI::CallForVersion&) {
            console.print("limner " LIMNER_VERSION "\n");
            console.flush();
            return 0;
        } catch (const CLI::ParseError& error) {
            throw parser.usageError(error);
        }
        return runParsed(parser, console);
    });
}

} // namespace limner::cli
