#pragma once

#include "app/cli/command.h"
#include "app/cli/style_extract_options.h"
#include "app/cli/style_words.h"

#include <string>

namespace limner::cli {

/// `limner style extract`: a style from a ball or any shaded form on a scanned artwork, or from a few colours.
class StyleExtractCommand : public Command {
  public:
    void declare(CLI::App& app) override;
    int run(Console& console) override;

  private:
    void declareOutputs(CLI::App& app);
    void checkSense() const;
    [[nodiscard]] bool makesStyle() const { return !out_.empty() || add_; }
    [[nodiscard]] Style styleOf(const SpherePtr& sphere, const std::string& source) const;
    /// Only what was found is wanted.
    int listProposals(const Artwork& artwork, Console& console) const;
    int extractFromArtwork(Console& console) const;
    int mixSwatches(Console& console) const;
    /// Writes the style to where it was asked for; gives it the id and name that it has there.
    void write(Style& style) const;
    void report(Console& console, const Style& style, const PlacedForm& form, const Extraction& extraction) const;

    std::string art_;
    ExtractOptions options_;
    CardOptions card_;
    std::string out_;
    bool add_ = false;
    std::string texture_;
    std::string difference_;
    std::string lettering_;
};

} // namespace limner::cli
