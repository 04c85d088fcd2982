#include "widgets/style_source.h"

#include <QStringList>

#include <algorithm>

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

QString tagLine(const std::vector<std::string>& tags) {
    QStringList line;
    for (const std::string& tag : tags)
        line << QString::fromStdString(tag);
    return line.join(", ");
}

std::vector<std::string> tagsOfLine(const QString& line) {
    std::vector<std::string> tags;
    for (const QString& part : line.split(',')) {
        const std::string tag = part.simplified().toStdString();
        if (!tag.empty() && std::find(tags.begin(), tags.end(), tag) == tags.end())
            tags.push_back(tag);
    }
    return tags;
}

} // namespace limner
