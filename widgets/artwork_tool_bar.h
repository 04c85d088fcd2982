#pragma once

#include "widgets/artwork_tool.h"

#include <QWidget>

#include <array>
#include <map>

class QCheckBox;
class QSlider;
class QStackedWidget;
class QToolButton;

namespace limner {

/// The artwork canvas's tools, one under the other, each with its letter.
class ArtworkToolBar : public QWidget {
    Q_OBJECT

  public:
    explicit ArtworkToolBar(QWidget* parent = nullptr);

    /// Shows a tool as chosen without a signal.
    void setTool(ToolKind kind);
    [[nodiscard]] QToolButton* button(ToolKind kind) const { return buttons_.at(kind); }

  Q_SIGNALS:
    void chosen(limner::ToolKind kind);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void showIcons();

    std::map<ToolKind, QToolButton*> buttons_;
};

/// What can be set for the chosen tool, in a line above the canvas.
class ArtworkToolOptions : public QWidget {
    Q_OBJECT

  public:
    explicit ArtworkToolOptions(QWidget* parent = nullptr);

    void setTool(ToolKind kind);
    void setOptions(const ToolOptions& options);
    void setDraft(const ExtractionDraft& draft);
    [[nodiscard]] QToolButton* snap() const { return snap_; }
    [[nodiscard]] QToolButton* letters() const { return letters_; }
    [[nodiscard]] QToolButton* chip(SwatchRole role) const { return chips_[static_cast<std::size_t>(role)]; }
    [[nodiscard]] QCheckBox* findEdge() const { return findEdge_; }
    [[nodiscard]] QCheckBox* fromCentre() const { return fromCentre_; }

  Q_SIGNALS:
    void optionsChanged(const limner::ToolOptions& options);
    void snapWanted();
    void lettersWanted();
    void removeWanted();

  private:
    QWidget* ballPage();
    QWidget* outlinePage();
    QWidget* brushPage();
    QWidget* markPage();
    QWidget* pickerPage();
    void change(const ToolOptions& options);
    void showChips();

    ToolKind kind_ = ToolKind::circle;
    ToolOptions options_;
    ExtractionDraft draft_;
    QStackedWidget* pages_;
    QCheckBox* fromCentre_ = nullptr;
    QToolButton* snap_ = nullptr;
    QCheckBox* findEdge_ = nullptr;
    QSlider* brush_ = nullptr;
    QToolButton* letters_ = nullptr;
    QToolButton* clear_ = nullptr;
    QToolButton* remove_ = nullptr;
    std::array<QToolButton*, kSwatchRoles> chips_{};
};

} // namespace limner
