#include "app/studio/extraction_work.h"

#include "widgets/draft_edits.h"
#include "widgets/job.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr int kSnapSide = 768;    // pixels: an edge is found to a fraction of one of them
constexpr int kRefineSide = 1024; // pixels: finer than a mask over the plate, and cut out in a fraction of a second
constexpr double kMargin = 0.3;   // around a form, of its size: the ground shows what it stands out from

ArtRect around(glm::dvec2 low, glm::dvec2 high) {
    const glm::dvec2 margin = (high - low) * kMargin + 2.0;
    const glm::dvec2 from = glm::floor(low - margin);
    const glm::dvec2 size = glm::ceil(high + margin) - from;
    return {static_cast<int>(from.x), static_cast<int>(from.y), static_cast<int>(size.x), static_cast<int>(size.y)};
}

} // namespace

ExtractionWork::ExtractionWork(QObject* parent)
    : QObject(parent), opening_(tr("Opening artwork"), this), finding_(tr("Looking for round things"), this),
      cutting_(tr("Cutting"), this), fitting_(tr("Fitting the outline"), this),
      lettering_(tr("Looking for letters"), this), extracting_(tr("Extracting"), this),
      adding_(tr("Adding the style"), this) {
    for (NewestJob* job : {&opening_, &fitting_, &lettering_, &adding_}) {
        connect(job, &NewestJob::failed, this, &ExtractionWork::failed);
        connect(job, &NewestJob::started, this, &ExtractionWork::started);
    }
    connect(&extracting_, &NewestJob::failed, this, &ExtractionWork::extractionFailed);
    connect(&extracting_, &NewestJob::stopped, this, &ExtractionWork::extractionStopped);
    connect(&extracting_, &NewestJob::started, this, &ExtractionWork::started);
    // A failed proposal or sharper picture is no loss: the reduced copy stays.
}

bool ExtractionWork::busy() const {
    return opening_.busy() || fitting_.busy() || lettering_.busy() || extracting_.busy() || adding_.busy();
}

void ExtractionWork::openWith(std::function<std::shared_ptr<const Artwork>(Task&)> load) {
    auto plate = std::make_shared<PlatePtr>();
    opening_.want(
        [plate, load = std::move(load)](Task& task) { *plate = std::make_shared<const ArtworkPlate>(load(task)); },
        [this, plate] { Q_EMIT opened(*plate); });
}

void ExtractionWork::open(const std::filesystem::path& file) {
    openWith([file](Task& task) { return std::make_shared<const Artwork>(file, task); });
}

void ExtractionWork::open(const QImage& pasted, const QString& name) {
    openWith(
        [pasted, name = name.toStdString()](Task&) { return std::make_shared<const Artwork>(pixelsOf(pasted), name); });
}

void ExtractionWork::findRoundThings(const PlatePtr& plate) {
    auto things = std::make_shared<std::vector<RoundThing>>();
    finding_.want([things, plate](Task& task) { *things = limner::findRoundThings(plate->artwork->reduced(), task); },
                  [this, things, plate] { Q_EMIT roundThingsFound(plate, *things); });
}

void ExtractionWork::cutSharper(const PlatePtr& plate, const ArtRect& part, int longest) {
    struct Made {
        ArtCut cut;
        QImage picture;
    };
    auto made = std::make_shared<Made>();
    cutting_.want(
        [made, plate, part, longest](Task& task) {
            made->cut = plate->artwork->cut(part, longest, task);
            made->picture = imageOf(made->cut.picture);
        },
        [this, made, plate] { Q_EMIT sharperCut(plate, made->cut, made->picture); });
}

void ExtractionWork::snap(const PlatePtr& plate, const Ellipse& rough) {
    auto found = std::make_shared<std::optional<Ellipse>>();
    fitting_.want(
        [found, plate, rough](Task& task) {
            const glm::dvec2 reach(std::max(rough.semiAxes.x, rough.semiAxes.y));
            const ArtCut cut = plate->artwork->cut(around(rough.centre - reach, rough.centre + reach), kSnapSide, task);
            // A rough outline comes near the edge first, and from there onto it.
            constexpr int kMostTimes = 3;
            *found = snapEllipse(cut, rough);
            for (int i = 1; i < kMostTimes && *found; ++i) {
                task.throwIfCancelled();
                const auto nearer = snapEllipse(cut, **found);
                if (!nearer || *nearer == **found)
                    break;
                *found = nearer;
            }
        },
        [this, found, plate] { Q_EMIT snapped(plate, *found); });
}

void ExtractionWork::refine(const PlatePtr& plate, const ArtPath& outline, OutlineMode mode) {
    auto made = std::make_shared<Refined>();
    made->plate = plate;
    made->outline = outline;
    made->mode = mode;
    fitting_.want(
        [made](Task& task) {
            glm::dvec2 low = made->outline.front();
            glm::dvec2 high = low;
            for (const glm::dvec2& place : made->outline) {
                low = glm::min(low, place);
                high = glm::max(high, place);
            }
            made->cut = made->plate->artwork->cut(around(low, high), kRefineSide, task);
            if (!made->cut.picture.empty())
                made->form = refineRegion(made->cut, made->outline, task);
        },
        [this, made] { Q_EMIT refined(*made); });
}

void ExtractionWork::findLetters(const PlatePtr& plate) {
    auto letters = std::make_shared<MaskPtr>();
    lettering_.want(
        [letters, plate](Task&) {
            const ArtCut& whole = plate->artwork->reduced();
            *letters = withCutMarked(*plate, blankMask(*plate), whole, findLettering(whole));
        },
        [this, letters, plate] { Q_EMIT lettersFound(plate, *letters); });
}

void ExtractionWork::extract(const ExtractionDraft& draft, bool ongoing) {
    struct Made {
        std::shared_ptr<const Extraction> extraction;
        std::shared_ptr<const ExtractionPictures> pictures;
    };
    auto made = std::make_shared<Made>();
    const bool kept = last_.extraction && sameSource(last_.of, draft) && (last_.whole || ongoing);
    if (kept)
        made->extraction = last_.extraction;
    const bool whole = kept ? last_.whole : !ongoing;
    extracting_.want(
        [made, draft, ongoing](Task& task) {
            SpherePtr sphere;
            if (draft.form == FormKind::swatches) {
                const ExtractionRequest request = requestOf(draft, ongoing);
                sphere = edited(sphereOfSwatches(swatchesOf(draft.swatches), request.size), draft.edits);
            } else if (made->extraction) {
                sphere = edited(made->extraction->unedited, draft.edits);
            } else {
                made->extraction = std::make_shared<const Extraction>(
                    extractStyle(*draft.plate->artwork, requestOf(draft, ongoing), task));
                sphere = made->extraction->sphere;
            }
            task.throwIfCancelled();
            made->pictures =
                std::make_shared<const ExtractionPictures>(picturesOf(made->extraction, std::move(sphere)));
        },
        [this, made, draft, whole] {
            if (made->extraction)
                last_ = {draft, made->extraction, whole};
            Q_EMIT extracted(draft, made->pictures, whole);
        },
        ongoing ? NewestJob::Running::complete : NewestJob::Running::stop);
}

void ExtractionWork::add(const StyleLibrary& library, const Style& style, Then then) {
    auto written = std::make_shared<Style>();
    adding_.want([written, library, style](Task&) { *written = library.load(library.add(style).id); },
                 [this, written, then] { Q_EMIT added(*written, then); });
}

} // namespace limner
