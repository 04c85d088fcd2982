#include "app/studio/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

constexpr double kLargestMm = 5000; // a wall

struct Format {
    const char* ending;
    const char* text;
    bool alpha;
    bool sixteen;
    int bytesPerSample;  ///< at the format's own depth
    bool vector = false; ///< ink stays circles and paths
};

constexpr Format kFormats[] = {
    {"png", QT_TRANSLATE_NOOP("limner::ExportDialog", "PNG – screen, slides, journals"), true, true, 1},
    {"tif", QT_TRANSLATE_NOOP("limner::ExportDialog", "TIFF – print"), true, true, 1},
    {"jpg", QT_TRANSLATE_NOOP("limner::ExportDialog", "JPEG – small, with losses"), false, false, 1},
    {"webp", QT_TRANSLATE_NOOP("limner::ExportDialog", "WebP – web pages"), true, false, 1},
    {"exr", QT_TRANSLATE_NOOP("limner::ExportDialog", "OpenEXR – compositing, 32-bit float"), true, false, 4},
    {"svg", QT_TRANSLATE_NOOP("limner::ExportDialog", "SVG – ink as circles and paths, to go on drawing"), true, false,
     1, true},
    {"pdf", QT_TRANSLATE_NOOP("limner::ExportDialog", "PDF – ink as circles and paths, print"), true, false, 1, true},
};

QDoubleSpinBox* lengthField(double valueMm, const QString& name) {
    auto* field = new QDoubleSpinBox;
    field->setRange(1, kLargestMm);
    field->setDecimals(1);
    field->setSuffix(QStringLiteral(" mm"));
    field->setValue(valueMm);
    field->setAccessibleName(name);
    return field;
}

} // namespace

QString durationText(double seconds) {
    if (seconds < 1)
        return ExportDialog::tr("less than a second");
    if (seconds < 90)
        return ExportDialog::tr("about %1 s").arg(std::lround(seconds));
    if (seconds < 5400)
        return ExportDialog::tr("about %1 min").arg(std::lround(seconds / 60));
    return ExportDialog::tr("about %1 h").arg(seconds / 3600, 0, 'f', 1);
}

QString bytesText(double bytes) {
    return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeTraditionalFormat);
}

ExportDialog::ExportDialog(const Figure& figure, double secondsPerMegaPixel, QWidget* parent)
    : QDialog(parent), aspect_(figure.output.widthMm / std::max(figure.output.heightMm, 1e-6)),
      secondsPerMegaPixel_(secondsPerMegaPixel), width_(lengthField(figure.output.widthMm, tr("Width"))),
      height_(lengthField(figure.output.heightMm, tr("Height"))), keepAspect_(new QCheckBox(tr("&Keep proportions"))),
      dpi_(new QSpinBox), format_(new QComboBox), depth_(new QComboBox), smoothing_(new QComboBox),
      transparent_(new QCheckBox(tr("&Transparent background"))), estimate_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("Export picture"));
    keepAspect_->setChecked(true);
    keepAspect_->setToolTip(tr("Width and height change together"));
    dpi_->setRange(10, 4800);
    dpi_->setValue(static_cast<int>(std::lround(figure.output.dpi)));
    dpi_->setSuffix(tr(" dpi"));
    dpi_->setToolTip(tr("Pixels per inch of paper: 300 for halftones, 600 to 1200 for line art, 96 for screens"));
    for (const Format& format : kFormats)
        format_->addItem(tr(format.text), QString(format.ending));
    depth_->addItem(tr("8 bits"), static_cast<int>(SampleDepth::eight));
    depth_->addItem(tr("16 bits"), static_cast<int>(SampleDepth::sixteen));
    depth_->setToolTip(tr("Bits of each colour: 16 where the picture will be graded further"));
    for (const int samples : {1, 4, 16})
        smoothing_->addItem(samples == 1 ? tr("1 ray per pixel") : tr("%1 rays per pixel").arg(samples), samples);
    smoothing_->setCurrentIndex(std::max(0, smoothing_->findData(figure.quality.samplesPerPixel)));
    smoothing_->setToolTip(tr("More rays make edges smoother and take as many times longer"));
    transparent_->setChecked(figure.output.transparent);
    auto* form = new QFormLayout;
    form->addRow(tr("&Width"), width_);
    form->addRow(tr("&Height"), height_);
    form->addRow(QString(), keepAspect_);
    form->addRow(tr("&Resolution"), dpi_);
    form->addRow(tr("&File"), format_);
    form->addRow(tr("&Depth"), depth_);
    form->addRow(tr("&Smoothing"), smoothing_);
    form->addRow(QString(), transparent_);
    QPushButton* go = buttons_->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
    go->setDefault(true);
    estimate_->setMinimumWidth(340);
    estimate_->setFrameShape(QFrame::StyledPanel);
    estimate_->setMargin(8);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addLayout(form);
    layout->addWidget(estimate_);
    layout->addWidget(buttons_);

    connect(width_, &QDoubleSpinBox::valueChanged, this, [this] { sizeChanged(true); });
    connect(height_, &QDoubleSpinBox::valueChanged, this, [this] { sizeChanged(false); });
    connect(keepAspect_, &QCheckBox::toggled, this, [this] { aspect_ = width_->value() / height_->value(); });
    connect(dpi_, &QSpinBox::valueChanged, this, &ExportDialog::showEstimate);
    connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::showEstimate);
    connect(depth_, &QComboBox::currentIndexChanged, this, &ExportDialog::showEstimate);
    connect(smoothing_, &QComboBox::currentIndexChanged, this, &ExportDialog::showEstimate);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showEstimate();
}

void ExportDialog::sizeChanged(bool widthLeads) {
    if (keepAspect_->isChecked()) {
        const QSignalBlocker quietWidth(width_);
        const QSignalBlocker quietHeight(height_);
        if (widthLeads)
            height_->setValue(width_->value() / aspect_);
        else
            width_->setValue(height_->value() * aspect_);
    }
    showEstimate();
}

ExportDialog::Choice ExportDialog::choice() const {
    const Format& format = kFormats[format_->currentIndex()];
    Choice choice;
    choice.output = {width_->value(), height_->value(), static_cast<double>(dpi_->value()),
                     transparent_->isEnabled() && transparent_->isChecked()};
    choice.ending = QString(format.ending);
    if (format.sixteen)
        choice.depth = static_cast<SampleDepth>(depth_->currentData().toInt());
    choice.samplesPerPixel = smoothing_->currentData().toInt();
    return choice;
}

void ExportDialog::showEstimate() {
    const Format& format = kFormats[format_->currentIndex()];
    depth_->setEnabled(format.sixteen);
    transparent_->setEnabled(format.alpha);
    transparent_->setToolTip(format.alpha ? tr("Nothing behind the figure instead of its background")
                                          : tr("JPEG cannot be transparent"));
    const Choice chosen = choice();
    const glm::ivec2 size = chosen.output.sizePixels();
    const double pixels = static_cast<double>(size.x) * size.y;
    const int bytes = chosen.depth == SampleDepth::sixteen ? 2 : format.bytesPerSample;
    const double raw = pixels * bytes * (chosen.output.transparent || format.bytesPerSample == 4 ? 4 : 3);
    const QString facts = format.vector
                              ? tr("<b>Ink as vectors</b>; shaded layers as a picture of<br>%1 × %2 pixels, at most %3")
                              : tr("<b>%1 × %2 pixels</b><br>at most %3 before compression");
    QString text = facts.arg(QLocale().toString(size.x), QLocale().toString(size.y), bytesText(raw));
    if (secondsPerMegaPixel_ > 0)
        text += tr("; %1 to draw").arg(durationText(pixels * 1e-6 * secondsPerMegaPixel_ * chosen.samplesPerPixel));
    estimate_->setText(text);
}

} // namespace limner
