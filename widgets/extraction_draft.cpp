#include "widgets/extraction_draft.h"

#include "core/style/slug.h"
#include "widgets/style_source.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace limner {
namespace {

constexpr std::size_t kMostSteps = 200;
constexpr std::size_t kMostMaskBytes = 256U << 20U; // of all steps together; a mask is at most 4 MB
constexpr int kOngoingSize = 256;                   // of the sphere while a hand is still moving

std::string trimmed(const std::string& text) { return QString::fromStdString(text).trimmed().toStdString(); }

QString formWords(const ExtractionDraft& draft) {
    const auto whole = [](double value) { return QString::number(std::lround(value)); };
    if (draft.form == FormKind::ellipse && draft.ellipse) {
        const Ellipse& e = *draft.ellipse;
        return QStringLiteral("ellipse %1 x %2 pixels at (%3, %4)")
            .arg(whole(2 * e.semiAxes.x), whole(2 * e.semiAxes.y), whole(e.centre.x), whole(e.centre.y));
    }
    return draft.form == FormKind::region ? QStringLiteral("an outlined form") : QStringLiteral("picked colours");
}

} // namespace

bool canExtract(const ExtractionDraft& draft) {
    switch (draft.form) {
    case FormKind::none: return false;
    case FormKind::ellipse: return draft.plate && draft.ellipse;
    case FormKind::region: return draft.plate && draft.region;
    case FormKind::swatches: return draft.swatches.of(SwatchRole::light) && draft.swatches.of(SwatchRole::shadow);
    }
    return false;
}

bool sameSource(const ExtractionDraft& a, const ExtractionDraft& b) {
    if (a.form != b.form || a.size != b.size)
        return false;
    if (a.form == FormKind::swatches)
        return a.swatches == b.swatches;
    const bool sameForm =
        a.form == FormKind::ellipse ? a.ellipse == b.ellipse : a.region == b.region && a.marks == b.marks;
    return sameForm && a.plate == b.plate && a.ignored == b.ignored && a.skipLettering == b.skipLettering &&
           a.removePaperCast == b.removePaperCast && a.separateTexture == b.separateTexture;
}

bool sameSphere(const ExtractionDraft& a, const ExtractionDraft& b) { return sameSource(a, b) && a.edits == b.edits; }

ExtractionRequest requestOf(const ExtractionDraft& draft, bool ongoing) {
    ExtractionRequest request;
    request.form = draft.ellipse.value_or(Ellipse{});
    if (draft.form == FormKind::region)
        request.form = FormRegion{draft.region ? *draft.region : Mask{}, draft.marks};
    if (draft.ignored)
        request.ignored = *draft.ignored;
    request.skipLettering = draft.skipLettering;
    request.removePaperCast = draft.removePaperCast;
    request.separateTexture = draft.separateTexture && !ongoing;
    request.size = ongoing ? std::min(draft.size, kOngoingSize) : draft.size;
    request.edits = draft.edits;
    return request;
}

Swatches swatchesOf(const PickedSwatches& picked) {
    const auto colour = [&](SwatchRole role) {
        const auto& swatch = picked.of(role);
        return swatch ? std::optional(swatch->colour) : std::nullopt;
    };
    Swatches swatches{colour(SwatchRole::light).value_or(Rgba{}), colour(SwatchRole::shadow).value_or(Rgba{})};
    swatches.mid = colour(SwatchRole::mid);
    swatches.rim = colour(SwatchRole::rim);
    swatches.highlight = colour(SwatchRole::highlight);
    swatches.towardsLight = picked.towardsLight;
    return swatches;
}

StyleCard cardOf(const ExtractionDraft& draft, const std::string& date) {
    StyleCard card;
    card.name = trimmed(draft.name);
    card.id = slugOf(card.name);
    card.tags = tagsOfLine(QString::fromStdString(draft.tags));
    const std::string file = draft.plate ? draft.plate->artwork->file().filename().string() : std::string();
    card.origin = file + (file.empty() ? "" : ", ") + formWords(draft).toStdString() + ", " + date;
    card.credit = trimmed(draft.credit);
    card.licence = trimmed(draft.licence);
    return card;
}

std::string nextName(const std::string& name) {
    const std::string plain = trimmed(name);
    const std::size_t last = plain.find_last_not_of("0123456789");
    const std::string digits = last == std::string::npos ? std::string() : plain.substr(last + 1);
    constexpr std::size_t kMostDigits = 6; // more is no count
    const bool counted = !digits.empty() && digits.size() <= kMostDigits && plain[last] == ' ';
    if (!counted)
        return plain + " 2";
    return plain.substr(0, last + 1) + std::to_string(std::stoi(digits) + 1);
}

bool DraftHistory::apply(const DraftEdit& edit) {
    if (edit.draft == current())
        return false;
    steps_.resize(position_ + 1);
    const bool merges =
        mergeOpen_ && canUndo() && !edit.mergeKey.empty() && steps_[position_].mergeKey == edit.mergeKey;
    if (merges && edit.draft == steps_[position_ - 1].draft) {
        steps_.pop_back();
        --position_;
        mergeOpen_ = false;
        return true;
    }
    if (merges) {
        steps_[position_].draft = edit.draft;
        return true;
    }
    mergeOpen_ = !edit.mergeKey.empty();
    steps_.push_back({edit.draft, edit.label, edit.mergeKey});
    dropOldest();
    position_ = steps_.size() - 1;
    return true;
}

void DraftHistory::dropOldest() {
    std::set<const Mask*> seen;
    std::size_t bytes = 0;
    std::size_t keep = 0; // counted from the newest
    for (auto step = steps_.rbegin(); step != steps_.rend() && keep <= kMostSteps; ++step, ++keep) {
        for (const MaskPtr& mask : {step->draft.region, step->draft.ignored})
            if (mask && seen.insert(mask.get()).second)
                bytes += mask->values.size();
        if (bytes > kMostMaskBytes)
            break;
    }
    constexpr std::size_t kAtLeast = 2; // one step can always be taken back
    keep = std::max(keep, std::min(steps_.size(), kAtLeast));
    steps_.erase(steps_.begin(), steps_.end() - static_cast<std::ptrdiff_t>(keep));
}

bool DraftHistory::undo() {
    if (!canUndo())
        return false;
    --position_;
    mergeOpen_ = false;
    return true;
}

bool DraftHistory::redo() {
    if (!canRedo())
        return false;
    ++position_;
    mergeOpen_ = false;
    return true;
}

} // namespace limner
