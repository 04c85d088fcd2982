#pragma once

#include "app/studio/action_table.h"
#include "app/studio/engine.h"
#include "app/studio/studio_document.h"
#include "app/studio/workplace.h"

#include <QMainWindow>
#include <QPointer>

#include <functional>
#include <memory>

class QDockWidget;
class QStackedWidget;
class QToolBar;
class QTimer;
class QToolButton;

namespace limner {

class CleanupForm;
class ExtractionDialog;
class ImportanceForm;
class IslandOverlay;
class Job;
class LabelList;
class LayerList;
class LayerPanel;
class LensOverlay;
class NoticeBar;
class PictureFeed;
class PictureWords;
class PresetMenu;
class ProgressStrip;
class ScissorsOverlay;
class StyleGallery;
class ThemeMenu;
class TransferEditor1d;
class Viewport;
class WelcomePage;
class WindowGallery;
struct ScreenPicture;

/// The studio's window: composes panels, picture and jobs around one document. Nothing long runs on its thread.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(Engine engine);
    ~MainWindow() override;

    /// Each starts a job and returns; a running one of the same sort is cancelled first.
    void openPath(const std::filesystem::path& path);
    void openSample();
    void savePath(const std::filesystem::path& path);
    void usePreset(const QString& id, const QString& name);
    void useTheme(const QString& id, const QString& name);
    /// Reads a label volume for the open scan; its layers stay as they are.
    void openLabelsPath(const std::filesystem::path& path);
    void extractStyle(); ///< opens the dialog that takes styles from artwork, or brings it to the front

    [[nodiscard]] StudioDocument& document() { return *document_; }
    [[nodiscard]] Actions& actions() { return *actions_; }
    [[nodiscard]] Viewport& viewport() { return *viewport_; }
    [[nodiscard]] TransferEditor1d& transferEditor() { return *transfer_; }
    [[nodiscard]] StyleGallery& gallery() { return *gallery_; }
    [[nodiscard]] WindowGallery& styles() { return *styles_; }
    [[nodiscard]] LayerList& layers() { return *layers_; }
    [[nodiscard]] LayerPanel& layerPanel() { return *layerPanel_; }
    [[nodiscard]] LabelList& labels() { return *labels_; }
    [[nodiscard]] ImportanceForm& importance() { return *importance_; }
    [[nodiscard]] LensOverlay& lensOverlay() { return *lens_; }
    [[nodiscard]] CleanupForm& cleanup() { return *cleanup_; }
    [[nodiscard]] ScissorsOverlay& scissors() { return *scissors_; }
    [[nodiscard]] IslandOverlay& islandTool() { return *island_; }
    [[nodiscard]] NoticeBar& notices() { return *notices_; }
    [[nodiscard]] ExtractionDialog* extraction() const; ///< null while it is not open
    /// Whether a job of the window (import, labels, save, preset, theme) is under way.
    [[nodiscard]] bool busy() const;

    enum class Answer { save, discard, cancel };
    /// How the user is asked about unsaved changes; replaced by tests.
    std::function<Answer()> askAboutChanges;

  Q_SIGNALS:
    void documentOpened();
    void documentSaved();
    void labelsOpened();

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    static QDockWidget* dock(QMainWindow* window, const char* name, const QString& title, QWidget* content,
                             Qt::DockWidgetArea area);
    void buildPanels();
    /// The clean-up panel and its two tools over the picture.
    void buildCleanup();
    void connectCleanup();
    void showCleanup();
    void buildStyles();
    /// What the features are given, and the features (window_features.cpp).
    [[nodiscard]] Workplace workplace();
    void buildFeatures();
    void arrangePanels();
    void buildMenus();
    void buildToolBar();
    QToolButton* addLookButton(QToolBar* bar, const QString& text, const QString& tip, QMenu* menu);
    void buildStatusBar();
    void connectActions();
    void connectPanels();
    void loadResources();
    void addLens();
    /// The lens that is chosen in the panel, over the picture while the panel is seen.
    void showLens();
    /// Small pictures of the measures, once the panel is seen and the figure has rested.
    void wantMeasures();
    void pictureMeasures();

    void documentChanged();
    void showTitle();
    void wantPicture();
    /// Shows a figure in the document's place; null: the document's own again.
    void showInstead(const std::shared_ptr<const Figure>& figure);
    void pictureArrived(const ScreenPicture& picture);

    void startOpening(const QString& name, std::function<Document(Task&)> load, Opened how = Opened::fresh);
    void chooseAndOpen();
    void chooseFolderAndOpen();
    void chooseAndOpenLabels();
    void save();
    void saveAs();
    void copyPicture();
    void showError(const Error& error);
    void showAbout();
    Job* startJob(QPointer<Job>& slot, const QString& name, std::function<void(Task&)> work);
    /// Runs `then` once unsaved changes are saved or given up.
    void afterChangesAreSafe(std::function<void()> then);
    [[nodiscard]] std::vector<std::byte> thumbnail() const;
    void remember(const std::filesystem::path& path);
    void showRecent();

    Engine engine_;
    StudioDocument* document_;
    Actions* actions_;
    PictureFeed* feed_;
    QStackedWidget* pages_;
    WelcomePage* welcome_;
    NoticeBar* notices_;
    Viewport* viewport_;
    LayerPanel* layerPanel_;
    LayerList* layers_; ///< of the panel
    LabelList* labels_;
    TransferEditor1d* transfer_;
    StyleGallery* gallery_;
    WindowGallery* styles_;
    ImportanceForm* importance_;
    QDockWidget* importanceDock_;
    bool importanceSeen_ = false;
    QTimer* measuresRest_;
    std::shared_ptr<const Figure> measured_; ///< what the small pictures show
    LensOverlay* lens_;
    CleanupForm* cleanup_;
    ScissorsOverlay* scissors_;
    IslandOverlay* island_;
    QPointer<ExtractionDialog> extraction_;
    PresetMenu* presets_;
    ThemeMenu* themes_;
    QToolButton* presetButton_ = nullptr;
    QToolButton* themeButton_ = nullptr;
    QMenu* recent_;
    ProgressStrip* progress_;
    PictureWords* facts_;
    QPointer<Job> openJob_, saveJob_, lookJob_, labelJob_, resourceJob_, measuresJob_;
    std::shared_ptr<const Figure> instead_;           ///< shown in the document's place: a style held over it
    std::shared_ptr<const ScreenPicture> ownPicture_; ///< final one of the document's figure, meanwhile
    std::shared_ptr<const Figure> wanted_;            ///< what the newest request to the feed shows
    QSize wantedPixels_;
    bool wantedDraft_ = false;
    std::function<void()> afterSave_;
};

} // namespace limner
