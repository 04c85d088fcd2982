#pragma once

#include "core/base/task.h"
#include "core/style/extraction/extract.h"
#include "core/style/extraction/find.h"

#include <string>
#include <variant>
#include <vector>

namespace CLI {
class App;
}

namespace limner::cli {

/// A form on an artwork and how the command line writes it: "circle 120,340,55".
struct PlacedForm {
    std::variant<Ellipse, FormRegion> form;
    std::string words;
};

/// "circle 120,340,55" where the axes are alike, else "ellipse 120,340,55,40,30".
std::string ellipseWords(const Ellipse& ellipse);
bool isCircle(const Ellipse& ellipse);

/// The options that say where a style is on an artwork and what is done to it.
class ExtractOptions {
  public:
    void declareForm(CLI::App& app);
    void declareLook(CLI::App& app);

    /// What can be judged before anything is read: throws Error(usage) where nothing, or more than one thing, says what
    /// to take, and for values that make no sense.
    void checkForm() const;
    [[nodiscard]] bool hasForm() const;
    [[nodiscard]] bool detects() const { return detect_; }
    [[nodiscard]] bool hasSwatches() const { return !swatches_.empty(); }
    /// Files that are read besides the artwork; some may be empty.
    [[nodiscard]] std::vector<std::string> inputs() const { return {region_, marks_, ignore_}; }

    /// Snapped to the edge where that was asked for; says what was odd about it. Throws Error(badInput), also where
    /// nothing is found.
    [[nodiscard]] PlacedForm form(const Artwork& artwork, Task& task) const;
    /// All but whether a texture is wanted.
    [[nodiscard]] ExtractionRequest request(const Artwork& artwork, const PlacedForm& form, Task& task) const;
    [[nodiscard]] SpherePtr mixed() const;

  private:
    [[nodiscard]] Ellipse given() const;
    [[nodiscard]] Ellipse ellipse(const Artwork& artwork, Task& task) const;
    [[nodiscard]] SphereEdits edits() const;

    std::string circle_;
    std::string ellipse_;
    bool detect_ = false;
    int pick_ = 1;
    std::string region_;
    std::string marks_;
    std::string swatches_;
    std::string light_;
    bool snap_ = false;
    std::string ignore_;
    bool keepLettering_ = false;
    bool paperCast_ = false;
    int size_ = 512;
    double smoothing_ = 0;
    bool symmetric_ = false;
    double turn_ = 0;
    std::string alpha_;
};

/// Round things on the whole artwork, best first.
std::vector<RoundThing> roundThings(const Artwork& artwork, Task& task);

} // namespace limner::cli
