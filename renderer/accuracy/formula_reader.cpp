#include "core/base/error.h"
#include "renderer/accuracy/formula_vectors.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace limner {

namespace {

constexpr std::size_t kLongestLine = 1 << 16; // of the known ones the longest has 4 KiB
constexpr std::size_t kMostLines = 1'000'000;

/// Throws std::invalid_argument.
std::vector<double> numbersOf(const nlohmann::json& line, const char* key) {
    const auto found = line.find(key);
    if (found == line.end() || !found->is_array()) {
        throw std::invalid_argument(std::string("\"") + key + "\" is no list");
    }
    std::vector<double> numbers;
    for (const auto& element : *found) {
        if (!element.is_number() || !std::isfinite(element.get<double>())) {
            throw std::invalid_argument(std::string("\"") + key + "\" has an element that is no number");
        }
        numbers.push_back(element.get<double>());
    }
    return numbers;
}

bool isFloat32(double x) {
    return std::abs(x) <= std::numeric_limits<float>::max() && static_cast<double>(static_cast<float>(x)) == x;
}

/// Throws std::invalid_argument or an exception of the JSON library.
FormulaVector vectorOf(const std::string& text) {
    const auto line = nlohmann::json::parse(text);
    const std::string name = line.is_object() ? line.value("f", "") : "";
    const auto* const kind =
        std::find_if(kFormulas.begin(), kFormulas.end(), [&](const FormulaKind& k) { return name == k.name; });
    if (kind == kFormulas.end()) {
        throw std::invalid_argument("\"" + name.substr(0, 60) + "\" is no formula that is known here");
    }
    FormulaVector vector{kind->formula, numbersOf(line, "in"), numbersOf(line, "out"), ""};
    const bool ray = kind->formula == Formula::importanceRay;
    const bool complete =
        ray ? !vector.in.empty() && vector.in.size() % kind->arguments == 0 : vector.in.size() == kind->arguments;
    if (!complete || vector.out.size() != kind->results) {
        throw std::invalid_argument(name + " has " + std::to_string(kind->arguments) +
                                    (ray ? " arguments for each sample and " : " arguments and ") +
                                    std::to_string(kind->results) + " results");
    }
    if (!std::all_of(vector.in.begin(), vector.in.end(), isFloat32)) {
        throw std::invalid_argument("an argument is no float32 value");
    }
    return vector;
}

[[noreturn]] void refuse(const std::filesystem::path& path, std::size_t line, const std::string& why) {
    throw Error(ErrorKind::badInput, {"cannot read the test vectors", path.string() + ", line " + std::to_string(line),
                                      why, "one object a line: {\"f\": name, \"in\": [...], \"out\": [...]}"});
}

} // namespace

std::vector<FormulaVector> readFormulaVectors(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<char> text(kLongestLine);
    if (!file || std::filesystem::is_directory(path)) {
        throw Error(ErrorKind::badInput,
                    {"cannot read the test vectors", path.string(), "no file there", "name a file of JSON lines"});
    }
    std::vector<FormulaVector> vectors;
    std::size_t number = 1;
    for (; file.getline(text.data(), static_cast<std::streamsize>(text.size())); ++number) {
        if (number > kMostLines) {
            refuse(path, number, "over a million lines");
        }
        const auto read = static_cast<std::size_t>(file.gcount()); // with the line break, where there is one
        const std::string line(text.data(), file.eof() ? read : read - 1);
        if (line.find_first_not_of(" \t\r") == std::string::npos) {
            continue;
        }
        try {
            vectors.push_back(vectorOf(line));
        } catch (const std::exception& error) {
            refuse(path, number, error.what());
        }
        vectors.back().source = "line " + std::to_string(number);
    }
    if (!file.eof()) {
        refuse(path, number, "the line is too long");
    }
    if (vectors.empty()) {
        refuse(path, number, "the file holds no vector");
    }
    return vectors;
}

} // namespace limner
