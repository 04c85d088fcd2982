#include "app/studio/export_dialog.h"

#include "core/base/error.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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

/// Sizes that are asked for again and again.
struct Size {
    const char* text;
    double width;  ///< mm or pixels; 0: the figure's own size
    double height; ///< 0: by the figure's proportions
    bool pixels = false;
};

constexpr Size kSizes[] = {
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "As in the figure"), 0, 0},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "Journal, one column (85 mm)"), 85, 0},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "Journal, one and a half columns (120 mm)"), 120, 0},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "Journal, page width (180 mm)"), 180, 0},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "A4 (210 × 297 mm)"), 210, 297},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "A3 (297 × 420 mm)"), 297, 420},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "A2 (420 × 594 mm)"), 420, 594},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "A1 (594 × 841 mm)"), 594, 841},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "A0, poster (841 × 1189 mm)"), 841, 1189},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "Screen (1920 × 1080 pixels)"), 1920, 1080, true},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "Square (1080 × 1080 pixels)"), 1080, 1080, true},
    {QT_TRANSLATE_NOOP("limner::ExportDialog", "Other"), 0, 0},
};
constexpr int kOther = static_cast<int>(std::size(kSizes)) - 1;

enum Unit { millimetres, inches, pixels };
constexpr double kMmPerInch = 25.4;

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
    : QDialog(parent), own_(figure.output), aspect_(figure.output.widthMm / std::max(figure.output.heightMm, 1e-6)),
      widthMm_(figure.output.widthMm), heightMm_(figure.output.heightMm), secondsPerMegaPixel_(secondsPerMegaPixel),
      sizes_(new QComboBox), units_(new QComboBox), width_(new QDoubleSpinBox), height_(new QDoubleSpinBox),
      keepAspect_(new QCheckBox(tr("&Keep proportions"))), dpi_(new QSpinBox), format_(new QComboBox),
      depth_(new QComboBox), smoothing_(new QComboBox), transparent_(new QCheckBox(tr("&Transparent background"))),
      estimate_(new QLabel), buttons_(new QDialogButtonBox(QDialogButtonBox::Cancel)),
      go_(buttons_->addButton(tr("Export…"), QDialogButtonBox::AcceptRole)) {
    setWindowTitle(tr("Export picture"));
    fillChoices(figure);
    recall(figure);
    arrange();
    showLengths();
    connectFields();
    showEstimate();
}

void ExportDialog::fillChoices(const Figure& figure) {
    for (const Size& size : kSizes)
        sizes_->addItem(tr(size.text));
    sizes_->setToolTip(tr("Usual sizes; sheets lie or stand as the figure does"));
    units_->addItem(tr("mm"), millimetres);
    units_->addItem(tr("inches"), inches);
    units_->addItem(tr("pixels"), pixels);
    units_->setToolTip(tr("Unit of width and height"));
    width_->setAccessibleName(tr("Width"));
    height_->setAccessibleName(tr("Height"));
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
    smoothing_->setToolTip(tr("More rays make edges smoother and take as many times longer"));
    transparent_->setChecked(figure.output.transparent);
}

void ExportDialog::recall(const Figure& figure) {
    const QSettings settings;
    const auto set = [&](QComboBox* box, const char* name, const QVariant& usual) {
        box->setCurrentIndex(std::max(0, box->findData(settings.value(name, usual))));
    };
    set(format_, "export/ending", QString("png"));
    set(units_, "export/unit", millimetres);
    set(depth_, "export/depth", static_cast<int>(SampleDepth::eight));
    smoothing_->setCurrentIndex(std::max(0, smoothing_->findData(figure.quality.samplesPerPixel)));
    if (const int last = smoothing_->findData(settings.value("export/smoothing")); last >= 0)
        smoothing_->setCurrentIndex(last);
}

void ExportDialog::accept() {
    QSettings settings;
    settings.setValue("export/ending", format_->currentData());
    settings.setValue("export/unit", units_->currentData());
    settings.setValue("export/depth", depth_->currentData());
    settings.setValue("export/smoothing", smoothing_->currentData());
    QDialog::accept();
}

void ExportDialog::arrange() {
    auto* lengths = new QHBoxLayout;
    lengths->addWidget(width_, 1);
    lengths->addWidget(new QLabel(QStringLiteral("×")));
    lengths->addWidget(height_, 1);
    lengths->addWidget(units_);
    auto* form = new QFormLayout;
    form->addRow(tr("&Size"), sizes_);
    auto* label = new QLabel(tr("&Width × height"));
    label->setBuddy(width_);
    form->addRow(label, lengths);
    form->addRow(QString(), keepAspect_);
    form->addRow(tr("&Resolution"), dpi_);
    form->addRow(tr("&File"), format_);
    form->addRow(tr("&Depth"), depth_);
    form->addRow(tr("S&moothing"), smoothing_);
    form->addRow(QString(), transparent_);
    go_->setDefault(true);
    go_->setToolTip(tr("Choose the file; it is written while you go on working"));
    estimate_->setMinimumWidth(340);
    estimate_->setFrameShape(QFrame::StyledPanel);
    estimate_->setMargin(8);
    estimate_->setWordWrap(true);
    estimate_->setAccessibleName(tr("What that takes"));
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->addLayout(form);
    layout->addWidget(estimate_);
    layout->addWidget(buttons_);
    QWidget* order[] = {sizes_, width_, height_, units_, keepAspect_, dpi_, format_, depth_, smoothing_, transparent_};
    for (std::size_t i = 1; i < std::size(order); ++i)
        setTabOrder(order[i - 1], order[i]);
}

void ExportDialog::connectFields() {
    connect(sizes_, &QComboBox::activated, this, &ExportDialog::useSize);
    connect(units_, &QComboBox::currentIndexChanged, this, &ExportDialog::showLengths);
    connect(width_, &QDoubleSpinBox::valueChanged, this, [this] { lengthChanged(true); });
    connect(height_, &QDoubleSpinBox::valueChanged, this, [this] { lengthChanged(false); });
    connect(keepAspect_, &QCheckBox::toggled, this, [this] { aspect_ = widthMm_ / heightMm_; });
    connect(dpi_, &QSpinBox::valueChanged, this, &ExportDialog::dpiChanged);
    for (QComboBox* box : {format_, depth_, smoothing_})
        connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::showEstimate);
    connect(transparent_, &QCheckBox::toggled, this, &ExportDialog::showEstimate);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

double ExportDialog::mmPerUnit() const {
    switch (units_->currentData().toInt()) {
    case inches: return kMmPerInch;
    case pixels: return kMmPerInch / dpi_->value();
    default: return 1;
    }
}

void ExportDialog::useSize(int place) {
    const Size& size = kSizes[place];
    if (place == 0) {
        widthMm_ = own_.widthMm;
        heightMm_ = own_.heightMm;
        aspect_ = widthMm_ / heightMm_;
        dpi_->setValue(static_cast<int>(std::lround(own_.dpi)));
        showLengths();
    }
    if (size.width <= 0)
        return;
    if (size.pixels) {
        constexpr int kScreenDpi = 96;
        const QSignalBlocker quiet(dpi_);
        dpi_->setValue(kScreenDpi);
        units_->setCurrentIndex(units_->findData(pixels));
    }
    const double unit = size.pixels ? kMmPerInch / dpi_->value() : 1;
    const bool lies = aspect_ > 1 && !size.pixels;
    widthMm_ = (lies && size.height > 0 ? size.height : size.width) * unit;
    heightMm_ = size.height > 0 ? (lies ? size.width : size.height) * unit : widthMm_ / aspect_;
    aspect_ = widthMm_ / heightMm_;
    showLengths();
}

void ExportDialog::showLengths() {
    const bool whole = units_->currentData().toInt() == pixels;
    for (const auto& [field, mm] : {std::pair{width_, widthMm_}, std::pair{height_, heightMm_}}) {
        const QSignalBlocker quiet(field);
        field->setDecimals(whole ? 0 : units_->currentData().toInt() == inches ? 2 : 1);
        field->setRange(1 / (whole ? 1 : kMmPerInch), kLargestMm / mmPerUnit());
        field->setValue(mm / mmPerUnit());
    }
    showEstimate();
}

void ExportDialog::lengthChanged(bool widthLeads) {
    (widthLeads ? widthMm_ : heightMm_) = (widthLeads ? width_ : height_)->value() * mmPerUnit();
    if (keepAspect_->isChecked()) {
        const QSignalBlocker quietWidth(width_);
        const QSignalBlocker quietHeight(height_);
        if (widthLeads)
            height_->setValue((heightMm_ = widthMm_ / aspect_) / mmPerUnit());
        else
            width_->setValue((widthMm_ = heightMm_ * aspect_) / mmPerUnit());
    }
    sizes_->setCurrentIndex(kOther);
    showEstimate();
}

/// In pixels the number of pixels stays, else the size on paper.
void ExportDialog::dpiChanged() {
    if (units_->currentData().toInt() == pixels) {
        widthMm_ = width_->value() * mmPerUnit();
        heightMm_ = height_->value() * mmPerUnit();
    }
    showLengths();
}

QString ExportDialog::estimate() const { return estimate_->text(); }

ExportDialog::Choice ExportDialog::choice() const {
    const Format& format = kFormats[format_->currentIndex()];
    Choice choice;
    choice.output = {widthMm_, heightMm_, static_cast<double>(dpi_->value()),
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
    const double count = static_cast<double>(size.x) * size.y;
    const int bytes = chosen.depth == SampleDepth::sixteen ? 2 : format.bytesPerSample;
    const double raw = count * bytes * (chosen.output.transparent || format.bytesPerSample == 4 ? 4 : 3);
    const QString facts = format.vector
                              ? tr("<b>Ink as vectors</b>; shaded layers as a picture of<br>%1 × %2 pixels, at most %3")
                              : tr("<b>%1 × %2 pixels</b><br>at most %3 before compression");
    QString text = facts.arg(QLocale().toString(size.x), QLocale().toString(size.y), bytesText(raw));
    if (secondsPerMegaPixel_ > 0)
        text += tr("; %1 to draw").arg(durationText(count * 1e-6 * secondsPerMegaPixel_ * chosen.samplesPerPixel));
    PictureOptions options;
    options.depth = chosen.depth;
    options.transparent = chosen.output.transparent;
    bool possible = true;
    try {
        text += tr("<br>%1 of memory beside the scan")
                    .arg(bytesText(static_cast<double>(exportMemory(format.ending, size, options))));
    } catch (const Error& error) {
        possible = false;
        text += "<br>" + QString::fromUtf8(error.what()).toHtmlEscaped();
    }
    go_->setEnabled(possible);
    estimate_->setText(text);
}

} // namespace limner
