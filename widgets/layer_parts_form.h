#pragma once

#include "core/project/history.h"

#include <QWidget>

#include <memory>
#include <string_view>
#include <vector>

namespace limner {

class ClipForm;
class PartForm;
class PositionForm;
class ToneForm;

/// The parts that a layer may have, each behind a check box: tone, silhouette, highlights, Phong's light, opacity by
/// gradient, colour by position, depth of field, clipping.
class LayerPartsForm : public QWidget {
    Q_OBJECT

  public:
    explicit LayerPartsForm(QWidget* parent = nullptr);

    void setFigure(const std::shared_ptr<const Figure>& figure, std::size_t layer);
    /// By its pointer, "/layers/*/silhouette"; null where there is none.
    [[nodiscard]] PartForm* part(std::string_view pointer) const;
    [[nodiscard]] ToneForm* tone() const { return tone_; }
    [[nodiscard]] PositionForm* position() const { return position_; }
    [[nodiscard]] ClipForm* clip() const { return clip_; }

  Q_SIGNALS:
    void edited(const limner::Edit& edit);

  private:
    void add(PartForm* part);

    std::vector<PartForm*> parts_;
    ToneForm* tone_;
    PositionForm* position_;
    ClipForm* clip_;
    PartForm* phong_;
};

/// The figure's depth cues, over all layers: ambient occlusion, contact shadow, halos.
class DepthCuesForm : public QWidget {
    Q_OBJECT

  public:
    explicit DepthCuesForm(QWidget* parent = nullptr);

    void setFigure(const std::shared_ptr<const Figure>& figure);
    /// By its pointer, "/depth_cues/halo"; null where there is none.
    [[nodiscard]] PartForm* part(std::string_view pointer) const;

  Q_SIGNALS:
    void edited(const limner::Edit& edit);

  private:
    void add(PartForm* part);

    std::vector<PartForm*> parts_;
};

} // namespace limner
