#pragma once

#include "core/style/extraction/rim.h"
#include "core/style/extraction/tones.h"

#include <cstdint>
#include <vector>

namespace limner {

/// How the tones go inside an oval.
struct InnerCourse {
    double range = 0;   ///< of lightness, from the darkest to the lightest of its broad course, 0..1
    double smooth = 0;  ///< share of the tones' variance that the broad course explains, 0..1
    double broken = 0;  ///< share of the inside where they jump more than a shaded form's would
    double spread = 0;  ///< standard deviation of the tones
    double bulging = 0; ///< how much lighter the middle is than the rim, in shares of the range
};

/// Judges ovals on tones. Internal to the extraction.
class RoundScores {
  public:
    explicit RoundScores(const Tones& tones);

    [[nodiscard]] InnerCourse courseOf(const Oval& oval) const;
    /// 0..1: how round, how well edged and how shaded. `rim` as `followRim` found it; of an oval whose edge was not
    /// found, support 0.
    [[nodiscard]] double of(const Rim& rim) const;
    /// A quick guess at it, of an oval that is not yet snapped.
    [[nodiscard]] double guess(const Oval& oval) const;

  private:
    /// Share of an oval's inside that is the paper around the forms, and share that lies beyond the picture.
    [[nodiscard]] double paperWithin(const Oval& oval) const;
    [[nodiscard]] double beyond(const Oval& oval) const;
    [[nodiscard]] double formOf(const Oval& oval) const;
    void findPaper();

    std::vector<Tones> levels_;       ///< each half as fine as the one before
    std::vector<std::uint8_t> paper_; ///< over the first level; empty where the picture shows none
};

} // namespace limner
