#include "app/studio/main_window.h"

#include "app/studio/welcome_page.h"
#include "app/studio/window_gallery.h"
#include "core/figure/figure_json.h"
#include "widgets/importance_form.h"
#include "widgets/job.h"
#include "widgets/label_list.h"
#include "widgets/layer_list.h"
#include "widgets/layer_panel.h"
#include "widgets/layer_rows.h"
#include "widgets/lens_form.h"
#include "widgets/lens_overlay.h"
#include "widgets/notice_bar.h"
#include "widgets/picture_feed.h"
#include "widgets/picture_words.h"
#include "widgets/preset_menu.h"
#include "widgets/progress_strip.h"
#include "widgets/style_gallery.h"
#include "widgets/theme_menu.h"
#include "widgets/transfer_editor_1d.h"
#include "widgets/viewport.h"

#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace limner {
namespace {

constexpr QSize kFirstSize(1400, 900);

} // namespace

MainWindow::MainWindow(Engine engine)
    : engine_(std::move(engine)), document_(new StudioDocument(this)), actions_(new Actions(this)),
      feed_(new PictureFeed(engine_.plan, engine_.makeBackend(), this)) {
    setObjectName("studio");
    setAcceptDrops(true);
    buildPanels();
    buildCleanup();
    buildStyles();
    buildStatusBar();
    buildFeatures();
    buildMenus();
    buildToolBar();
    connectActions();
    connectPanels();
    connect(document_, &StudioDocument::changed, this, &MainWindow::documentChanged);
    connect(feed_, &PictureFeed::arrived, this, &MainWindow::pictureArrived);
    connect(feed_, &PictureFeed::failed, this, [this](const Error& error) {
        notices_->setNotices({QString::fromUtf8(error.what())}, NoticeBar::Kind::problem);
    });
    connect(feed_, &PictureFeed::preparing, progress_, qOverload<const QString&, double>(&ProgressStrip::show));
    resize(kFirstSize);
    showRecent();
    documentChanged();
    loadResources();
}

MainWindow::~MainWindow() {
    // Workers first: they hold what the members below give them.
    for (Job* job : findChildren<Job*>())
        delete job;
    delete feed_;
}

QDockWidget* MainWindow::dock(QMainWindow* window, const char* name, const QString& title, QWidget* content,
                              Qt::DockWidgetArea area) {
    auto* result = new QDockWidget(title, window);
    result->setObjectName(name); // saved layouts go by it
    result->setWidget(content);
    result->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable |
                        QDockWidget::DockWidgetClosable);
    window->addDockWidget(area, result);
    return result;
}

void MainWindow::buildPanels() {
    pages_ = new QStackedWidget;
    welcome_ = new WelcomePage;
    viewport_ = new Viewport;
    lens_ = new LensOverlay(viewport_);
    notices_ = new NoticeBar;
    pages_->addWidget(welcome_);
    pages_->addWidget(viewport_);
    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(notices_);
    layout->addWidget(pages_, 1);
    setCentralWidget(centre);

    layerPanel_ = new LayerPanel;
    layers_ = layerPanel_->layers();
    labels_ = new LabelList;
    auto* layersAndLabels = new QWidget;
    auto* stack = new QVBoxLayout(layersAndLabels);
    stack->setContentsMargins(0, 0, 0, 0);
    stack->setSpacing(0);
    stack->addWidget(layerPanel_, 2);
    stack->addWidget(labels_, 1);
    transfer_ = new TransferEditor1d;
    gallery_ = new StyleGallery;
    importance_ = new ImportanceForm;
    measuresRest_ = new QTimer(this);
    measuresRest_->setSingleShot(true);
    dock(this, "dock.styles", tr("Styles"), gallery_, Qt::LeftDockWidgetArea);
    dock(this, "dock.layers", tr("Layers"), layersAndLabels, Qt::RightDockWidgetArea);
    QDockWidget* transfer = dock(this, "dock.transfer", tr("Transfer function"), transfer_, Qt::RightDockWidgetArea);
    importanceDock_ = dock(this, "dock.importance", tr("Importance"), importance_, Qt::RightDockWidgetArea);
    tabifyDockWidget(transfer, importanceDock_);
    transfer->raise();
    std::vector<QWidget*> order{viewport_, lens_};
    const std::vector<QWidget*> ofGallery = gallery_->tabOrder();
    order.insert(order.end(), ofGallery.begin(), ofGallery.end());
    order.insert(order.end(), {layers_->list(), labels_->search(), labels_->list(), transfer_->canvas()});
    for (std::size_t i = 1; i < order.size(); ++i)
        setTabOrder(order[i - 1], order[i]);
}

void MainWindow::buildStyles() {
    styles_ = new WindowGallery({.window = this,
                                 .document = document_,
                                 .actions = actions_,
                                 .gallery = gallery_,
                                 .viewport = viewport_,
                                 .transfer = transfer_,
                                 .layers = layers_,
                                 .notices = notices_},
                                StyleLibrary::userFolder(), this);
    connect(styles_, &WindowGallery::failed, this, &MainWindow::showError);
    connect(styles_, &WindowGallery::told, this,
            [this](const QString& message) { statusBar()->showMessage(message, 6000); });
    connect(styles_, &WindowGallery::showInstead, this, &MainWindow::showInstead);
}

void MainWindow::buildMenus() {
    presets_ = new PresetMenu(this);
    themes_ = new ThemeMenu(this);
    QHash<QString, QMenu*> menus;
    const auto add = [&](const QString& id, const QString& title) { menus[id] = menuBar()->addMenu(title); };
    add("file", tr("&File"));
    add("edit", tr("&Edit"));
    add("view", tr("&View"));
    menuBar()->addMenu(presets_);
    menuBar()->addMenu(themes_);
    add("looks", tr("&Looks"));
    add("styles", tr("&Styles"));
    add("background", tr("Back&ground"));
    add("window", tr("&Window"));
    add("help", tr("&Help"));
    for (const ActionRow& row : actionTable()) {
        const QString id = row.id;
        menus[id.section('.', 0, 0)]->addAction(actions_->at(id));
    }
    for (const QDockWidget* panel : findChildren<QDockWidget*>())
        menus["window"]->addAction(panel->toggleViewAction());
    recent_ = new QMenu(this);
    actions_->at("file.recent")->setMenu(recent_);
    actions_->at("view.free-turning")->setCheckable(true);
}

void MainWindow::buildToolBar() {
    auto* bar = new QToolBar(tr("Main tool bar"), this);
    bar->setObjectName("toolbar.main");
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    addToolBar(bar);
    QString menu;
    for (const ActionRow& row : actionTable()) {
        if (!*row.brief)
            continue;
        const QString of = QString(row.id).section('.', 0, 0);
        if (!menu.isEmpty() && of != menu) {
            bar->addSeparator();
            if (of == "view") { // looks go between history and views
                presetButton_ = addLookButton(bar, tr("Preset"), tr("Lay a ready-made look over the figure"), presets_);
                themeButton_ = addLookButton(bar, tr("Theme"), tr("Exchange all styles and the paper"), themes_);
                bar->addSeparator();
            }
        }
        menu = of;
        bar->addAction(actions_->at(row.id));
    }
}

QToolButton* MainWindow::addLookButton(QToolBar* bar, const QString& text, const QString& tip, QMenu* menu) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setToolTip(tip);
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    bar->addWidget(button);
    return button;
}

void MainWindow::buildStatusBar() {
    progress_ = new ProgressStrip;
    facts_ = new PictureWords;
    connect(facts_, &PictureWords::warningsWanted, this,
            [this](const QStringList& warnings) { notices_->setNotices(warnings, NoticeBar::Kind::information); });
    statusBar()->addPermanentWidget(progress_);
    statusBar()->addPermanentWidget(facts_);
}

void MainWindow::connectActions() {
    const auto on = [this](const char* id, auto handler) {
        connect(actions_->at(id), &QAction::triggered, this, handler);
    };
    on("file.open", [this] { chooseAndOpen(); });
    on("file.open-folder", [this] { chooseFolderAndOpen(); });
    on("file.open-labels", [this] { chooseAndOpenLabels(); });
    on("file.sample", [this] { openSample(); });
    on("file.save", [this] { save(); });
    on("file.save-as", [this] { saveAs(); });
    on("file.close", [this] { afterChangesAreSafe([this] { document_->close(); }); });
    on("file.quit", [this] { close(); });
    on("edit.undo", [this] { document_->undo(); });
    on("edit.redo", [this] { document_->redo(); });
    on("edit.copy-picture", [this] { copyPicture(); });
    const std::pair<const char*, StandardView> sides[] = {{"view.anterior", StandardView::anterior},
                                                          {"view.posterior", StandardView::posterior},
                                                          {"view.left", StandardView::left},
                                                          {"view.right", StandardView::right},
                                                          {"view.superior", StandardView::superior},
                                                          {"view.inferior", StandardView::inferior},
                                                          {"view.three-quarter", StandardView::threeQuarter}};
    for (const auto& [id, side] : sides)
        on(id, [this, view = side] { viewport_->showSide(view); });
    on("view.fit", [this] { viewport_->fit(); });
    constexpr double kZoomStep = 0.8;
    on("view.zoom-in", [this] { viewport_->zoomBy(kZoomStep); });
    on("view.zoom-out", [this] { viewport_->zoomBy(1 / kZoomStep); });
    on("view.free-turning",
       [this](bool freely) { viewport_->setTurnMode(freely ? TurnMode::trackball : TurnMode::turntable); });
    on("edit.add-lens", [this] { addLens(); });
    connectCleanup();
    on("styles.extract", [this] { extractStyle(); });
    on("help.about", [this] { showAbout(); });
    connect(presets_, &PresetMenu::chosen, this, &MainWindow::usePreset);
    connect(themes_, &ThemeMenu::chosen, this, &MainWindow::useTheme);
    connect(welcome_, &WelcomePage::openWanted, this, &MainWindow::chooseAndOpen);
    connect(welcome_, &WelcomePage::openFolderWanted, this, &MainWindow::chooseFolderAndOpen);
    connect(welcome_, &WelcomePage::sampleWanted, this, &MainWindow::openSample);
    connect(welcome_, &WelcomePage::recentWanted, this, [this](const QString& path) { openPath(path.toStdString()); });
}

void MainWindow::connectPanels() {
    const auto apply = [this](const Edit& edit) { document_->apply(edit); };
    connect(viewport_, &Viewport::edited, this, apply);
    connect(layerPanel_, &LayerPanel::edited, this, apply);
    connect(labels_, &LabelList::edited, this, apply);
    connect(transfer_, &TransferEditor1d::edited, this, apply);
    connect(styles_, &WindowGallery::edited, this, apply);
    connect(importance_, &ImportanceForm::edited, this, apply);
    connect(lens_, &LensOverlay::edited, this, apply);
    connect(lens_, &LensOverlay::left, this, [this] { importance_->lenses()->select(std::nullopt); });
    connect(importance_->lenses(), &LensForm::lensSelected, this, &MainWindow::showLens);
    connect(importanceDock_, &QDockWidget::visibilityChanged, this, [this](bool seen) {
        importanceSeen_ = seen; // isVisible would be true behind another tab
        showLens();
        wantMeasures();
    });
    connect(measuresRest_, &QTimer::timeout, this, &MainWindow::pictureMeasures);
    connect(viewport_, &Viewport::picturePixelsChanged, this, &MainWindow::wantPicture);
    connect(layerPanel_, &LayerPanel::layerSelected, this, [this](std::size_t layer) {
        labels_->setFigure(document_->figure(), layer);
        transfer_->setFigure(document_->figure(), layer);
        styles_->showFigure();
    });
    connect(transfer_, &TransferEditor1d::selectionChanged, styles_, &WindowGallery::showFigure);
}

void MainWindow::documentChanged() {
    const std::shared_ptr<const Figure> figure = document_->figure();
    const bool any = figure != nullptr;
    pages_->setCurrentWidget(any ? static_cast<QWidget*>(viewport_) : welcome_);
    for (const char* id :
         {"file.save", "file.save-as", "file.export", "file.close", "edit.copy-picture", "view.anterior",
          "view.posterior", "view.left", "view.right", "view.superior", "view.inferior", "view.three-quarter",
          "view.fit", "view.zoom-in", "view.zoom-out", "edit.add-lens", "edit.scissors", "edit.keep-island"})
        actions_->at(id)->setEnabled(any);
    const bool drawable = any && figure->volume && figure->volume->data;
    presets_->setEnabled(drawable);
    presets_->setLabelsThere(drawable && figure->labels && figure->labels->data);
    presetButton_->setEnabled(drawable);
    themes_->setEnabled(any);
    themeButton_->setEnabled(any);
    actions_->at("file.open-labels")->setEnabled(drawable);
    const History& history = document_->history();
    const auto named = [](const QString& verb, const std::string& label) {
        return label.empty() ? verb : tr("%1 “%2”").arg(verb, QString::fromStdString(label));
    };
    for (const auto& [id, can, verb, label] :
         {std::tuple{"edit.undo", any && history.canUndo(), tr("&Undo"), history.undoLabel()},
          std::tuple{"edit.redo", any && history.canRedo(), tr("&Redo"), history.redoLabel()}}) {
        QAction* action = actions_->at(id);
        const QString brief = action->iconText();
        action->setEnabled(can);
        action->setText(named(verb, can ? label : std::string()));
        action->setIconText(brief);
    }
    layerPanel_->setFigure(figure);
    labels_->setFigure(figure, layers_->selectedLayer());
    transfer_->setFigure(figure, layers_->selectedLayer());
    styles_->showFigure();
    viewport_->setFigure(figure);
    importance_->setFigure(figure);
    showLens();
    showCleanup();
    showTitle();
    wantPicture();
}

void MainWindow::showTitle() {
    const QString program = tr("Limner Studio");
    const QString name =
        document_->holder().isEmpty() ? document_->name() : tr("%1 (open elsewhere)").arg(document_->name());
    setWindowTitle(document_->empty() ? program : tr("%1[*] – %2").arg(name, program));
    setWindowModified(document_->dirty());
}

void MainWindow::wantPicture() {
    const std::shared_ptr<const Figure> figure = instead_ ? instead_ : document_->figure();
    const QSize pixels = viewport_->picturePixels();
    const bool draft = document_->gestureOngoing();
    if (!figure || !viewport_->isVisible()) {
        feed_->clear();
        wanted_.reset();
        facts_->clear();
        return;
    }
    const bool same = wanted_ && wantedPixels_ == pixels && wantedDraft_ == draft &&
                      (wanted_ == figure || diff(*wanted_, *figure) == ChangeCost::none);
    if (same)
        return;
    wanted_ = figure;
    wantedPixels_ = pixels;
    wantedDraft_ = draft;
    feed_->want(figure, pixels, draft);
}

void MainWindow::showInstead(const std::shared_ptr<const Figure>& figure) {
    const auto own = document_->figure();
    const auto& picture = viewport_->picture();
    if (figure && !instead_ && picture && picture->facts.final)
        ownPicture_ = std::make_shared<const ScreenPicture>(*picture);
    instead_ = own ? figure : nullptr;
    const auto before = instead_ ? nullptr : std::exchange(ownPicture_, nullptr);
    if (before && own && before->image.size() == viewport_->picturePixels() &&
        diff(*before->plan->figure, *own) == ChangeCost::none) { // nothing has come of it: the old picture still holds
        feed_->clear();
        wanted_ = own;
        wantedPixels_ = before->image.size();
        wantedDraft_ = false;
        pictureArrived(*before);
    } else {
        wantPicture();
    }
}

void MainWindow::pictureArrived(const ScreenPicture& picture) {
    const auto figure = document_->figure();
    const bool ours = figure && figure->volume && picture.plan->figure->volume &&
                      picture.plan->figure->volume->data == figure->volume->data;
    if (!ours) // of a document that has been closed since
        return;
    progress_->show({}, 1);
    viewport_->setPicture(picture);
    facts_->showPicture(picture);
    if (picture.facts.final)
        wantMeasures();
}

} // namespace limner
