#include "widgets/accuracy_panel.h"

#include "widgets/accuracy_chart.h"
#include "widgets/accuracy_words.h"
#include "widgets/form_parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace limner {
namespace {

constexpr int kKeyRestMs = 500;
constexpr int kProgressSteps = 1000; // finer than a bar's pixels

int named() { return static_cast<int>(accuracy::namedTolerances().size()); }

QLabel* paragraph(const QString& name) {
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setAccessibleName(name);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setFocusPolicy(Qt::NoFocus);
    return label;
}

QPushButton* button(const QString& text, const QString& tip) {
    auto* result = new QPushButton(text);
    result->setToolTip(tip);
    result->setAutoDefault(false);
    return result;
}

QTableWidgetItem* cell(const QString& text, const QString& tip) {
    auto* item = new QTableWidgetItem(text);
    item->setToolTip(tip);
    return item;
}

double largestOf(ErrorMetric metric) { return metric == ErrorMetric::ciede2000 ? 100 : 1; }

} // namespace

AccuracyPanel::AccuracyPanel(QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal)), number_(new QDoubleSpinBox), metric_(new QComboBox),
      find_(button(tr("Find settings"), tr("Find the settings that keep this error in the least time, and set them"))),
      answer_(paragraph(tr("What was found"))),
      study_(button(tr("Study"), tr("Measure what every setting costs in error and in time"))), seconds_(new QSpinBox),
      report_(button(tr("Save report…"), tr("Write the study as a page with charts, as a table or as JSON"))),
      findings_(paragraph(tr("What the study found"))), chart_(new AccuracyChart), choices_(new QTableWidget(0, 4)),
      map_(new QCheckBox(tr("Show error over the picture"))),
      measure_(button(tr("Measure savings"), tr("Draw the picture with and without what it does not need, by turns, "
                                                "for some seconds"))),
      savings_(paragraph(tr("What leaving out saves"))) {
    foot_ = buildFoot();
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(8, 8, 8, 8);
    buildTolerance(column);
    column->addSpacing(6);
    buildMap(column);
    column->addSpacing(6);
    buildStudy(column);
    column->addSpacing(6);
    buildSavings(column);
    column->addStretch(1);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->setSpacing(0);
    whole->addWidget(scrolling(content), 1);
    whole->addWidget(foot_);
    setMinimumWidth(content->minimumSizeHint().width());
    rest_.setSingleShot(true);
    rest_.setInterval(kKeyRestMs);
    connectSlider();
    connect(find_, &QPushButton::clicked, this, &AccuracyPanel::wantSettings);
    connect(study_, &QPushButton::clicked, this, &AccuracyPanel::studyWanted);
    connect(report_, &QPushButton::clicked, this, &AccuracyPanel::reportWanted);
    connect(stop_, &QPushButton::clicked, this, &AccuracyPanel::stopWanted);
    connect(map_, &QCheckBox::clicked, this, &AccuracyPanel::mapWanted);
    connect(measure_, &QPushButton::clicked, this, &AccuracyPanel::savingsWanted);
    showTolerance({});
    forget();
    setFigure(nullptr);
}

void AccuracyPanel::buildSlider(QGridLayout* grid) {
    slider_->setRange(0, named());
    slider_->setPageStep(1);
    slider_->setTickInterval(1);
    slider_->setTickPosition(QSlider::TicksBelow);
    slider_->setAccessibleName(tr("Tolerance"));
    slider_->setToolTip(tr("How far the picture may be from one without any error of sampling; the settings for it are "
                           "found when you let go"));
    leaveWheelToPanel(slider_);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);
    // Names stand in columns of two, the slider from the middle of the first to the middle of the last.
    grid->addWidget(slider_, 0, 1, 1, 2 * named());
    for (int i = 0; i <= named(); ++i) {
        const QString name = i < named()
                                 ? toleranceName(accuracy::namedTolerances()[static_cast<std::size_t>(i)].tolerance)
                                 : tr("Custom");
        auto* label = new QLabel(name);
        label->setAlignment(Qt::AlignHCenter);
        grid->addWidget(label, 1, 2 * i, 1, 2);
        grid->setColumnStretch(2 * i, 1);
        grid->setColumnStretch(2 * i + 1, 1);
    }
}

void AccuracyPanel::buildNumber() {
    number_->setDecimals(4);
    number_->setRange(1e-4, largestOf(ErrorMetric::ciede2000));
    number_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    number_->setKeyboardTracking(false);
    number_->setAccessibleName(tr("Largest error"));
    number_->setToolTip(tr("The error that the picture may have; another number is a tolerance of your own"));
    leaveWheelToPanel(number_);
    const std::pair<ErrorMetric, QString> metrics[] = {
        {ErrorMetric::ciede2000, tr("Colour difference CIEDE2000 that 95 % of the pixels stay below; 1 is just seen")},
        {ErrorMetric::largest, tr("Largest difference of a channel of a pixel, as a share of the full range")},
        {ErrorMetric::rootMeanSquare, tr("Root of the mean square of the differences, as a share of the full range")}};
    for (const auto& [metric, tip] : metrics) {
        metric_->addItem(metricName(metric), static_cast<int>(metric));
        metric_->setItemData(metric_->count() - 1, tip, Qt::ToolTipRole);
    }
    metric_->setAccessibleName(tr("Measured as"));
    metric_->setToolTip(tr("What the number bounds"));
    metric_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    leaveWheelToPanel(metric_);
}

void AccuracyPanel::buildTolerance(QVBoxLayout* column) {
    column->addWidget(heading(tr("Tolerance")));
    auto* grid = new QGridLayout;
    buildSlider(grid);
    column->addLayout(grid);
    buildNumber();
    QFormLayout* form = formLayout();
    addLabelled(form, tr("Error at most"), number_);
    addLabelled(form, tr("Measured as"), metric_);
    column->addLayout(form);
    column->addWidget(find_);
    column->addWidget(answer_);
}

void AccuracyPanel::buildStudy(QVBoxLayout* column) {
    column->addWidget(heading(tr("Error against run time")));
    seconds_->setRange(5, 3600);
    seconds_->setValue(60);
    seconds_->setSuffix(tr(" s"));
    seconds_->setAccessibleName(tr("Time for the study"));
    seconds_->setToolTip(tr("Nothing new is measured after so many seconds"));
    leaveWheelToPanel(seconds_);
    auto* row = new QHBoxLayout;
    row->addWidget(study_, 1);
    row->addWidget(seconds_);
    row->addWidget(report_, 1);
    column->addLayout(row);
    column->addWidget(findings_);
    column->addWidget(chart_);
    choices_->setAccessibleName(tr("Cheapest settings for each tolerance"));
    choices_->setHorizontalHeaderLabels({tr("Tolerance"), tr("Delivered"), tr("Picture"), tr("Settings")});
    choices_->horizontalHeaderItem(1)->setToolTip(tr("The error on places that the search had not seen"));
    choices_->horizontalHeaderItem(2)->setToolTip(tr("Time that the whole picture takes"));
    choices_->verticalHeader()->hide();
    choices_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    choices_->horizontalHeader()->setStretchLastSection(true);
    choices_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    choices_->setSelectionBehavior(QAbstractItemView::SelectRows);
    choices_->setTabKeyNavigation(false);
    choices_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    choices_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    choices_->setWordWrap(true);
    column->addWidget(choices_);
}

void AccuracyPanel::buildMap(QVBoxLayout* column) {
    map_->setToolTip(
        tr("Draws the picture with everything at its best and lays over it how far each pixel is off, until "
           "the figure or the view changes"));
    column->addWidget(map_);
}

void AccuracyPanel::buildSavings(QVBoxLayout* column) {
    column->addWidget(heading(tr("What the picture does without")));
    column->addWidget(measure_);
    column->addWidget(savings_);
}

QWidget* AccuracyPanel::buildFoot() {
    auto* foot = new QWidget;
    doing_ = new QLabel;
    progress_ = new QProgressBar;
    progress_->setRange(0, kProgressSteps);
    progress_->setTextVisible(false);
    progress_->setMaximumHeight(10);
    progress_->setAccessibleName(tr("Progress"));
    stop_ = button(tr("Stop"), tr("Stop this; nothing is left behind"));
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(doing_);
    row->addWidget(progress_, 1);
    row->addWidget(stop_);
    return foot;
}

void AccuracyPanel::connectSlider() {
    connect(slider_, &QSlider::sliderPressed, this, [this] { pressedAt_ = slider_->value(); });
    connect(slider_, &QSlider::valueChanged, this, &AccuracyPanel::sliderMoved);
    connect(slider_, &QSlider::sliderReleased, this, [this] {
        if (slider_->value() != pressedAt_ && slider_->value() < named())
            wantSettings();
    });
    connect(&rest_, &QTimer::timeout, this, &AccuracyPanel::wantSettings);
    connect(number_, &QDoubleSpinBox::valueChanged, this, [this] {
        const QSignalBlocker quiet(slider_);
        slider_->setValue(named());
    });
    connect(metric_, &QComboBox::activated, this, &AccuracyPanel::metricChosen);
}

void AccuracyPanel::sliderMoved() {
    rest_.stop();
    if (slider_->value() == named()) // the number is the user's to write
        return;
    takeNumber(accuracy::namedTolerances()[static_cast<std::size_t>(slider_->value())].tolerance);
    if (!slider_->isSliderDown())
        rest_.start();
}

/// A number of one measure says nothing in another one: a usual number of the chosen one takes its place.
void AccuracyPanel::metricChosen() {
    const auto metric = static_cast<ErrorMetric>(metric_->currentData().toInt());
    constexpr double kOneStepOfEightBits = 1.0 / 255;
    const double value = metric == ErrorMetric::ciede2000 ? accuracy::Tolerance{}.value : kOneStepOfEightBits;
    takeNumber({metric, value});
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(placeOfTolerance({metric, value})));
}

void AccuracyPanel::takeNumber(const accuracy::Tolerance& tolerance) {
    const QSignalBlocker quiet[] = {QSignalBlocker(number_), QSignalBlocker(metric_)};
    metric_->setCurrentIndex(metric_->findData(static_cast<int>(tolerance.metric)));
    number_->setMaximum(largestOf(tolerance.metric));
    number_->setValue(tolerance.value);
}

void AccuracyPanel::showTolerance(const accuracy::Tolerance& tolerance) {
    rest_.stop();
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(placeOfTolerance(tolerance)));
    takeNumber(tolerance);
}

accuracy::Tolerance AccuracyPanel::asked() const {
    if (slider_->value() < named()) // exactly, not as the field rounds it
        return accuracy::namedTolerances()[static_cast<std::size_t>(slider_->value())].tolerance;
    return {static_cast<ErrorMetric>(metric_->currentData().toInt()), number_->value()};
}

int AccuracyPanel::studySeconds() const { return seconds_->value(); }

void AccuracyPanel::wantSettings() {
    rest_.stop();
    if (drawable_ && (work_ == Work::none || work_ == Work::search))
        Q_EMIT settingsWanted(asked());
}

void AccuracyPanel::setFigure(const std::shared_ptr<const Figure>& figure) {
    drawable_ = scanOf(figure.get()) != nullptr;
    std::optional<accuracy::Tolerance> own;
    if (figure && figure->quality.tolerance)
        own = {figure->quality.toleranceMetric, *figure->quality.tolerance};
    const bool same = own && figures_ && own->metric == figures_->metric && own->value == figures_->value;
    figures_ = own;
    if (own && !same && !slider_->isSliderDown())
        showTolerance(*own);
    enable();
}

void AccuracyPanel::setWork(Work work) {
    work_ = work;
    switch (work) {
    case Work::search: doing_->setText(tr("Finding settings")); break;
    case Work::study:
    case Work::savings: doing_->setText(tr("Measuring")); break;
    case Work::map: doing_->setText(tr("Drawing the error")); break;
    case Work::none: break;
    }
    setProgress(0);
    enable();
}

void AccuracyPanel::setProgress(double fraction) {
    progress_->setValue(static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kProgressSteps));
}

void AccuracyPanel::enable() {
    const bool idle = work_ == Work::none;
    for (QWidget* widget : std::initializer_list<QWidget*>{slider_, number_, metric_, find_})
        widget->setEnabled(drawable_ && (idle || work_ == Work::search));
    for (QWidget* widget : std::initializer_list<QWidget*>{study_, seconds_, measure_})
        widget->setEnabled(drawable_ && idle);
    map_->setEnabled(drawable_ && (idle || work_ == Work::map));
    report_->setEnabled(shown_ != nullptr);
    foot_->setVisible(!idle);
}

void AccuracyPanel::say(const QString& words) {
    answerWords_ = words;
    setAnswerCurrent(true);
}

void AccuracyPanel::showWords(QLabel* label, const QString& words, const char* between, bool current) {
    label->setEnabled(current);
    label->setText(current || words.isEmpty() ? words : words + between + tr("The figure has changed since."));
    label->setVisible(!words.isEmpty());
}

void AccuracyPanel::setAnswerCurrent(bool current) { showWords(answer_, answerWords_, "\n", current); }

void AccuracyPanel::showAnswer(const ToleranceAnswer& answer, bool applied) {
    const ErrorMetric metric = answer.asked.metric;
    const QString asked = errorWords(answer.asked.value, metric);
    if (!answer.choice) {
        say(tr("It cannot be told which settings keep %1: the finest picture that can be drawn is itself only sure to "
               "%2. "
               "Ask for a larger error, or soften what is steep in the transfer functions.")
                .arg(asked, errorWords(answer.errorBar, metric)));
        return;
    }
    const accuracy::ToleranceChoice& choice = *answer.choice;
    const QString delivered = errorWords(deliveredError(choice), metric);
    const QString settings = settingsWords(choice.quality);
    const QString limits = limitWords(choice.limits, metric);
    if (!choice.reached)
        say(tr("Not reached: asked %1, the best settings deliver %2 (%3). The figure keeps the settings it had. %4")
                .arg(asked, delivered, settings, limits));
    else if (applied)
        say(tr("Delivered %1, asked %2: %3. %4").arg(delivered, asked, settings, limits));
    else
        say(tr("Delivered %1, asked %2: %3, as the figure has it already. %4").arg(delivered, asked, settings, limits));
}

void AccuracyPanel::showStudy(std::shared_ptr<const accuracy::Study> study) {
    shown_ = std::move(study);
    chart_->setStudy(shown_);
    chart_->setVisible(shown_ != nullptr);
    findingWords_.clear();
    if (shown_) {
        const accuracy::StudyRow& present = shown_->rows[shown_->present];
        QStringList lines{tr("As it is, the picture takes %1 and is off by %2.")
                              .arg(secondsWords(present.pictureSeconds),
                                   errorWords(present.measured.error.of(shown_->metric), shown_->metric)),
                          limitWords(shown_->limits, shown_->metric)};
        if (shown_->leftOut > 0)
            lines << tr("Settings left out because the time was up: %1.").arg(shown_->leftOut);
        findingWords_ = lines.join(" ");
    }
    showChoices();
    setStudyCurrent(true);
    enable();
}

void AccuracyPanel::showChoices() {
    choices_->setRowCount(0);
    choices_->setVisible(shown_ && !shown_->choices.empty());
    if (!choices_->isVisibleTo(this))
        return;
    for (const auto& [name, choice] : shown_->choices) {
        const auto row = std::ranges::find_if(shown_->rows, [&, &wanted = choice.quality](const accuracy::StudyRow& r) {
            return r.measured.quality == wanted;
        });
        const ErrorMetric metric = choice.asked.metric;
        const QString settings = settingsWords(choice.quality);
        const QString delivered = errorWords(deliveredError(choice), metric);
        const int at = choices_->rowCount();
        choices_->insertRow(at);
        choices_->setItem(at, 0, cell(choiceWords(name), errorWords(choice.asked.value, metric)));
        choices_->setItem(at, 1,
                          cell(choice.reached ? delivered : tr("%1 (not reached)").arg(delivered),
                               limitWords(choice.limits, metric)));
        choices_->setItem(at, 2,
                          cell(row == shown_->rows.end() ? QString() : secondsWords(row->pictureSeconds), QString()));
        choices_->setItem(at, 3, cell(settings, settings));
    }
    for (const accuracy::NamedTolerance& named : accuracy::namedTolerances()) {
        const auto measured = [&](const auto& pair) { return pair.first == std::string("for ") + named.name; };
        if (std::ranges::any_of(shown_->choices, measured))
            continue;
        const int at = choices_->rowCount();
        choices_->insertRow(at);
        choices_->setItem(
            at, 0, cell(toleranceName(named.tolerance), errorWords(named.tolerance.value, named.tolerance.metric)));
        choices_->setItem(
            at, 1,
            shown_->leftOut > 0
                ? cell(tr("not measured"), tr("The time was up"))
                : cell(tr("cannot be told"), tr("The finest picture that can be drawn is itself not sure enough")));
    }
    choices_->resizeRowsToContents();
    int height = choices_->horizontalHeader()->sizeHint().height() + 2 * choices_->frameWidth();
    for (int i = 0; i < choices_->rowCount(); ++i)
        height += choices_->rowHeight(i);
    choices_->setFixedHeight(height);
}

void AccuracyPanel::setStudyCurrent(bool current) { showWords(findings_, findingWords_, " ", current); }

void AccuracyPanel::showSavings(const accuracy::Savings& savings) {
    savingWords_ = savingsWords(savings);
    setSavingsCurrent(true);
}

void AccuracyPanel::setSavingsCurrent(bool current) { showWords(savings_, savingWords_, "\n", current); }

void AccuracyPanel::forget() {
    say({});
    showStudy(nullptr);
    savingWords_.clear();
    setSavingsCurrent(true);
}

void AccuracyPanel::setMapShown(bool shown) { map_->setChecked(shown); }

} // namespace limner
