#pragma once

#include "app/studio/workplace.h"
#include "core/figure/variants.h"

#include <QDialog>
#include <QImage>

#include <memory>
#include <mutex>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QSpinBox;

namespace limner {

class StylePictures;

/// A contact sheet of the figure in other looks (themes, presets, one's own looks) or with a setting at several values;
/// a double click or Enter takes one, as one step that can be undone. The sheet stays open.
class VariantDialog : public QDialog {
    Q_OBJECT

  public:
    explicit VariantDialog(const Workplace& place);
    ~VariantDialog() override; ///< cancels what is drawn

    enum Source { themes, presets, looks, firstSetting };
    [[nodiscard]] QComboBox* source() const { return source_; }
    [[nodiscard]] QDoubleSpinBox* from() const { return from_; }
    [[nodiscard]] QDoubleSpinBox* to() const { return to_; }
    [[nodiscard]] QSpinBox* count() const { return count_; }
    [[nodiscard]] QListWidget* sheet() const { return sheet_; }
    [[nodiscard]] bool busy() const { return !job_.isNull(); }

  private:
    /// What the worker makes, one after another.
    struct Made {
        std::mutex mutex;
        std::vector<Variant> variants;
        std::vector<QImage> pictures; ///< of the first ones
    };
    void buildLayout();
    void fillSources();
    void showRange();
    void makeSheet();
    void showMade();
    void take();
    [[nodiscard]] std::function<std::vector<Variant>(Task&)> maker() const;

    Workplace place_;
    std::shared_ptr<const Figure> base_; ///< what the shown variants differ from
    std::shared_ptr<Made> made_;
    std::shared_ptr<StylePictures> painter_;
    std::vector<VariedSetting> settings_;
    QComboBox* source_;
    QDoubleSpinBox* from_;
    QDoubleSpinBox* to_;
    QSpinBox* count_;
    QListWidget* sheet_;
    QLabel* word_;
    QPointer<Job> job_;
};

} // namespace limner
