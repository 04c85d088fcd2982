#pragma once

#include "core/figure/figure.h"
#include "renderer/accuracy/savings.h"
#include "renderer/accuracy/study.h"

#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;
class QSpinBox;
class QTableWidget;
class QVBoxLayout;

namespace limner {

class AccuracyChart;

/// How a search for a tolerance ended.
struct ToleranceAnswer {
    accuracy::Tolerance asked;
    double errorBar = 0;                             ///< of the reference, in the tolerance's metric
    std::optional<accuracy::ToleranceChoice> choice; ///< nothing: the reference is not good enough to tell
};

/// How wrong the picture is and what better would cost (spec accuracy.md 1.8, 1.9): a tolerance whose cheapest settings
/// are found, a study of error against run time, the error over the picture, and what the picture is drawn without and
/// what that saves (1.10). Asks for the work, which is done elsewhere, and shows what came of it.
class AccuracyPanel : public QWidget {
    Q_OBJECT

  public:
    explicit AccuracyPanel(QWidget* parent = nullptr);

    /// What is being done for the panel; nothing else can be asked for meanwhile but another tolerance.
    enum class Work { none, search, study, map, savings };

    void setFigure(const std::shared_ptr<const Figure>& figure);
    void setWork(Work work);
    [[nodiscard]] Work work() const { return work_; }
    void setProgress(double fraction);
    /// `applied`: the figure has the settings now.
    void showAnswer(const ToleranceAnswer& answer, bool applied);
    void showStudy(std::shared_ptr<const accuracy::Study> study);
    void showSavings(const accuracy::Savings& savings);
    /// What is said of the settings, of the study, or of what is left out, is not of the figure that is open now.
    void setAnswerCurrent(bool current);
    void setStudyCurrent(bool current);
    void setSavingsCurrent(bool current);
    /// In words, where an answer would stand.
    void say(const QString& words);
    void forget(); ///< answer, study and savings: another document is open
    void setMapShown(bool shown);

    [[nodiscard]] accuracy::Tolerance asked() const;
    [[nodiscard]] int studySeconds() const;

    [[nodiscard]] QSlider* slider() const { return slider_; }
    [[nodiscard]] QDoubleSpinBox* number() const { return number_; }
    [[nodiscard]] QComboBox* metric() const { return metric_; }
    [[nodiscard]] QPushButton* find() const { return find_; }
    [[nodiscard]] QPushButton* study() const { return study_; }
    [[nodiscard]] QSpinBox* seconds() const { return seconds_; }
    [[nodiscard]] QPushButton* stop() const { return stop_; }
    [[nodiscard]] QPushButton* report() const { return report_; }
    [[nodiscard]] QCheckBox* map() const { return map_; }
    [[nodiscard]] QLabel* answer() const { return answer_; }
    [[nodiscard]] QLabel* findings() const { return findings_; }
    [[nodiscard]] QPushButton* measure() const { return measure_; }
    [[nodiscard]] QLabel* savings() const { return savings_; }
    [[nodiscard]] QTableWidget* choices() const { return choices_; }
    [[nodiscard]] AccuracyChart* chart() const { return chart_; }

  Q_SIGNALS:
    void settingsWanted(const limner::accuracy::Tolerance& tolerance);
    void studyWanted();
    void stopWanted();
    void reportWanted();
    void mapWanted(bool on);
    void savingsWanted();

  private:
    void buildSlider(QGridLayout* grid);
    void buildNumber();
    void buildTolerance(QVBoxLayout* column);
    void buildStudy(QVBoxLayout* column);
    void buildMap(QVBoxLayout* column);
    void buildSavings(QVBoxLayout* column);
    [[nodiscard]] QWidget* buildFoot();
    void connectSlider();
    void sliderMoved();
    void metricChosen();
    void showTolerance(const accuracy::Tolerance& tolerance);
    void takeNumber(const accuracy::Tolerance& tolerance);
    void wantSettings();
    void enable();
    static void showWords(QLabel* label, const QString& words, const char* between, bool current);
    void showChoices();

    QSlider* slider_;
    QDoubleSpinBox* number_;
    QComboBox* metric_;
    QPushButton* find_;
    QLabel* answer_;
    QPushButton* study_;
    QSpinBox* seconds_;
    QPushButton* report_;
    QLabel* findings_;
    AccuracyChart* chart_;
    QTableWidget* choices_;
    QCheckBox* map_;
    QPushButton* measure_;
    QLabel* savings_;
    QWidget* foot_; ///< what is being done, how far it is, and its end
    QLabel* doing_;
    QProgressBar* progress_;
    QPushButton* stop_;
    QTimer rest_; ///< keys may move the slider on: the search waits until they rest

    Work work_ = Work::none;
    bool drawable_ = false;
    int pressedAt_ = 0;                          ///< the slider's position when it was taken
    std::optional<accuracy::Tolerance> figures_; ///< the figure's own tolerance, as it was shown last
    std::shared_ptr<const accuracy::Study> shown_;
    QString answerWords_;
    QString findingWords_;
    QString savingWords_;
};

} // namespace limner
