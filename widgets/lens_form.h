#pragma once

#include "core/project/history.h"

#include <QWidget>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QListWidget;
class QPushButton;

namespace limner {

class ParameterRow;

/// The lenses of the figure's importance: a list, and the settings of the chosen one.
class LensForm : public QWidget {
    Q_OBJECT

  public:
    explicit LensForm(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure);
    [[nodiscard]] std::optional<std::size_t> selected() const;
    void select(std::optional<std::size_t> lens);
    /// A lens in the middle of the figure, which is chosen then. Turns importance on where it is off.
    void addLens();
    void removeLens();

    [[nodiscard]] QListWidget* list() const { return list_; }
    [[nodiscard]] QPushButton* add() const { return add_; }
    [[nodiscard]] QPushButton* remove() const { return remove_; }
    [[nodiscard]] QComboBox* kind() const { return kind_; }
    [[nodiscard]] QComboBox* shape() const { return shape_; }
    [[nodiscard]] QCheckBox* follows() const { return follows_; }
    /// Null for a pointer that has no row; `*` stands for the lens.
    [[nodiscard]] ParameterRow* row(std::string_view pointer) const;

  Q_SIGNALS:
    void edited(const limner::Edit& edit);
    void lensSelected();

  private:
    struct Entry {
        ParameterRow* row;
        double& (*of)(Lens&);
    };

    void buildChoices();
    void buildRows(QFormLayout* form);
    void layOut();
    void showLens();
    [[nodiscard]] const std::vector<Lens>& lenses() const;
    void editLens(const QString& label, const std::string& key, bool ongoing, const std::function<void(Lens&)>& change);

    QListWidget* list_;
    QPushButton* add_;
    QPushButton* remove_;
    QWidget* settings_;
    QComboBox* kind_;
    QComboBox* shape_;
    std::vector<Entry> rows_;
    QCheckBox* follows_;
    std::shared_ptr<const Figure> figure_;
};

} // namespace limner
