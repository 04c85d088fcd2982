#include "app/cli/style_words.h"

#include "core/base/error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace limner::cli {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuseOutput(const std::string& file, const std::string& why, const std::string& remedy) {
    throw Error(ErrorKind::usage, {"cannot write the picture", file, why, remedy});
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool sameFile(const std::string& a, const std::string& b) {
    std::error_code ignored;
    const fs::path first = fs::weakly_canonical(a, ignored);
    const fs::path second = fs::weakly_canonical(b, ignored);
    return first == second;
}

} // namespace

void CardOptions::declare(CLI::App& app) {
    app.add_option("--name", name_, "The style's name, for people [from the file's name]")->option_text("TEXT");
    app.add_option("--tags", tags_, "Words to find it by, with commas between: bone,warm")->option_text("WORDS");
    app.add_option("--credit", credit_, "Whose work it is, as it is to be printed")->option_text("TEXT");
    app.add_option("--licence", licence_, "What may be done with it: CC BY 4.0, public domain, ...")
        ->option_text("TEXT");
}

void CardOptions::applyTo(StyleCard& card) const {
    const auto lay = [](std::string& old, const std::string& given) { old = given.empty() ? old : given; };
    lay(card.name, name_);
    lay(card.credit, credit_);
    lay(card.licence, licence_);
    if (!tags_.empty()) {
        card.tags = partsOf(tags_);
    }
}

std::vector<std::string> partsOf(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const std::string part = trimmed(text.substr(at, comma - at));
        if (!part.empty()) {
            parts.push_back(part);
        }
        at = comma + 1;
    }
    return parts;
}

std::vector<double> numbersOf(const std::string& text, const std::string& option, const std::string& example) {
    std::vector<double> numbers;
    const std::vector<std::string> parts = partsOf(text);
    bool sound = parts.size() == partsOf(example).size();
    for (const std::string& part : parts) {
        const char* end = part.data() + part.size();
        const auto read = std::from_chars(part.data(), end, numbers.emplace_back());
        sound = sound && read.ec == std::errc() && read.ptr == end && std::isfinite(numbers.back());
    }
    if (!sound) {
        throw Error(ErrorKind::usage,
                    {"wrong value", option, "\"" + text.substr(0, 60) + "\"", "write for example " + example});
    }
    return numbers;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

std::string nameFromFile(const std::string& file) {
    std::string name = fs::path(file).stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '_' || c == '-'; }, ' ');
    if (!name.empty()) {
        name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    }
    return name;
}

void checkOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const std::string& file = outputs[i];
        if (file.empty()) {
            continue;
        }
        const fs::path path = file;
        std::error_code ignored;
        if (path.extension() != ".png") {
            refuseOutput(file, "its name must end in .png", "write for example " + path.stem().string() + ".png");
        }
        if (path.has_parent_path() && !fs::is_directory(path.parent_path(), ignored)) {
            refuseOutput(file, "there is no such folder", "make the folder first");
        }
        const auto is = [&](const std::string& other) { return !other.empty() && sameFile(file, other); };
        if (std::any_of(inputs.begin(), inputs.end(), is)) {
            refuseOutput(file, "it is read from", "give it another name");
        }
        if (std::any_of(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(i), is)) {
            refuseOutput(file, "it is named twice", "give it another name");
        }
    }
}

} // namespace limner::cli
