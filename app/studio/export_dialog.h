#pragma once

#include "renderer/export/picture_file.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace limner {

/// What a picture shall be: a size by name or by numbers (mm, inches or pixels), resolution, kind of file. Says before
/// it starts how many pixels that is, how much memory it takes and about how long. What was chosen last, but for the
/// size, which is the figure's, is remembered.
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
    [[nodiscard]] QComboBox* sizes() const { return sizes_; }
    [[nodiscard]] QComboBox* units() const { return units_; }
    [[nodiscard]] QDoubleSpinBox* width() const { return width_; }
    [[nodiscard]] QDoubleSpinBox* height() const { return height_; }
    [[nodiscard]] QSpinBox* dpi() const { return dpi_; }
    [[nodiscard]] QString estimate() const;

  public Q_SLOTS:
    void accept() override;

  private:
    void fillChoices(const Figure& figure);
    void arrange();
    void connectFields();
    void recall(const Figure& figure);
    void useSize(int place);
    void showLengths();
    void lengthChanged(bool widthLeads);
    void dpiChanged();
    void showEstimate();
    /// Millimetres of one of the chosen unit.
    [[nodiscard]] double mmPerUnit() const;

    Output own_; ///< the figure's
    double aspect_;
    double widthMm_;
    double heightMm_;
    double secondsPerMegaPixel_;
    QComboBox* sizes_;
    QComboBox* units_;
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
    QPushButton* go_;
};

/// "about 40 s", "about 3 min".
QString durationText(double seconds);
/// "12 MB".
QString bytesText(double bytes);

} // namespace limner
