#include "renderer/accuracy/error_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace limner::accuracy {

namespace {

constexpr double kWidth = 860;
constexpr double kHeight = 460;
constexpr double kLeft = 70;
constexpr double kRight = 20;
constexpr double kTop = 16;
constexpr double kBottom = 48;
constexpr const char* kColours[] = {"#1b6ca8", "#b5482f", "#3f7f3f", "#7a4a9c"};

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
    char text[512];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

/// A logarithmic axis in pixels of the chart.
struct Axis {
    double low = 0; ///< log10
    double high = 1;
    double from = 0;
    double to = 1;
    void widen(double value) {
        low = std::min(low, std::floor(std::log10(value)));
        high = std::max(high, std::ceil(std::log10(value)));
    }
    [[nodiscard]] double at(double value) const {
        const double place = std::log10(std::max(value, std::pow(10, low)));
        return from + (std::min(place, high) - low) / (high - low) * (to - from);
    }
};

class Chart {
  public:
    explicit Chart(const Study& study) : study_(study) {
        x_ = {9, -9, kLeft, kWidth - kRight};
        y_ = {9, -9, kHeight - kBottom, kTop};
        for (const StudyRow& row : study.rows) {
            x_.widen(row.pictureSeconds);
            if (errorOf(row) > 0) {
                y_.widen(errorOf(row));
            }
        }
        if (study.errorBar > 0) {
            y_.widen(study.errorBar);
        }
        x_.high = std::max(x_.high, x_.low + 1);
        y_.high = std::max(y_.high, y_.low + 1);
    }

    std::string draw() {
        out_ = format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" role=\"img\" "
                      "font-family=\"sans-serif\" font-size=\"12\">\n",
                      kWidth, kHeight);
        bar();
        grid();
        tolerances();
        hull();
        for (std::size_t i = 0; i < study_.series.size(); ++i) {
            series(study_.series[i], i);
        }
        for (const StudyRow& row : study_.rows) {
            out_ += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"#888\"><title>", xOf(row), yOf(row)) +
                    row.method + ": " + row.words +
                    format(" - %.3g s, %.3g</title></circle>\n", row.pictureSeconds, errorOf(row));
        }
        present();
        return out_ + "</svg>\n";
    }

  private:
    [[nodiscard]] double errorOf(const StudyRow& row) const { return row.measured.error.of(study_.metric); }
    [[nodiscard]] double xOf(const StudyRow& row) const { return x_.at(row.pictureSeconds); }
    [[nodiscard]] double yOf(const StudyRow& row) const { return y_.at(errorOf(row)); }

    /// What lies in the reference's own error cannot be told apart.
    void bar() {
        const double top = y_.at(study_.errorBar);
        out_ += format("<rect x=\"%g\" y=\"%.1f\" width=\"%g\" height=\"%.1f\" fill=\"#e8e8e8\"/>\n", kLeft, top,
                       kWidth - kLeft - kRight, kHeight - kBottom - top);
        text(kWidth - kRight - 6, std::min(top + 14, kHeight - kBottom - 4), "end", "#777",
             "error of the reference itself");
    }

    void grid() {
        for (double e = x_.low; e <= x_.high; ++e) {
            const double x = x_.at(std::pow(10, e));
            line(x, kTop, x, kHeight - kBottom, "#ddd", "");
            text(x, kHeight - kBottom + 16, "middle", "#333", format("%g s", std::pow(10, e)));
        }
        for (double e = y_.low; e <= y_.high; ++e) {
            const double y = y_.at(std::pow(10, e));
            line(kLeft, y, kWidth - kRight, y, "#ddd", "");
            text(kLeft - 6, y + 4, "end", "#333", format("%g", std::pow(10, e)));
        }
        text((kLeft + kWidth - kRight) / 2, kHeight - 10, "middle", "#333", "time of the whole picture");
        const char* error = study_.metric == ErrorMetric::ciede2000 ? "colour difference CIEDE2000, 95 % of the pixels"
                            : study_.metric == ErrorMetric::largest ? "largest error of a channel"
                                                                    : "root mean square error";
        out_ +=
            format("<text transform=\"translate(16 %g) rotate(-90)\" text-anchor=\"middle\" fill=\"#333\">%s</text>\n",
                   (kTop + kHeight - kBottom) / 2, error);
    }

    void tolerances() {
        for (const NamedTolerance& named : namedTolerances()) {
            if (named.tolerance.metric == study_.metric && std::log10(named.tolerance.value) < y_.high) {
                const double y = y_.at(named.tolerance.value);
                line(kLeft, y, kWidth - kRight, y, "#c9a227", "4 3");
                text(kLeft + 6, y - 4, "start", "#8a6d00", format("%s: %.3g", named.name, named.tolerance.value));
            }
        }
    }

    void hull() {
        std::string points;
        for (const std::size_t row : study_.pareto) {
            points += format("%.1f,%.1f ", xOf(study_.rows[row]), yOf(study_.rows[row]));
        }
        out_ += "<polyline points=\"" + points +
                "\" fill=\"none\" stroke=\"#111\" stroke-width=\"1\" stroke-dasharray=\"2 2\"/>\n";
    }

    void series(const StudySeries& line, std::size_t index) {
        const char* colour = kColours[index % std::size(kColours)];
        std::string points;
        for (const std::size_t row : line.rows) {
            points += format("%.1f,%.1f ", xOf(study_.rows[row]), yOf(study_.rows[row]));
        }
        out_ += "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"2\"/>\n";
        const double y = kTop + 18 * (static_cast<double>(index) + 1);
        key(kWidth - 250, y - 4, kWidth - 225, y - 4, colour);
        text(kWidth - 218, y, "start", "#333", line.method + (line.ordered ? format(" (order %.2f)", line.order) : ""));
    }

    void present() {
        const StudyRow& row = study_.rows[study_.present];
        out_ += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"6\" fill=\"none\" stroke=\"#d00\" stroke-width=\"2\"/>\n",
                       xOf(row), yOf(row));
        text(xOf(row) + 10, yOf(row) - 6, "start", "#d00", "as it is");
    }

    void line(double x1, double y1, double x2, double y2, const char* colour, const char* dashes) {
        out_ +=
            format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-dasharray=\"%s\"/>\n",
                   x1, y1, x2, y2, colour, dashes);
    }
    void key(double x1, double y1, double x2, double y2, const char* colour) {
        out_ += format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"2\"/>\n", x1,
                       y1, x2, y2, colour);
    }
    void text(double x, double y, const char* anchor, const char* colour, const std::string& words) {
        out_ += format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\" stroke=\"#fff\" stroke-width=\"3\" "
                       "paint-order=\"stroke\">",
                       x, y, anchor, colour) +
                words + "</text>\n";
    }

    const Study& study_;
    Axis x_;
    Axis y_;
    std::string out_;
};

} // namespace

std::string errorChart(const Study& study) { return Chart(study).draw(); }

} // namespace limner::accuracy
