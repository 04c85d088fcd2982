#pragma once

#include "renderer/export/picture_file.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace limner {

/// What a picture for print shall be: size in millimetres, resolution, kind of file. Says before it starts how many
/// pixels that is and about how long it takes.
class ExportDialog : public QDialog {
    Q_OBJECT

  public:
    struct Choice {
        Output output;  ///< the figure's from now on
        QString ending; ///< "png"
        SampleDepth depth = SampleDepth::automatic;
        int samplesPerPixel = 1;
    };

    /// `secondsPerMegaPixel`: measured on the screen at one ray per pixel; 0: not known.
    ExportDialog(const Figure& figure, double secondsPerMegaPixel, QWidget* parent = nullptr);

    [[nodiscard]] Choice choice() const;

  private:
    void sizeChanged(bool widthLeads);
    void showEstimate();

    double aspect_;
    double secondsPerMegaPixel_;
    QDoubleSpinBox* width_;
    QDoubleSpinBox* height_;
    QCheckBox* keepAspect_;
    QSpinBox* dpi_;
    QComboBox* format_;
    QComboBox* depth_;
    QComboBox* smoothing_;
    QCheckBox* transparent_;
    QLabel* estimate_;
    QDialogButtonBox* buttons_;
};

/// "about 40 s", "about 3 min".
QString durationText(double seconds);
/// "12 MB".
QString bytesText(double bytes);

} // namespace limner
