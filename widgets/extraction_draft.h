#pragma once

#include "core/style/extraction/extract.h"
#include "widgets/artwork_plate.h"

#include <QString>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace limner {

using MaskPtr = std::shared_ptr<const Mask>; ///< null: nothing is marked

/// What a style is taken from. A draft may hold all of them; one counts.
enum class FormKind { none, ellipse, region, swatches };

/// The colours that a sphere can be made of, in the order in which they are picked.
enum class SwatchRole { light, mid, shadow, rim, highlight };
constexpr std::size_t kSwatchRoles = 5;

/// A colour and where on the artwork it was picked.
struct PickedSwatch {
    Rgba colour;
    glm::dvec2 at{0, 0};
    friend bool operator==(const PickedSwatch&, const PickedSwatch&) = default;
};

struct PickedSwatches {
    std::array<std::optional<PickedSwatch>, kSwatchRoles> picked; ///< by role
    glm::dvec2 towardsLight{-0.5, 0.5};
    [[nodiscard]] const std::optional<PickedSwatch>& of(SwatchRole role) const {
        return picked[static_cast<std::size_t>(role)];
    }
    friend bool operator==(const PickedSwatches&, const PickedSwatches&) = default;
};

/// All that the extraction dialog holds, as one value: cheap to copy, since plates and masks are shared.
struct ExtractionDraft {
    PlatePtr plate; ///< null: no artwork is open

    FormKind form = FormKind::none;
    std::optional<Ellipse> ellipse;
    MaskPtr region; ///< over the plate's reduced copy, as is `ignored`
    FormMarks marks;
    PickedSwatches swatches;

    MaskPtr ignored;
    bool skipLettering = true;
    bool removePaperCast = false;
    bool separateTexture = false;
    int size = 512;
    SphereEdits edits;

    std::string name;
    std::string tags; ///< as typed: words between commas
    std::string credit;
    std::string licence;

    friend bool operator==(const ExtractionDraft&, const ExtractionDraft&) = default;
};

/// Whether there is enough in the draft to try an extraction.
bool canExtract(const ExtractionDraft& draft);
/// Whether both give the same sphere but for its edits (smoothing, light, opacity).
bool sameSource(const ExtractionDraft& a, const ExtractionDraft& b);
/// Whether both give the same sphere.
bool sameSphere(const ExtractionDraft& a, const ExtractionDraft& b);

/// For an ellipse or a region; `ongoing`: a smaller sphere will do.
ExtractionRequest requestOf(const ExtractionDraft& draft, bool ongoing);
/// For swatches, light and shadow among them.
Swatches swatchesOf(const PickedSwatches& picked);

/// Name, tags, credit and licence as typed, with an id made of the name, and where it is from ("plate.tif, ellipse
/// 210 x 180 pixels at (400, 312), 2026-01-31").
StyleCard cardOf(const ExtractionDraft& draft, const std::string& date);

/// "Bone" -> "Bone 2" -> "Bone 3": for the next style from the same plate.
std::string nextName(const std::string& name);

/// What a control of the dialog asks for.
struct DraftEdit {
    ExtractionDraft draft;
    QString label;        ///< for people, in the imperative
    std::string mergeKey; ///< as `Edit::mergeKey`
    bool ongoing = false; ///< more of the same gesture is to come
};

/// Undo and redo over drafts, by the rules of `History`: steps with the same key are one, what changes nothing is none,
/// a gesture that comes back to where it began leaves none.
class DraftHistory {
  public:
    DraftHistory() : steps_(1) {}

    [[nodiscard]] const ExtractionDraft& current() const { return steps_[position_].draft; }
    [[nodiscard]] bool canUndo() const { return position_ > 0; }
    [[nodiscard]] bool canRedo() const { return position_ + 1 < steps_.size(); }
    [[nodiscard]] QString undoLabel() const { return canUndo() ? steps_[position_].label : QString(); }
    [[nodiscard]] QString redoLabel() const { return canRedo() ? steps_[position_ + 1].label : QString(); }

    /// Returns whether the draft changed.
    bool apply(const DraftEdit& edit);
    bool undo();
    bool redo();

  private:
    struct Step {
        ExtractionDraft draft;
        QString label;
        std::string mergeKey;
    };
    void dropOldest();

    std::vector<Step> steps_; ///< never empty
    std::size_t position_ = 0;
    bool mergeOpen_ = false;
};

} // namespace limner
