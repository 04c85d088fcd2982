#pragma once

#include "app/studio/extraction_work.h"
#include "core/project/history.h"
#include "core/style/style_library.h"
#include "widgets/extraction_draft.h"

#include <QDialog>

#include <functional>
#include <memory>
#include <optional>

class QLabel;
class QStackedWidget;

namespace limner {

class ArtworkCanvas;
class ArtworkToolBar;
class ArtworkToolOptions;
class ExtractionForm;
class FigurePreview;
class NoticeBar;
class ProgressStrip;
class StyleCardForm;

/// Takes styles from an artwork: the artwork with its tools, what they give, and how the figure looks with it. Stays
/// open beside the window for several styles from one plate; undo and redo are its own. Composition only: the draft is
/// a value, the widgets ask for changes of it, the work runs elsewhere.
class ExtractionDialog : public QDialog {
    Q_OBJECT

  public:
    /// Takes the preview.
    ExtractionDialog(FigurePreview* preview, StyleLibrary library, QWidget* parent = nullptr);
    ~ExtractionDialog() override;

    /// Where the style would go; null: nowhere.
    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer, std::optional<std::size_t> node);
    void openArtwork(const std::filesystem::path& file);
    /// A picture, or a file that holds one.
    void paste();

    [[nodiscard]] const ExtractionDraft& draft() const { return history_.current(); }
    [[nodiscard]] const DraftHistory& history() const { return history_; }
    [[nodiscard]] ArtworkCanvas& canvas() { return *canvas_; }
    [[nodiscard]] ArtworkToolBar& tools() { return *tools_; }
    [[nodiscard]] ArtworkToolOptions& toolOptions() { return *options_; }
    [[nodiscard]] ExtractionForm& form() { return *form_; }
    [[nodiscard]] FigurePreview& preview() { return *preview_; }
    [[nodiscard]] StyleCardForm& card() { return *card_; }
    [[nodiscard]] NoticeBar& notices() { return *notices_; }
    [[nodiscard]] QAction* undoAction() const { return undo_; }
    [[nodiscard]] QAction* redoAction() const { return redo_; }
    [[nodiscard]] bool busy() const { return work_->busy(); }
    /// There is a style that has not been added.
    [[nodiscard]] bool unadded() const;

    enum class Answer { discard, cancel };
    /// How the user is asked about a style that has not been added; replaced by tests.
    std::function<Answer()> askAboutUnadded;

    void reject() override; ///< Close and Escape

  Q_SIGNALS:
    void styleAdded(const limner::Style& style);
    void edited(const limner::Edit& edit);

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void build();
    QWidget* buildHead();
    QWidget* buildMiddle();
    QWidget* buildEmptyPage();
    void buildActions();
    void connectWidgets();
    void connectWork();

    void apply(const DraftEdit& edit);
    void showDraft();
    void showActions();
    void chooseTool(ToolKind kind);
    void chooseArtwork();
    void plateOpened(const PlatePtr& plate);
    void outlineFitted(const ExtractionWork::Refined& refined);
    void snapped(const std::optional<Ellipse>& ellipse);
    void wantExtraction();
    void extracted(const ExtractionDraft& of, std::shared_ptr<const ExtractionPictures> pictures, bool whole);
    void extractionFailed(const Error& error);
    void showPictures();
    void showPreview();
    void addStyle(ExtractionWork::Then then);
    void addNow(ExtractionWork::Then then);
    void wasAdded(const Style& style, ExtractionWork::Then then);
    void showProblem(const QString& line);
    [[nodiscard]] QString whyNotUse() const;
    [[nodiscard]] bool mayClose();

    StyleLibrary library_;
    ExtractionWork* work_;
    DraftHistory history_;
    bool ongoing_ = false; ///< a gesture is going on
    PlatePtr plateShown_;
    QString problem_; ///< the last one said

    /// What was extracted last, and of what.
    struct Shown {
        ExtractionDraft of;
        std::shared_ptr<const ExtractionPictures> pictures;
        bool whole = false;
    };
    Shown shown_;
    std::optional<ExtractionDraft> wanted_; ///< what the newest extraction is asked of
    bool wantedWhole_ = false;
    bool failed_ = false;                   ///< there is nothing to extract in what is wanted
    std::optional<ExtractionDraft> adding_; ///< what is being written
    std::optional<ExtractionDraft> added_;
    std::optional<ExtractionWork::Then> addWhenDone_;

    std::shared_ptr<const Figure> figure_;
    std::size_t layer_ = 0;
    std::optional<std::size_t> node_;

    QAction* undo_;
    QAction* redo_;
    QAction* open_;
    QAction* paste_;
    QAction* fit_;
    QAction* pixels_;
    NoticeBar* notices_;
    QStackedWidget* pages_;
    ArtworkCanvas* canvas_;
    ArtworkToolBar* tools_;
    ArtworkToolOptions* options_;
    ExtractionForm* form_;
    FigurePreview* preview_;
    StyleCardForm* card_;
    ProgressStrip* progress_;
    QLabel* zoom_;
};

} // namespace limner
