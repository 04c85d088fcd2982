#include "widgets/view_form.h"

#include "core/figure/camera_angles.h"
#include "widgets/clip_form.h"
#include "widgets/form_parts.h"
#include "widgets/parameter_row.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace limner {
namespace {

constexpr double kFarMm = 1e5; // farther than any scan reaches; the fields stay narrow
constexpr int kSidesPerRow = 4;

struct Side {
    StandardView view;
    const char* name;
    const char* tip;
};

constexpr Side kSides[] = {
    {StandardView::anterior, QT_TRANSLATE_NOOP("limner::ViewForm", "Front"),
     QT_TRANSLATE_NOOP("limner::ViewForm", "The patient's front")},
    {StandardView::posterior, QT_TRANSLATE_NOOP("limner::ViewForm", "Back"),
     QT_TRANSLATE_NOOP("limner::ViewForm", "The patient's back")},
    {StandardView::left, QT_TRANSLATE_NOOP("limner::ViewForm", "Left"),
     QT_TRANSLATE_NOOP("limner::ViewForm", "The patient's left side")},
    {StandardView::right, QT_TRANSLATE_NOOP("limner::ViewForm", "Right"),
     QT_TRANSLATE_NOOP("limner::ViewForm", "The patient's right side")},
    {StandardView::superior, QT_TRANSLATE_NOOP("limner::ViewForm", "Above"),
     QT_TRANSLATE_NOOP("limner::ViewForm", "From above the head")},
    {StandardView::inferior, QT_TRANSLATE_NOOP("limner::ViewForm", "Below"),
     QT_TRANSLATE_NOOP("limner::ViewForm", "From below the feet")},
    {StandardView::threeQuarter, QT_TRANSLATE_NOOP("limner::ViewForm", "3/4"),
     QT_TRANSLATE_NOOP("limner::ViewForm", "From the front, turned and from a little above")},
};

} // namespace

ViewForm::ViewForm(QWidget* parent)
    : QWidget(parent), projection_(choiceBox("/camera/projection",
                                             {{"orthographic", tr("Parallel")}, {"perspective", tr("Perspective")}})),
      perspective_(new ParameterRow("/camera/fov_deg", {1, 90, 1})),
      height_(new ParameterRow("/camera/height_mm", {10, 600, 1, 2})), clip_(new ClipForm(ClipForm::Of::figure)) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(8, 8, 8, 8);
    QFormLayout* form = formLayout();
    column->addWidget(heading(tr("View")));
    column->addLayout(form);
    buildSides(form);
    buildCamera(form);
    buildAngles(form);
    buildMiddle(form);
    column->addSpacing(6);
    column->addWidget(heading(tr("Cut")));
    column->addWidget(clip_);
    column->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scrolling(content));
    connect(clip_, &ClipForm::edited, this, &ViewForm::edited);
    setFigure(nullptr);
}

void ViewForm::buildSides(QFormLayout* form) {
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    int at = 0;
    const auto place = [&](QToolButton* button) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        grid->addWidget(button, at / kSidesPerRow, at % kSidesPerRow);
        ++at;
    };
    for (const Side& side : kSides) {
        QToolButton* button = textButton(tr(side.name), tr(side.tip));
        place(button);
        connect(button, &QToolButton::clicked, this, [this, view = side.view] { Q_EMIT sideWanted(view); });
    }
    QToolButton* fit = textButton(tr("Fit"), tr("Fill the sheet with what is visible"));
    place(fit);
    connect(fit, &QToolButton::clicked, this, &ViewForm::fitWanted);
    form->addRow(grid);
}

QDoubleSpinBox* ViewForm::numberField(const QString& name, const QString& tip) {
    auto* field = new QDoubleSpinBox;
    field->setDecimals(1);
    field->setKeyboardTracking(false);
    field->setMinimumWidth(70);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    leaveWheelToPanel(field);
    return field;
}

void ViewForm::buildCamera(QFormLayout* form) {
    addLabelled(form, labelOfSetting("/camera/projection"), projection_);
    addLabelled(form, tr("Strength"), perspective_, perspective_->slider());
    addLabelled(form, height_->label(), height_, height_->slider());
    connect(projection_, &QComboBox::activated, this, [this] {
        changeCamera(tr("Change projection"), {}, false, [&](Camera& camera) {
            camera.projection =
                chosenWord(projection_) == "perspective" ? Projection::perspective : Projection::orthographic;
        });
    });
    connect(perspective_, &ParameterRow::changed, this, [this](double deg, const std::string& key, bool ongoing) {
        changeCamera(tr("Change perspective"), key, ongoing, [&](Camera& camera) { camera.fovDeg = deg; });
    });
    connect(height_, &ParameterRow::changed, this, [this](double mm, const std::string& key, bool ongoing) {
        changeCamera(tr("Zoom"), key, ongoing, [&](Camera& camera) { camera.heightMm = mm; });
    });
}

void ViewForm::buildAngles(QFormLayout* form) {
    struct Angle {
        QString name, tip;
        double limit;
    };
    const Angle angles[] = {
        {tr("Turn"), tr("Round the patient, in degrees: 0 before the face, 90 at the patient's left side"), 180},
        {tr("Tilt"), tr("Height of the viewer, in degrees: 90 straight above, −90 straight below"), 90},
        {tr("Roll"), tr("Lean of the picture, in degrees, counter-clockwise"), 180}};
    auto* turning = new QWidget;
    auto* row = new QHBoxLayout(turning);
    row->setContentsMargins(0, 0, 0, 0);
    for (std::size_t i = 0; i < angles_.size(); ++i) {
        angles_[i] = numberField(angles[i].name, angles[i].tip);
        angles_[i]->setRange(-angles[i].limit, angles[i].limit);
        angles_[i]->setWrapping(angles[i].limit > 90);
        angles_[i]->setSuffix(tr("°"));
        row->addWidget(angles_[i], 1);
        connect(angles_[i], &QDoubleSpinBox::valueChanged, this, &ViewForm::changeAngles);
    }
    addLabelled(form, tr("Turn, tilt, roll"), turning, angles_[0]);
}

void ViewForm::buildMiddle(QFormLayout* form) {
    auto* middle = new QWidget;
    auto* fields = new QHBoxLayout(middle);
    fields->setContentsMargins(0, 0, 0, 0);
    const QString axes[] = {tr("Middle, towards the patient's left"), tr("Middle, towards the back"),
                            tr("Middle, towards the head")};
    for (std::size_t i = 0; i < target_.size(); ++i) {
        target_[i] = numberField(axes[i], tr("%1, in mm").arg(axes[i]));
        target_[i]->setRange(-kFarMm, kFarMm);
        fields->addWidget(target_[i], 1);
        connect(target_[i], &QDoubleSpinBox::valueChanged, this, [this, i](double mm) {
            changeCamera(tr("Move middle of view"), gesture_.again("view/target"), false,
                         [&](Camera& camera) { camera.targetMm[static_cast<glm::length_t>(i)] = mm; });
        });
    }
    addLabelled(form, tr("Middle (mm)"), middle, target_[0]);
}

void ViewForm::changeCamera(const QString& label, const std::string& key, bool ongoing,
                            const std::function<void(Camera&)>& by) {
    if (!figure_)
        return;
    Edit edit{*figure_, label.toStdString(), key, ongoing};
    by(edit.figure.camera);
    Q_EMIT edited(edit);
}

void ViewForm::changeAngles() {
    const ViewAngles asked{angles_[0]->value(), angles_[1]->value(), angles_[2]->value()};
    changeCamera(tr("Turn view"), gesture_.again("view/angles"), false,
                 [&](Camera& camera) { camera = withViewAngles(camera, asked); });
}

void ViewForm::setFigure(std::shared_ptr<const Figure> figure) {
    figure_ = std::move(figure);
    setEnabled(figure_ != nullptr);
    clip_->setFigure(figure_, 0);
    if (!figure_)
        return;
    const Camera& camera = figure_->camera;
    choose(projection_, camera.projection == Projection::perspective ? "perspective" : "orthographic");
    perspective_->setEnabled(camera.projection == Projection::perspective);
    perspective_->setValue(camera.fovDeg);
    height_->setValue(camera.heightMm);
    const ViewAngles angles = viewAngles(camera);
    const double shown[] = {angles.turnDeg, angles.tiltDeg, angles.rollDeg};
    for (std::size_t i = 0; i < angles_.size(); ++i) {
        const QSignalBlocker quietAngle(angles_[i]);
        const QSignalBlocker quietTarget(target_[i]);
        // Shown as exactly as the field can: what was typed elsewhere stays where it agrees.
        if (std::abs(angles_[i]->value() - shown[i]) > 0.05)
            angles_[i]->setValue(shown[i]);
        target_[i]->setValue(camera.targetMm[static_cast<glm::length_t>(i)]);
    }
}

} // namespace limner
