#include "renderer/gl/program_source.h"

#include <algorithm>
#include <cassert>
#include <regex>

namespace limner::gl {

namespace {

std::string_view textOf(const std::string& name) {
    const auto files = featureFiles();
    const auto found = std::find_if(files.begin(), files.end(), [&](const FeatureFile& f) { return f.name == name; });
    assert(found != files.end());
    return found->text;
}

std::string ofLayer(std::string_view text, int layer) {
    std::string made;
    for (const char c : text) {
        if (c == '@') {
            made += std::to_string(layer);
        } else {
            made += c;
        }
    }
    return made;
}

} // namespace

ProgramSource& ProgramSource::define(const std::string& name, int value) {
    definitions_ += "#define " + name + " " + std::to_string(value) + "\n";
    return *this;
}

ProgramSource& ProgramSource::add(const std::string& name) { return add(name, -1); }

ProgramSource& ProgramSource::add(const std::string& name, int layer) {
    names_.push_back(name);
    body_ += "#line 1 " + std::to_string(names_.size()) + "\n";
    body_ += layer < 0 ? std::string(textOf(name)) : ofLayer(textOf(name), layer);
    return *this;
}

std::string ProgramSource::text() const { return "#version 410 core\n" + definitions_ + body_; }

std::string ProgramSource::readable(const std::string& log) const {
    static const std::regex kPlace(R"((\d+)[:(](\d+)\)?)");
    std::string out;
    auto from = log.begin();
    for (std::sregex_iterator at(log.begin(), log.end(), kPlace), end; at != end; ++at) {
        const auto file = static_cast<std::size_t>(std::stoul((*at)[1].str().substr(0, 6)));
        out.append(from, (*at)[0].first);
        out += file >= 1 && file <= names_.size() ? names_[file - 1] + ":" + (*at)[2].str() : (*at)[0].str();
        from = (*at)[0].second;
    }
    out.append(from, log.end());
    return out;
}

} // namespace limner::gl
