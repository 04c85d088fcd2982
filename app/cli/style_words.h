#pragma once

#include "core/style/lit_sphere.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace limner::cli {

/// What the commands for styles share.

/// The options that say what a style's card is to say.
class CardOptions {
  public:
    void declare(CLI::App& app);
    /// Lays what was given over the card.
    void applyTo(StyleCard& card) const;
    [[nodiscard]] bool hasName() const { return !name_.empty(); }

  private:
    std::string name_;
    std::string tags_;
    std::string credit_;
    std::string licence_;
};

/// Numbers between commas. Throws Error(usage) where they are not as many as `example` has, or not finite.
std::vector<double> numbersOf(const std::string& text, const std::string& option, const std::string& example);

/// The parts between commas, without spaces around them; empty ones left out.
std::vector<std::string> partsOf(const std::string& text);

std::string joined(const std::vector<std::string>& words);

/// "blender_clay-brown" -> "Blender clay brown".
std::string nameFromFile(const std::string& file);

/// Throws Error(usage) where a picture cannot be made at that place: another ending than .png, no such folder, one of
/// the files that are read, or a place that another option names too. Empty ones are passed over.
void checkOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

} // namespace limner::cli
