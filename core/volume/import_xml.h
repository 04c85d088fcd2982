#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A thin wrapper of expat for headers in XML. Internal to core/volume.
namespace limner::importing {

struct XmlElement {
    std::string_view name;
    std::vector<std::pair<std::string_view, std::string_view>> attributes;

    /// Empty where the attribute is absent.
    [[nodiscard]] std::string_view attribute(std::string_view key) const;
};

struct XmlHandler {
    std::function<void(const XmlElement&)> started;
    std::function<void(std::string_view)> text; ///< may come in pieces
    std::function<void(std::string_view)> ended;
    std::size_t deepest = 64; ///< elements in each other; more are refused
};

/// Parses a document; false where it is not well-formed, too deep, or declares entities (which no header needs and
/// which can grow without bound). Exceptions of the handler pass through.
bool parseXml(std::string_view document, const XmlHandler& handler);

} // namespace limner::importing
