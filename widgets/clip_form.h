#pragma once

#include "widgets/part_form.h"

#include <array>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QListWidget;
class QPushButton;

namespace limner {

/// What is cut away from one layer or from the whole figure: a box, planes, and how the faces of the cuts are drawn.
class ClipForm : public PartFormOf<Clip> {
    Q_OBJECT

  public:
    enum class Of { layer, figure };
    explicit ClipForm(Of of = Of::layer);

    [[nodiscard]] QCheckBox* box() const { return box_; }
    /// Low (0) or high (1) end of the box along x, y or z.
    [[nodiscard]] QDoubleSpinBox* boxEnd(std::size_t axis, std::size_t end) const { return ends_[axis][end]; }
    [[nodiscard]] QListWidget* planes() const { return planes_; }
    [[nodiscard]] QPushButton* cutHere() const { return cutHere_; }
    [[nodiscard]] QPushButton* flip() const { return flip_; }
    [[nodiscard]] QPushButton* removePlane() const { return remove_; }
    [[nodiscard]] ParameterRow* offset() const { return offset_; }
    [[nodiscard]] QComboBox* face() const { return face_; }
    [[nodiscard]] ColourButton* faceColour() const { return faceColour_; }
    /// The chosen one of the list; null: none.
    [[nodiscard]] std::optional<std::size_t> chosenPlane() const;

  Q_SIGNALS:
    void planeChosen();

  private:
    void buildBox();
    void buildPlanes();
    void buildFace();
    void showBox(const Clip& clip);
    void showPlanes(const Clip& clip);
    void showPlane();
    void showFace(const Clip& clip);
    void moveBoxEnd(std::size_t axis, std::size_t end, double mm);
    void chooseFace(int row);
    /// Changes the chosen plane; nothing where none is chosen.
    void changePlane(const QString& label, const std::string& key, bool ongoing,
                     const std::function<void(ClipPlane&)>& by);
    /// Of a setting of the clip: "box_mm".
    [[nodiscard]] std::string at(const char* setting) const { return pointer() + "/" + setting; }

    QCheckBox* box_;
    QWidget* boxRows_;
    std::array<std::array<QDoubleSpinBox*, 2>, 3> ends_{};
    QListWidget* planes_;
    QPushButton* cutHere_;
    QPushButton* flip_;
    QPushButton* remove_;
    ParameterRow* offset_ = nullptr;
    QComboBox* face_;
    ColourButton* faceColour_;
    std::vector<ClipPlane> shown_;
    GestureKey gesture_;
};

} // namespace limner
