#include "app/studio/variant_dialog.h"

#include "app/studio/studio_document.h"
#include "core/figure/look.h"
#include "core/figure/presets.h"
#include "core/figure/themes.h"
#include "core/project/look_library.h"
#include "widgets/job.h"
#include "widgets/style_pictures.h"
#include "widgets/viewport.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMainWindow>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limner {
namespace {

constexpr int kEdge = 190; // pixels of a picture: large enough to judge, small enough for a dozen on the screen
constexpr int kStandardCount = 6;
constexpr int kMostCount = 24;
constexpr QSize kSize(860, 620);
constexpr double kFarthest = 1e6;

/// A preset or look that does not fit the scan is left out: its reason is in the menu's message.
void addLook(std::vector<Variant>& variants, const std::string& name, const std::function<Figure()>& make) {
    try {
        variants.push_back({name, make()});
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::cancelled)
            throw;
    }
}

} // namespace

VariantDialog::VariantDialog(const Workplace& place)
    : QDialog(place.window), place_(place), painter_(std::make_shared<StylePictures>()), source_(new QComboBox),
      from_(new QDoubleSpinBox), to_(new QDoubleSpinBox), count_(new QSpinBox), sheet_(new QListWidget),
      word_(new QLabel) {
    setWindowTitle(tr("Variants"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(kSize);
    buildLayout();
    fillSources();
    connect(source_, &QComboBox::currentIndexChanged, this, [this] {
        showRange();
        makeSheet();
    });
    for (QDoubleSpinBox* end : {from_, to_})
        connect(end, &QDoubleSpinBox::valueChanged, this, &VariantDialog::makeSheet);
    connect(count_, &QSpinBox::valueChanged, this, &VariantDialog::makeSheet);
    connect(sheet_, &QListWidget::itemActivated, this, &VariantDialog::take);
    showRange();
    makeSheet();
}

VariantDialog::~VariantDialog() {
    if (job_)
        job_->cancel();
}

void VariantDialog::buildLayout() {
    source_->setAccessibleName(tr("What differs"));
    source_->setToolTip(tr("Other looks, or a number of the figure at several values"));
    for (const auto& [field, name] : {std::pair{from_, tr("From")}, {to_, tr("To")}}) {
        field->setRange(-kFarthest, kFarthest);
        field->setDecimals(3);
        field->setKeyboardTracking(false);
        field->setPrefix(name + " ");
        field->setAccessibleName(name);
    }
    count_->setRange(2, kMostCount);
    count_->setValue(kStandardCount);
    count_->setKeyboardTracking(false);
    count_->setSuffix(tr(" pictures"));
    count_->setAccessibleName(tr("How many"));
    sheet_->setViewMode(QListView::IconMode);
    sheet_->setIconSize({kEdge, kEdge});
    sheet_->setResizeMode(QListView::Adjust);
    sheet_->setMovement(QListView::Static);
    sheet_->setSpacing(8);
    sheet_->setAccessibleName(tr("Variants"));
    auto* head = new QHBoxLayout;
    head->addWidget(source_, 1);
    head->addWidget(from_);
    head->addWidget(to_);
    head->addWidget(count_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* takeIt = buttons->addButton(tr("&Take"), QDialogButtonBox::ApplyRole);
    takeIt->setToolTip(tr("Make the chosen variant the figure (double click does it too)"));
    auto* foot = new QHBoxLayout;
    foot->addWidget(word_, 1);
    foot->addWidget(buttons);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(head);
    layout->addWidget(sheet_, 1);
    layout->addLayout(foot);
    connect(takeIt, &QPushButton::clicked, this, &VariantDialog::take);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void VariantDialog::fillSources() {
    source_->addItems({tr("Themes"), tr("Presets"), tr("My looks")});
    source_->insertSeparator(firstSetting);
    if (const auto figure = place_.document->figure())
        settings_ = variedSettings(*figure);
    for (const VariedSetting& setting : settings_)
        source_->addItem(QString::fromStdString(setting.label), QString::fromStdString(setting.pointer));
}

void VariantDialog::showRange() {
    const int index = source_->currentIndex() - firstSetting - 1; // behind the separator
    const bool setting = index >= 0 && static_cast<std::size_t>(index) < settings_.size();
    for (QWidget* field : std::initializer_list<QWidget*>{from_, to_, count_})
        field->setVisible(setting);
    if (!setting)
        return;
    const VariedSetting& chosen = settings_[static_cast<std::size_t>(index)];
    const QString unit = QString::fromStdString(chosen.unit);
    for (auto [field, value] : {std::pair{from_, chosen.from}, {to_, chosen.to}}) {
        const QSignalBlocker quiet(field);
        field->setSuffix(unit.isEmpty() ? QString() : " " + unit);
        field->setValue(value);
    }
}

std::function<std::vector<Variant>(Task&)> VariantDialog::maker() const {
    const int index = source_->currentIndex() - firstSetting - 1;
    if (index >= 0) {
        VariedSetting setting = settings_[static_cast<std::size_t>(index)];
        setting.from = std::min(from_->value(), to_->value());
        setting.to = std::max(from_->value(), to_->value());
        return [base = base_, setting, count = count_->value()](Task&) { return variantsOf(*base, setting, count); };
    }
    return [base = base_, source = source_->currentIndex()](Task& task) {
        std::vector<Variant> variants;
        std::vector<std::string> notes;
        if (source == themes)
            for (const ThemeCard& card : bundledThemes())
                addLook(variants, card.name, [&] { return withTheme(*base, card.id, notes); });
        else if (source == presets)
            for (const PresetCard& card : bundledPresets())
                addLook(variants, card.name, [&] { return withPreset(*base, card.id, notes); });
        else
            for (const LookCard& look : LookLibrary(LookLibrary::standardFolder()).list().cards)
                addLook(variants, look.name, [&] {
                    return withLook(*base, LookLibrary(LookLibrary::standardFolder()).load(look.id, task), notes);
                });
        return variants;
    };
}

void VariantDialog::makeSheet() {
    const auto& shown = place_.viewport->picture();
    base_ = place_.document->figure();
    sheet_->clear();
    if (!shown || !base_) {
        word_->setText(tr("Open a scan first"));
        return;
    }
    made_ = std::make_shared<Made>();
    word_->setText(tr("Drawing…"));
    Job* job = place_.makeJob(job_, tr("Variants"),
                              [made = made_, make = maker(), painter = painter_, plan = shown->plan](Task& task) {
                                  std::vector<Variant> variants = make(task);
                                  const std::size_t count = variants.size();
                                  {
                                      const std::lock_guard lock(made->mutex);
                                      made->variants = std::move(variants);
                                  }
                                  for (std::size_t i = 0; i < count; ++i) {
                                      QImage picture = painter->figure(*plan, made->variants[i].figure, kEdge, task);
                                      const std::lock_guard lock(made->mutex);
                                      made->pictures.push_back(std::move(picture));
                                      task.progress(static_cast<double>(i + 1) / static_cast<double>(count));
                                  }
                              });
    connect(job, qOverload<const QString&, double>(&Job::progressed), this, &VariantDialog::showMade);
    connect(job, &Job::finished, this, [this] {
        job_.clear();
        showMade();
        word_->setText(sheet_->count() ? tr("A double click takes one; Undo gives it back")
                                       : tr("There is nothing of this kind for this figure"));
    });
    job->start();
}

void VariantDialog::showMade() {
    const std::lock_guard lock(made_->mutex);
    for (auto i = static_cast<std::size_t>(sheet_->count()); i < made_->pictures.size(); ++i) {
        auto* item = new QListWidgetItem(QIcon(QPixmap::fromImage(made_->pictures[i])),
                                         QString::fromStdString(made_->variants[i].name));
        item->setToolTip(item->text());
        sheet_->addItem(item);
    }
}

void VariantDialog::take() {
    const int row = sheet_->currentRow();
    const auto figure = place_.document->figure();
    if (row < 0 || !figure || !made_)
        return;
    const std::lock_guard lock(made_->mutex);
    const Variant& variant = made_->variants[static_cast<std::size_t>(row)];
    Edit edit{variant.figure, tr("Take variant %1").arg(QString::fromStdString(variant.name)).toStdString(), {}, false};
    edit.figure.camera = figure->camera; // it may have been turned meanwhile
    edit.figure.output = figure->output;
    edit.figure.annotations = figure->annotations;
    place_.document->apply(edit);
}

} // namespace limner
