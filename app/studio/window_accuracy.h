#pragma once

#include "app/studio/workplace.h"
#include "renderer/accuracy/study.h"
#include "widgets/newest_job.h"

#include <QObject>

#include <filesystem>
#include <memory>
#include <optional>

namespace limner {

class AccuracyPanel;
class ErrorOverlay;

/// How wrong the picture is and what better would cost: the panel, the work for it on a thread of its own - one piece
/// at a time, since they measure time - and the map of the error over the picture, which goes when the picture changes.
class WindowAccuracy : public QObject {
    Q_OBJECT

  public:
    explicit WindowAccuracy(const Workplace& place);

    /// Finds the cheapest settings that keep a tolerance; where they do, they become the figure's in one step.
    void findSettings(const accuracy::Tolerance& tolerance);
    void runStudy();
    void measureSavings();
    void stop();
    /// False takes the map away.
    void showMap(bool on);
    /// Of the newest study; by the name's ending .html, .csv or .json.
    void saveReport(const std::filesystem::path& path);

    [[nodiscard]] AccuracyPanel& panel() { return *panel_; }
    [[nodiscard]] ErrorOverlay& overlay() { return *overlay_; }
    [[nodiscard]] const std::shared_ptr<const accuracy::Study>& study() const { return study_; }
    [[nodiscard]] bool busy() const { return work_.busy(); }

  Q_SIGNALS:
    void reportSaved();

  private:
    void connectPanel();
    void connectWork();
    void showFigure();
    void forgetDocument();
    void idle();
    void chooseReport();
    void apply(const accuracy::ToleranceChoice& choice);
    /// What a figure would have without a search.
    [[nodiscard]] Quality modelOf(const Figure& figure) const;
    void showErrors(const Picture& picture, const Picture& best);
    void takeMapAway();
    /// The picture's size in the window, not larger than what the work can be done for while one waits.
    [[nodiscard]] PlanRequest request() const;

    Workplace place_;
    std::shared_ptr<const Backend> backend_;
    AccuracyPanel* panel_;
    ErrorOverlay* overlay_;
    NewestJob work_;
    QPointer<Job> reportJob_;
    unsigned generation_ = 0;               ///< of the document that all below are of
    std::shared_ptr<const Figure> working_; ///< what the work that is going on is about
    std::shared_ptr<const Figure> found_;   ///< what the panel's answer is about
    std::optional<Quality> applied_;        ///< by the newest search that kept its tolerance
    Quality model_;                         ///< that search's: the interpolation, gradients and rays that are no error
    std::shared_ptr<const Figure> studied_;
    std::shared_ptr<const accuracy::Study> study_;
    std::shared_ptr<const Figure> saved_;  ///< what the panel's savings are of
    std::shared_ptr<const Figure> mapped_; ///< what the map is of; null: there is none
};

} // namespace limner
