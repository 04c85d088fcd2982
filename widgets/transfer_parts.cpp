#include "widgets/transfer_parts.h"

#include "core/figure/plane_view.h"
#include "widgets/form_parts.h"
#include "widgets/transfer_plane.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QToolButton>

#include <array>

namespace limner {
namespace {

constexpr std::array<const char*, 7> kAxes{"value",     "gradient", "label",     "distance",
                                           "curvature", "second",   "importance"};

QString translated(const char* text) { return QCoreApplication::translate("Axes", text); }

} // namespace

std::span<const char* const> axisWords() { return kAxes; }

QString axisName(const std::string& word) {
    switch (transferAxis(word)) {
    case TransferAxis::value: return translated(QT_TRANSLATE_NOOP("Axes", "Value"));
    case TransferAxis::gradient: return translated(QT_TRANSLATE_NOOP("Axes", "Gradient"));
    case TransferAxis::label: return translated(QT_TRANSLATE_NOOP("Axes", "Label"));
    case TransferAxis::distance: return translated(QT_TRANSLATE_NOOP("Axes", "Distance"));
    case TransferAxis::curvature: return translated(QT_TRANSLATE_NOOP("Axes", "Curvature"));
    case TransferAxis::second: return translated(QT_TRANSLATE_NOOP("Axes", "Second scan"));
    case TransferAxis::importance: break;
    }
    return translated(QT_TRANSLATE_NOOP("Axes", "Importance"));
}

QString axisMissing(const Figure& figure, const std::string& word) {
    const TransferAxis axis = transferAxis(word);
    if (axisThere(figure, axis))
        return {};
    if (axis == TransferAxis::label)
        return translated(QT_TRANSLATE_NOOP("Axes",
                                            "This scan has no labels: open a label volume (File, Open labels) or "
                                            "take another axis."));
    if (axis == TransferAxis::second)
        return translated(
            QT_TRANSLATE_NOOP("Axes", "This figure has no second scan: give it one, or take another axis."));
    return translated(QT_TRANSLATE_NOOP("Axes", "This figure weighs nothing by importance: set a measure in the "
                                                "Importance panel, or take another axis."));
}

QWidget* zoomButtons(TransferPlane* canvas) {
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    const auto add = [&](const QString& text, const QString& tip, auto run) {
        QToolButton* button = textButton(text, tip);
        button->setAccessibleName(tip);
        QObject::connect(button, &QToolButton::clicked, canvas, run);
        row->addWidget(button);
    };
    constexpr double kStep = 0.7;
    add(QStringLiteral("−"), translated(QT_TRANSLATE_NOOP("Axes", "Show more of the axis (−)")),
        [canvas] { canvas->zoomBy(1 / kStep); });
    add(QStringLiteral("+"), translated(QT_TRANSLATE_NOOP("Axes", "Show less of the axis, larger (+)")),
        [canvas] { canvas->zoomBy(kStep); });
    add(translated(QT_TRANSLATE_NOOP("Axes", "Fit")),
        translated(QT_TRANSLATE_NOOP("Axes", "Show the values that nearly all voxels have, rare ones left out (Home)")),
        [canvas] { canvas->showAll(); });
    add(translated(QT_TRANSLATE_NOOP("Axes", "All")),
        translated(QT_TRANSLATE_NOOP("Axes", "Show all values of the scan, the rarest too")),
        [canvas] { canvas->showWhole(); });
    return buttons;
}

} // namespace limner
