#include "app/cli/help_formatter.h"

#include <CLI/CLI.hpp>

#include <sstream>

namespace limner::cli {

namespace {

constexpr std::size_t kTerminal = 80;
constexpr std::size_t kNames = 27; // the longest option with its value, but for a few that take a line of their own

std::string wrapped(const std::string& text, std::size_t width) {
    std::istringstream words(text);
    std::string out;
    std::size_t column = 0;
    for (std::string word; words >> word;) {
        if (column > 0 && column + 1 + word.size() > width) {
            out += '\n';
            column = 0;
        } else if (column > 0) {
            out += ' ';
            ++column;
        }
        out += word;
        column += word.size();
    }
    return out;
}

class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter() {
        column_width(kNames);
        label("SUBCOMMAND", "COMMAND");
        label("Positionals", "Arguments");
        label("OPTIONS", "OPTIONS");
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        return wrapped(CLI::Formatter::make_option_desc(option), kTerminal - kNames);
    }

    std::string make_subcommand(const CLI::App* command) const override {
        const std::string description = command->get_description();
        std::ostringstream out;
        CLI::detail::format_help(out, command->get_name(), description.substr(0, description.find('\n')), kNames);
        return out.str();
    }
};

} // namespace

std::shared_ptr<CLI::FormatterBase> makeHelpFormatter() { return std::make_shared<HelpFormatter>(); }

} // namespace limner::cli
