#include "widgets/style_source.h"

namespace limner {
namespace {

std::string prefixOf(StyleHome home) {
    switch (home) {
    case StyleHome::mine: return "mine:";
    case StyleHome::project: return "project:";
    case StyleHome::bundled: break;
    }
    return "bundled:";
}

} // namespace

std::string styleKey(StyleHome home, const std::string& id) { return prefixOf(home) + id; }

std::string styleIdOf(const std::string& key) { return key.substr(key.find(':') + 1); }

bool livesIn(const std::string& key, StyleHome home) { return key.starts_with(prefixOf(home)); }

} // namespace limner
