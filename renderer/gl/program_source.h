#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limner::gl {

/// A file of renderer/gl/features, built into the program.
struct FeatureFile {
    std::string_view name; ///< "style.glsl"
    std::string_view text;
};

/// All of them, by name.
std::span<const FeatureFile> featureFiles();

/// A shader put together from feature files: what a figure does not use is not in it. Two sources with the same text
/// are the same shader. A file may be added several times, once for each layer: every '@' in it stands for the layer's
/// number.
class ProgramSource {
  public:
    ProgramSource& define(const std::string& name, int value = 1);
    /// `name` must be one of `featureFiles`.
    ProgramSource& add(const std::string& name);
    ProgramSource& add(const std::string& name, int layer);

    /// What OpenGL is given: version, definitions, files, each with its own line numbers.
    [[nodiscard]] std::string text() const;
    /// A compiler's log with its "2:17" or "2(17)" made "style.glsl:17".
    [[nodiscard]] std::string readable(const std::string& log) const;

  private:
    std::string definitions_;
    std::string body_;
    std::vector<std::string> names_; ///< by the number that #line gives them, from 1
};

} // namespace limner::gl
