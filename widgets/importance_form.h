#pragma once

#include "core/project/history.h"

#include <QWidget>

#include <memory>
#include <string_view>
#include <vector>

class QCheckBox;
class QFormLayout;

namespace limner {

class LensForm;
class ParameterRow;

/// The figure's importance: whether what matters shows through, what matters how much, and the lenses.
class ImportanceForm : public QWidget {
    Q_OBJECT

  public:
    explicit ImportanceForm(QWidget* parent = nullptr);

    void setFigure(std::shared_ptr<const Figure> figure);
    [[nodiscard]] QCheckBox* showsThrough() const { return through_; }
    /// Null for a pointer that has no row.
    [[nodiscard]] ParameterRow* row(std::string_view pointer) const;
    [[nodiscard]] LensForm* lenses() const { return lenses_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);

  private:
    struct Entry {
        ParameterRow* row;
        double& (*of)(Importance&);
    };

    void buildRows(QFormLayout* measures, QFormLayout* limits);
    void layOut(QFormLayout* measures, QFormLayout* limits);
    void setPresent(bool on);

    QCheckBox* through_;
    std::vector<Entry> rows_;
    LensForm* lenses_;
    QWidget* parts_; ///< all but the check box
    std::shared_ptr<const Figure> figure_;
    Importance last_; ///< comes back when the check box is set again
};

/// What a figure gets that shows what matters: the boundaries come forward.
Importance firstImportance();

} // namespace limner
