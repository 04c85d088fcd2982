#pragma once

#include "core/project/history.h"
#include "core/volume/histogram.h"

#include <QWidget>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QMenu;
class QPushButton;
class QSpinBox;

namespace limner {

class ParameterRow;

/// The figure's clean-up steps in their order, in plain words, and the numbers of the chosen one. Steps are added from
/// a menu, moved, and deleted; the two that need a place in the picture are asked of the window.
class CleanupForm : public QWidget {
    Q_OBJECT

  public:
    explicit CleanupForm(QWidget* parent = nullptr);

    /// `histogram`: of the figure's volume, for starting values; without it nothing can be added.
    void setFigure(std::shared_ptr<const Figure> figure, std::shared_ptr<const Histogram> histogram);
    [[nodiscard]] std::optional<std::size_t> selected() const;
    void select(std::optional<std::size_t> step);
    /// Puts a step with starting values last and chooses it. Scissors and keep-at ask for their tool instead.
    void addStep(CleanupKind kind);
    void removeStep();
    /// Exchanges the chosen step with its neighbour: -1 the one before, 1 the one after.
    void moveStep(int by);

    [[nodiscard]] QListWidget* list() const { return list_; }
    [[nodiscard]] QPushButton* add() const { return add_; }
    [[nodiscard]] QPushButton* remove() const { return remove_; }
    [[nodiscard]] QPushButton* earlier() const { return earlier_; }
    [[nodiscard]] QPushButton* later() const { return later_; }
    [[nodiscard]] QComboBox* side() const { return side_; }
    [[nodiscard]] QPushButton* look() const { return look_; }
    [[nodiscard]] QSpinBox* label() const { return label_; }
    /// Null for a pointer that has no row; `*` stands for the step.
    [[nodiscard]] ParameterRow* row(std::string_view pointer) const;

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void scissorsWanted();
    void islandWanted();

  private:
    struct Entry {
        ParameterRow* row;
        double& (*of)(CleanupStep&);
        bool (*has)(CleanupKind);
    };

    void buildMenu();
    void buildRows();
    void buildOthers();
    void layOut();
    void fitRanges();
    void showStep();
    [[nodiscard]] const std::vector<CleanupStep>& steps() const;
    void editStep(const QString& label, const std::string& key, bool ongoing,
                  const std::function<void(CleanupStep&)>& change);

    QListWidget* list_;
    QPushButton* add_;
    QPushButton* earlier_;
    QPushButton* later_;
    QPushButton* remove_;
    QMenu* kinds_;
    QLabel* none_;
    QWidget* settings_;
    QFormLayout* form_;
    std::vector<Entry> rows_;
    QComboBox* side_;
    QPushButton* look_;
    QSpinBox* label_;
    std::shared_ptr<const Figure> figure_;
    std::shared_ptr<const Histogram> histogram_;
};

} // namespace limner
