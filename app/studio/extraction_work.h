#pragma once

#include "core/style/extraction/find.h"
#include "core/style/style_library.h"
#include "widgets/artwork_tool.h"
#include "widgets/extraction_view.h"
#include "widgets/newest_job.h"

#include <QObject>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace limner {

/// What the extraction dialog has done off the interface's thread. Of each sort only the newest counts. Every answer
/// names the plate it is about, which may be another one by then.
class ExtractionWork : public QObject {
    Q_OBJECT

  public:
    explicit ExtractionWork(QObject* parent);

    /// An outline fitted to the picture.
    struct Refined {
        PlatePtr plate;
        ArtPath outline;
        OutlineMode mode = OutlineMode::replace;
        ArtCut cut;
        Mask form; ///< over the cut; empty where nothing stands out
    };

    void open(const std::filesystem::path& file);
    void open(const QImage& pasted, const QString& name);
    void findRoundThings(const PlatePtr& plate);
    void cutSharper(const PlatePtr& plate, const ArtRect& part, int longest);
    void snap(const PlatePtr& plate, const Ellipse& rough);
    void refine(const PlatePtr& plate, const ArtPath& outline, OutlineMode mode);
    void findLetters(const PlatePtr& plate);
    /// `ongoing`: a smaller sphere will do, and what runs may be shown first.
    void extract(const ExtractionDraft& draft, bool ongoing);
    void dropExtraction() { extracting_.drop(); }

    enum class Then { keepOnly, use };
    void add(const StyleLibrary& library, const Style& style, Then then);

    /// Whether an artwork is being opened, a form found, a style extracted or written.
    [[nodiscard]] bool busy() const;

  Q_SIGNALS:
    void started(limner::Job* job);
    void opened(const limner::PlatePtr& plate);
    void roundThingsFound(const limner::PlatePtr& plate, const std::vector<limner::RoundThing>& things);
    void sharperCut(const limner::PlatePtr& plate, const limner::ArtCut& cut, const QImage& picture);
    /// None: there is no edge near it.
    void snapped(const limner::PlatePtr& plate, const std::optional<limner::Ellipse>& ellipse);
    void refined(const limner::ExtractionWork::Refined& refined);
    void lettersFound(const limner::PlatePtr& plate, const limner::MaskPtr& letters);
    /// `whole`: at the draft's own size, with all that was asked for.
    void extracted(const limner::ExtractionDraft& of, std::shared_ptr<const limner::ExtractionPictures> pictures,
                   bool whole);
    void extractionFailed(const limner::Error& error);
    void extractionStopped();
    /// As the library gives it back.
    void added(const limner::Style& style, limner::ExtractionWork::Then then);
    /// Of any other work.
    void failed(const limner::Error& error);

  private:
    void openWith(std::function<std::shared_ptr<const Artwork>(Task&)> load);

    NewestJob opening_;
    NewestJob finding_;
    NewestJob cutting_;
    NewestJob fitting_;
    NewestJob lettering_;
    NewestJob extracting_;
    NewestJob adding_;

    /// The newest extraction, whose edits can be changed without extracting again.
    struct Last {
        ExtractionDraft of;
        std::shared_ptr<const Extraction> extraction;
        bool whole = false;
    };
    Last last_;
};

} // namespace limner
