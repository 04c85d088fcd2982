#pragma once

#include "core/figure/presets.h"

#include <QMenu>

namespace limner {

/// The presets it is given; says which was chosen. Laying a preset over a figure can take a while, so it is not done
/// here.
class PresetMenu : public QMenu {
    Q_OBJECT

  public:
    explicit PresetMenu(QWidget* parent = nullptr);
    void setPresets(const std::vector<PresetCard>& presets);
    /// Whether there are labels: presets that draw by label can be chosen only then.
    void setLabelsThere(bool there);

  Q_SIGNALS:
    void chosen(const QString& id, const QString& name);

  private:
    std::vector<QAction*> needLabels_;
    bool labelsThere_ = false;
};

} // namespace limner
