#include "widgets/transfer_editor_2d.h"

#include "core/figure/layer_edits.h"
#include "core/figure/plane_view.h"
#include "widgets/form_parts.h"
#include "widgets/transfer_parts.h"

#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr int kIcon = 18;

/// What a tool draws, as it looks.
QIcon iconOf(PlaneTool tool, const QPalette& palette, double pixelRatio) {
    QPixmap pixmap(QSize(kIcon, kIcon) * pixelRatio);
    pixmap.setDevicePixelRatio(pixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette.color(QPalette::ButtonText), 1.5));
    const QRectF box(2.5, 4.5, 13, 9);
    switch (tool) {
    case PlaneTool::select:
        painter.setBrush(palette.color(QPalette::ButtonText));
        painter.drawPolygon(QPolygonF({{4, 2}, {4, 14}, {7.3, 11}, {10, 16}, {11.6, 15}, {9, 10.2}, {13, 10}}));
        break;
    case PlaneTool::rectangle: painter.drawRect(box); break;
    case PlaneTool::trapezoid: painter.drawPolygon(QPolygonF({{2, 14}, {6, 4}, {12, 4}, {16, 14}})); break;
    case PlaneTool::ellipse: painter.drawEllipse(box); break;
    case PlaneTool::polygon: painter.drawPolygon(QPolygonF({{3, 6}, {11, 3}, {16, 9}, {10, 15}, {4, 13}})); break;
    case PlaneTool::paint:
        painter.setPen(QPen(palette.color(QPalette::ButtonText), 4, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(4, 13), QPointF(13, 5));
        break;
    case PlaneTool::erase:
        painter.drawEllipse(QPointF(9, 9), 5.5, 5.5);
        painter.drawLine(QPointF(5, 13), QPointF(13, 5));
        break;
    }
    return pixmap;
}

QDoubleSpinBox* percentBox(const QString& name, const QString& tip) {
    auto* box = new QDoubleSpinBox;
    box->setRange(0, 100);
    box->setDecimals(0);
    box->setSuffix(QObject::tr(" %"));
    box->setKeyboardTracking(false);
    box->setAccessibleName(name);
    box->setToolTip(tip);
    leaveWheelToPanel(box);
    return box;
}

QWidget* rowOf(std::initializer_list<QWidget*> widgets) {
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (QWidget* widget : widgets)
        row->addWidget(widget);
    return holder;
}

/// Range, digits and unit of a field along an axis.
void suit(QDoubleSpinBox* box, ValueRange range, const QString& unit) {
    const QSignalBlocker quiet(box);
    const double width = std::max(range.high - range.low, 1e-6);
    box->setRange(range.low - width, range.high + width); // shapes may reach past the data
    box->setDecimals(width >= 200 ? 0 : std::clamp(static_cast<int>(std::ceil(3 - std::log10(width))), 0, 8));
    box->setSingleStep(std::pow(10.0, std::floor(std::log10(width / 200))));
    box->setSuffix(unit.isEmpty() ? QString() : " " + unit);
}

} // namespace

TransferEditor2d::TransferEditor2d(QWidget* parent)
    : QWidget(parent), canvas_(new TransferCanvas2d), tools_(new QButtonGroup(this)),
      duplicate_(textButton(tr("Copy"), tr("Duplicate the selected shape (Ctrl+D)"))),
      remove_(textButton(tr("Remove"), tr("Remove the selected shape or polygon point (Delete)"))),
      brushSize_(new QSlider(Qt::Horizontal)), brushSoftness_(new QSlider(Qt::Horizontal)), note_(new QLabel),
      x_(new QDoubleSpinBox), y_(new QDoubleSpinBox),
      opacity_(percentBox(tr("Opacity of the shape"),
                          tr("Opacity inside the shape, in percent for a thickness of one voxel"))),
      softness_(percentBox(tr("Softness of the shape"),
                           tr("Width of the soft border inside the shape, in percent of half its extent"))),
      addColumn_(textButton(tr("+ Column"),
                            tr("Add a column of styles to the grid; drop styles from the gallery onto the balls"))),
      addRow_(
          textButton(tr("+ Row"), tr("Add a row of styles to the grid; drop styles from the gallery onto the balls"))),
      removeColumn_(textButton(tr("− Column"), tr("Remove the selected style's column"))),
      removeRow_(textButton(tr("− Row"), tr("Remove the selected style's row"))) {
    brush_ = brushRow();
    note_->setWordWrap(true);
    note_->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 8);
    layout->setSpacing(5);
    layout->addWidget(toolRow());
    layout->addWidget(brush_);
    layout->addWidget(note_);
    layout->addWidget(canvas_, 1);
    layout->addWidget(numberRow());
    layout->addWidget(gridRow());
    connect(canvas_, &TransferCanvas2d::edited, this, &TransferEditor2d::edited);
    connect(canvas_, &TransferCanvas2d::selectionChanged, this, [this] {
        showSelection();
        Q_EMIT selectionChanged();
    });
    connect(canvas_, &TransferCanvas2d::toolChanged, this, [this](PlaneTool tool) {
        button(tool)->setChecked(true);
        brush_->hide();
    });
    connectNumbers();
    showSelection();
}

QToolButton* TransferEditor2d::button(PlaneTool tool) const {
    return qobject_cast<QToolButton*>(tools_->button(static_cast<int>(tool)));
}

QWidget* TransferEditor2d::toolRow() {
    const std::pair<PlaneTool, QString> tools[] = {
        {PlaneTool::select, tr("Select, move and resize shapes and styles (Esc)")},
        {PlaneTool::rectangle, tr("Draw a rectangle of opacity")},
        {PlaneTool::trapezoid, tr("Draw a trapezoid: ramps along the first axis")},
        {PlaneTool::ellipse, tr("Draw an ellipse of opacity")},
        {PlaneTool::polygon, tr("Draw a polygon; a double click on it adds a point")},
        {PlaneTool::paint, tr("Paint opacity freely, with a brush")},
        {PlaneTool::erase, tr("Erase painted opacity of the selected mask")},
    };
    auto* holder = new QWidget;
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(1);
    for (const auto& [tool, tip] : tools) {
        auto* button = new QToolButton;
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setIconSize({kIcon, kIcon});
        button->setIcon(iconOf(tool, palette(), devicePixelRatioF()));
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        tools_->addButton(button, static_cast<int>(tool));
        row->addWidget(button);
    }
    button(PlaneTool::select)->setChecked(true);
    row->addStretch(1);
    row->addWidget(zoomButtons(canvas_));
    connect(tools_, &QButtonGroup::idClicked, this, [this](int id) {
        const auto tool = static_cast<PlaneTool>(id);
        canvas_->setTool(tool);
        brush_->setVisible(tool == PlaneTool::paint || tool == PlaneTool::erase);
    });
    return holder;
}

QWidget* TransferEditor2d::brushRow() {
    auto* size = new QLabel(tr("Brush"));
    auto* soft = new QLabel(tr("Soft"));
    brushSize_->setRange(2, 80);
    brushSize_->setAccessibleName(tr("Radius of the brush"));
    brushSize_->setToolTip(tr("Radius of the brush, in pixels of the plane"));
    brushSoftness_->setRange(0, 100);
    brushSoftness_->setAccessibleName(tr("Softness of the brush"));
    brushSoftness_->setToolTip(tr("Share of the brush's radius over which it fades, in percent"));
    brushSize_->setValue(static_cast<int>(canvas_->brush().radius));
    brushSoftness_->setValue(static_cast<int>(canvas_->brush().softness * 100));
    for (QSlider* slider : {brushSize_, brushSoftness_}) {
        leaveWheelToPanel(slider);
        connect(slider, &QSlider::valueChanged, this, [this] {
            canvas_->setBrush({static_cast<double>(brushSize_->value()), brushSoftness_->value() / 100.0});
        });
    }
    size->setBuddy(brushSize_);
    soft->setBuddy(brushSoftness_);
    QWidget* row = rowOf({size, brushSize_, soft, brushSoftness_});
    row->hide();
    return row;
}

QWidget* TransferEditor2d::numberRow() {
    for (QDoubleSpinBox* box : {x_, y_}) {
        box->setKeyboardTracking(false);
        leaveWheelToPanel(box);
    }
    x_->setAccessibleName(tr("Place on the first axis"));
    x_->setToolTip(tr("Place of what is selected on the first axis, in its unit"));
    y_->setAccessibleName(tr("Place on the second axis"));
    y_->setToolTip(tr("Place of what is selected on the second axis, in its unit"));
    auto* holder = new QWidget;
    auto* form = new QGridLayout(holder);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(4);
    form->setVerticalSpacing(1);
    int column = 0;
    for (const auto& [box, text] : {std::pair(x_, tr("First axis")), std::pair(y_, tr("Second axis")),
                                    std::pair(opacity_, tr("Opacity")), std::pair(softness_, tr("Softness"))}) {
        auto* label = new QLabel(text);
        label->setBuddy(box);
        label->setToolTip(box->toolTip());
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // long words must not widen the panel
        form->addWidget(label, 0, column);
        form->addWidget(box, 1, column);
        form->setColumnStretch(column++, 1);
    }
    return holder;
}

QWidget* TransferEditor2d::gridRow() {
    QWidget* row = rowOf({duplicate_, remove_});
    auto* layout = qobject_cast<QHBoxLayout*>(row->layout());
    layout->setSpacing(3);
    layout->addStretch(1);
    for (QToolButton* button : {addColumn_, addRow_, removeColumn_, removeRow_})
        layout->addWidget(button);
    connect(addColumn_, &QToolButton::clicked, canvas_, &TransferCanvas2d::addColumn);
    connect(addRow_, &QToolButton::clicked, canvas_, &TransferCanvas2d::addRow);
    connect(removeColumn_, &QToolButton::clicked, canvas_, &TransferCanvas2d::removeColumn);
    connect(removeRow_, &QToolButton::clicked, canvas_, &TransferCanvas2d::removeRow);
    return row;
}

void TransferEditor2d::connectNumbers() {
    const auto move = [this] { canvas_->moveSelected({x_->value(), y_->value()}); };
    connect(x_, &QDoubleSpinBox::valueChanged, this, move);
    connect(y_, &QDoubleSpinBox::valueChanged, this, move);
    connect(opacity_, &QDoubleSpinBox::valueChanged, this,
            [this](double percent) { canvas_->setOpacity(percent / 100); });
    connect(softness_, &QDoubleSpinBox::valueChanged, this,
            [this](double percent) { canvas_->setSoftness(percent / 100); });
    connect(duplicate_, &QToolButton::clicked, canvas_, &TransferCanvas2d::duplicateSelected);
    connect(remove_, &QToolButton::clicked, canvas_, &TransferCanvas2d::removeSelected);
}

void TransferEditor2d::setNote(const QString& note) {
    note_->setText(note);
    note_->setVisible(!note.isEmpty());
}

void TransferEditor2d::setFigure(std::shared_ptr<const Figure> figure, std::size_t layer) {
    locked_ = figure && layer < figure->layers.size() && !mayChange(*figure, layer);
    canvas_->setEnabled(!locked_);
    if (figure && layer < figure->layers.size()) {
        const Transfer& t = figure->layers[layer].transfer;
        const auto unitOf = [&](TransferAxis axis) {
            const Volume* scan = scanOf(figure.get());
            return axis == TransferAxis::value       ? QString::fromStdString(scan ? scan->contents().unit : "")
                   : axis == TransferAxis::distance  ? tr("mm")
                   : axis == TransferAxis::curvature ? tr("1/mm")
                                                     : QString();
        };
        suit(x_, shownRange(*figure, t, firstAxis(t)), unitOf(firstAxis(t)));
        if (const auto second = secondAxis(t))
            suit(y_, shownRange(*figure, t, *second), unitOf(*second));
    }
    canvas_->setFigure(std::move(figure), layer);
}

void TransferEditor2d::showSelection() {
    const auto& handle = canvas_->selected();
    const Transfer* t = canvas_->transfer();
    const bool editable = t && !locked_;
    const OpacityShape* shape = nullptr;
    if (const auto index = canvas_->selectedShape(); t && index)
        shape = &t->opacity2d[*index];
    const auto node = t ? canvas_->selectedNode() : std::nullopt;
    const auto place = handle ? canvas_->placeOf(*handle) : std::nullopt;
    for (QDoubleSpinBox* box : {x_, y_, opacity_, softness_})
        box->blockSignals(true);
    if (place) {
        x_->setValue(place->x);
        y_->setValue(place->y);
    }
    if (shape) {
        opacity_->setValue(shape->opacity * 100);
        softness_->setValue(shape->soft * 100);
    }
    for (QDoubleSpinBox* box : {x_, y_, opacity_, softness_})
        box->blockSignals(false);
    x_->setEnabled(editable && place);
    y_->setEnabled(editable && place);
    opacity_->setEnabled(editable && shape);
    const bool soft = shape && shape->shape != "trapezoid" && shape->shape != "mask";
    softness_->setEnabled(editable && soft); // ramps and brushes are soft by themselves
    duplicate_->setEnabled(editable && shape);
    remove_->setEnabled(editable && shape);
    const bool grid = editable && t->grid;
    addColumn_->setEnabled(grid);
    addRow_->setEnabled(grid);
    removeColumn_->setEnabled(grid && node && t->grid->x.size() > 1);
    removeRow_->setEnabled(grid && node && t->grid->y.size() > 1);
}

} // namespace limner
