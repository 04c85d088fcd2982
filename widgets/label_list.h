#pragma once

#include "core/project/history.h"

#include <QPointer>
#include <QWidget>

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace limner {

class Job;

/// Which labels of the figure's label volume the selected layer shows: a row with a colour chip, a name and a check
/// mark for each label that occurs. Hidden where the figure has no labels. The labels are counted on a thread of their
/// own, so that a large volume does not hold the window up.
class LabelList : public QWidget {
    Q_OBJECT

  public:
    explicit LabelList(QWidget* parent = nullptr);
    ~LabelList() override;

    void setFigure(std::shared_ptr<const Figure> figure, std::size_t layer);
    [[nodiscard]] QListWidget* list() const { return list_; }
    [[nodiscard]] QLineEdit* search() const { return search_; }
    /// Show or hide every label that the search has found.
    [[nodiscard]] QToolButton* all() const { return all_; }
    [[nodiscard]] QToolButton* none() const { return none_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);

  private:
    void count(const std::shared_ptr<const Volume>& labels);
    void showLabels();
    void itemChanged(const QListWidgetItem* item);
    void filter();
    void setListed(Qt::CheckState state);
    void emitLabels(const std::vector<int>& shown, const QString& label);
    [[nodiscard]] std::vector<int> shown() const;

    QLineEdit* search_;
    QListWidget* list_;
    QToolButton* all_;
    QToolButton* none_;
    std::shared_ptr<const Figure> figure_;
    std::size_t layer_ = 0;
    std::shared_ptr<const Volume> counted_; ///< whose counts `counts_` are, or will be when the job is done
    std::map<int, std::size_t> counts_;     ///< voxels of each label that occurs, 0 left out
    QPointer<Job> job_;
};

} // namespace limner
