#include "widgets/clip_form.h"

#include "core/figure/camera_moves.h"
#include "widgets/form_parts.h"

#include <glm/geometric.hpp>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace limner {
namespace {

constexpr std::size_t kMostPlanes = 64; // that a clip may have
constexpr int kListHeight = 56;         // two planes; more scroll
constexpr double kFarMm = 1e5;          // farther than any scan reaches; the fields stay narrow
constexpr double kThinnestMm = 0.1;     // a box always has a volume

enum FaceRow { kNoFace, kOwnFace, kColourFace, kFirstStyle };

/// The box, upright in the patient, around the scan.
BoxMm scanBox(const Figure& figure) {
    if (!figure.volume || !figure.volume->data)
        return {glm::dvec3(-100), glm::dvec3(100)};
    const Grid& grid = figure.volume->data->grid();
    BoxMm box{glm::dvec3(kFarMm), glm::dvec3(-kFarMm)};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 mm = grid.mmFromVoxel(share * glm::dvec3(grid.dims) - 0.5);
        box.low = glm::min(box.low, mm);
        box.high = glm::max(box.high, mm);
    }
    return box;
}

/// The plane through what the camera looks at; what is nearer is cut away.
ClipPlane planeHere(const Camera& camera) {
    const glm::dvec3 towards = -cameraFrame(camera).forward;
    return {towards, glm::dot(towards, camera.targetMm)};
}

Clip firstClip(const Figure& figure) {
    Clip clip;
    clip.planes = {planeHere(figure.camera)};
    clip.face = CutFace{};
    return clip;
}

/// The figure always has a clip; one that cuts nothing is an absent one.
PartFormOf<Clip>::Access figureClip() {
    return {[](const Figure& figure, std::size_t) {
                return figure.clip == Clip{} ? std::optional<Clip>() : std::optional(figure.clip);
            },
            [](Figure& figure, std::size_t, std::optional<Clip> clip) { figure.clip = clip.value_or(Clip{}); },
            firstClip};
}

QString planeText(std::size_t index, const ClipPlane& plane) {
    return ClipForm::tr("Plane %1: %2 side cut away")
        .arg(index + 1)
        .arg(QString::fromStdString(directionLetters(plane.normal)));
}

} // namespace

ClipForm::ClipForm(Of of)
    : PartFormOf<Clip>(of == Of::layer ? "/layers/*/clip" : "/clip",
                       of == Of::layer ? layerPart<&Layer::clip>(firstClip) : figureClip()),
      box_(new QCheckBox(labelOfSetting(at("box_mm")))), boxRows_(new QWidget), planes_(new QListWidget),
      cutHere_(new QPushButton(tr("Cut along the view here"))), flip_(new QPushButton(tr("Flip"))),
      remove_(new QPushButton(tr("Remove"))), face_(new QComboBox),
      faceColour_(new ColourButton(tr("Colour of cuts"))) {
    buildPlanes();
    buildFace();
    buildBox();
    onShow([this](const Clip& clip) {
        showBox(clip);
        showPlanes(clip);
        showFace(clip);
    });
}

void ClipForm::buildBox() {
    box_->setToolTip(helpOfSetting(at("box_mm")));
    QFormLayout* form = formLayout(boxRows_);
    const QString names[] = {tr("Right to left"), tr("Front to back"), tr("Bottom to top")};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto* pair = new QWidget;
        auto* row = new QHBoxLayout(pair);
        row->setContentsMargins(0, 0, 0, 0);
        for (std::size_t end = 0; end < 2; ++end) {
            auto* field = new QDoubleSpinBox;
            field->setRange(-kFarMm, kFarMm);
            field->setDecimals(1);
            field->setSuffix(tr(" mm"));
            field->setKeyboardTracking(false);
            field->setMinimumWidth(70);
            field->setToolTip(end == 0 ? tr("Where the box begins") : tr("Where the box ends"));
            field->setAccessibleName(tr("%1, %2").arg(names[axis], field->toolTip()));
            leaveWheelToPanel(field);
            row->addWidget(field, 1);
            connect(field, &QDoubleSpinBox::valueChanged, this,
                    [this, axis, end](double mm) { moveBoxEnd(axis, end, mm); });
            ends_[axis][end] = field;
        }
        addLabelled(form, names[axis], pair, ends_[axis][0]);
    }
    rows()->addRow(box_);
    rows()->addRow(boxRows_);
    connect(box_, &QCheckBox::clicked, this, [this](bool on) {
        change(on ? tr("Add clip box") : tr("Remove clip box"), {}, false,
               [&](Clip& clip) { clip.boxMm = on ? std::optional(scanBox(*figure())) : std::nullopt; });
    });
}

void ClipForm::moveBoxEnd(std::size_t axis, std::size_t end, double mm) {
    change(tr("Move side of clip box"), gesture_.again("clip/box" + std::to_string(axis * 2 + end)), false,
           [&](Clip& clip) {
               if (!clip.boxMm)
                   return;
               const auto i = static_cast<glm::length_t>(axis);
               BoxMm& box = *clip.boxMm;
               if (end == 0)
                   box.low[i] = std::min(mm, box.high[i] - kThinnestMm);
               else
                   box.high[i] = std::max(mm, box.low[i] + kThinnestMm);
           });
}

void ClipForm::buildPlanes() {
    planes_->setFixedHeight(kListHeight);
    planes_->setUniformItemSizes(true);
    planes_->setAccessibleName(labelOfSetting(at("planes")));
    planes_->setToolTip(helpOfSetting(at("planes")));
    cutHere_->setToolTip(tr("Add a plane through the middle of the view that faces the viewer: what is nearer goes"));
    flip_->setToolTip(tr("Cut away the other side of the chosen plane"));
    remove_->setToolTip(tr("Remove the chosen plane"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    buttons->addWidget(cutHere_);
    buttons->addWidget(flip_);
    buttons->addWidget(remove_);
    buttons->addStretch(1);
    rows()->addRow(planes_);
    rows()->addRow(buttons);
    offset_ = addRow(at("planes/*/offset_mm"), {-250, 250, 1}, {});
    connect(planes_, &QListWidget::currentRowChanged, this, [this] {
        showPlane();
        Q_EMIT planeChosen();
    });
    connect(cutHere_, &QPushButton::clicked, this, [this] {
        const std::size_t before = shown_.size();
        change(tr("Cut along the view"), {}, false,
               [&](Clip& clip) { clip.planes.push_back(planeHere(figure()->camera)); });
        if (shown_.size() > before)
            planes_->setCurrentRow(static_cast<int>(before));
    });
    connect(flip_, &QPushButton::clicked, this, [this] {
        changePlane(tr("Flip clip plane"), {}, false, [](ClipPlane& plane) {
            plane = {-plane.normal, -plane.offsetMm};
        });
    });
    connect(remove_, &QPushButton::clicked, this, [this] {
        if (const auto chosen = chosenPlane())
            change(tr("Remove clip plane"), {}, false,
                   [&](Clip& clip) { clip.planes.erase(clip.planes.begin() + static_cast<std::ptrdiff_t>(*chosen)); });
    });
    connect(offset_, &ParameterRow::changed, this, [this](double mm, const std::string& key, bool ongoing) {
        changePlane(tr("Move clip plane"), key, ongoing, [&](ClipPlane& plane) { plane.offsetMm = mm; });
    });
}

std::optional<std::size_t> ClipForm::chosenPlane() const {
    const int row = planes_->currentRow();
    return row >= 0 && static_cast<std::size_t>(row) < shown_.size() ? std::optional<std::size_t>(row) : std::nullopt;
}

void ClipForm::changePlane(const QString& label, const std::string& key, bool ongoing,
                           const std::function<void(ClipPlane&)>& by) {
    const auto chosen = chosenPlane();
    if (!chosen)
        return;
    const std::string own = key.empty() ? key : key + "/" + std::to_string(*chosen);
    change(label, own, ongoing, [&](Clip& clip) { by(clip.planes.at(*chosen)); });
}

void ClipForm::buildFace() {
    face_->setToolTip(helpOfSetting(at("face")));
    face_->setAccessibleName(labelOfSetting(at("face")));
    face_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    leaveWheelToPanel(face_);
    faceColour_->setToolTip(helpOfSetting(at("face/rgb")));
    auto* pair = new QWidget;
    auto* row = new QHBoxLayout(pair);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(face_, 1);
    row->addWidget(faceColour_);
    addLabelled(rows(), labelOfSetting(at("face")), pair, face_);
    connect(face_, &QComboBox::activated, this, &ClipForm::chooseFace);
    connect(faceColour_, &ColourButton::chosen, this, [this](const glm::dvec3& rgb) {
        change(tr("Change colour of cuts"), {}, false, [&](Clip& clip) { clip.face = CutFace{{}, rgb}; });
    });
}

void ClipForm::chooseFace(int row) {
    change(tr("Change cut faces"), {}, false, [&](Clip& clip) {
        clip.face.reset();
        if (row == kOwnFace)
            clip.face = CutFace{};
        else if (row == kColourFace)
            clip.face = CutFace{{}, faceColour_->colour()};
        else if (row >= kFirstStyle)
            clip.face = CutFace{face_->itemData(row).toString().toStdString(), std::nullopt};
    });
}

void ClipForm::showBox(const Clip& clip) {
    box_->setChecked(clip.boxMm.has_value());
    boxRows_->setVisible(clip.boxMm.has_value());
    if (!clip.boxMm)
        return;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t end = 0; end < 2; ++end) {
            const QSignalBlocker quiet(ends_[axis][end]);
            const auto i = static_cast<glm::length_t>(axis);
            ends_[axis][end]->setValue(end == 0 ? clip.boxMm->low[i] : clip.boxMm->high[i]);
        }
}

void ClipForm::showPlanes(const Clip& clip) {
    shown_ = clip.planes;
    {
        const QSignalBlocker quiet(planes_);
        const int count = static_cast<int>(shown_.size());
        while (planes_->count() > count)
            delete planes_->takeItem(planes_->count() - 1);
        while (planes_->count() < count)
            planes_->addItem(QString());
        for (std::size_t i = 0; i < shown_.size(); ++i)
            planes_->item(static_cast<int>(i))->setText(planeText(i, shown_[i]));
        if (count > 0 && planes_->currentRow() < 0)
            planes_->setCurrentRow(0);
    }
    planes_->setVisible(!shown_.empty());
    cutHere_->setEnabled(shown_.size() < kMostPlanes);
    showPlane();
}

void ClipForm::showPlane() {
    const auto chosen = chosenPlane();
    for (QWidget* control : std::initializer_list<QWidget*>{flip_, remove_, offset_})
        control->setEnabled(chosen.has_value());
    if (chosen)
        offset_->setValue(shown_[*chosen].offsetMm);
}

void ClipForm::showFace(const Clip& clip) {
    face_->clear();
    face_->addItem(tr("As the data are"));
    face_->addItem(tr("Flat, as the layer"));
    face_->addItem(tr("Flat, in a colour"));
    for (const StyleEntry& style : figure()->styles)
        face_->addItem(tr("Flat, in “%1”").arg(QString::fromStdString(style.name.empty() ? style.id : style.name)),
                       QString::fromStdString(style.id));
    int row = clip.face ? kOwnFace : kNoFace;
    if (clip.face && !clip.face->style.empty())
        row = face_->findData(QString::fromStdString(clip.face->style));
    else if (clip.face && clip.face->rgb)
        row = kColourFace;
    face_->setCurrentIndex(row);
    faceColour_->setVisible(row == kColourFace);
    if (clip.face && clip.face->rgb)
        faceColour_->setColour(*clip.face->rgb);
}

} // namespace limner
