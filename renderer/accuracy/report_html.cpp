#include "core/style/png_writing.h"
#include "renderer/accuracy/error_chart.h"
#include "renderer/export/svg_text.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace limner::accuracy {

namespace {

constexpr double kWorstShown = 10; // CIEDE2000 that is black on the error map

constexpr const char* kStyle = R"(<style>
body { font: 15px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #222; background: #fff }
h1 { font-size: 1.5rem; margin-bottom: .2rem } h2 { font-size: 1.15rem; margin-top: 2rem }
table { border-collapse: collapse; font-size: .88rem } td, th { padding: .15rem .7rem; border-bottom: 1px solid #ddd; text-align: right }
td:first-child, th:first-child, td:nth-child(2), th:nth-child(2) { text-align: left }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem } .pictures img { width: 100% } figure { margin: 0 }
.map { position: relative } .map img + img { position: absolute; inset: 0 } .quiet { color: #666 } strong.no { color: #b00 }
</style>
)";

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string base64(const std::string& bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            three = three << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            out += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
        }
    }
    return out;
}

/// A picture inside the page, over a colour where one is given.
std::string imageTag(const Picture& picture, const glm::dvec3* background, const std::string& words) {
    std::vector<Rgba> pixels(picture.rgba().size() / 4);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const float* p = picture.rgba().data() + 4 * i;
        const float clear = 1 - p[3];
        const auto under = [&](int c) { return background ? clear * static_cast<float>((*background)[c]) : 0.0F; };
        const float per = background || p[3] <= 0 ? 1 : 1 / p[3];
        const auto channel = [&](int c) { return std::clamp((p[c] + under(c)) * per, 0.0F, 1.0F); };
        pixels[i] = {channel(0), channel(1), channel(2), background ? 1 : p[3]};
    }
    return "<img alt=\"" + words + "\" src=\"data:image/png;base64," + base64(pngBytes(picture.size(), pixels)) + "\">";
}

std::string head(const Study& study) {
    return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Accuracy: " +
           escapedXml(study.title) + "</title>\n" + kStyle +
           "</head><body>\n<h1>Error against run time</h1>\n<p class=\"quiet\">" +
           escapedXml(study.title.empty() ? "untitled figure" : study.title) + " - " + std::to_string(study.size.x) +
           " x " + std::to_string(study.size.y) + " pixels, " + study.backend + " backend, probe of " +
           number(study.probePixels) + " pixels, study of " + number(study.seconds) + " s</p>\n";
}

std::string summary(const Study& study) {
    const PictureError& error = study.rows[study.present].measured.error;
    std::string text = "<p>As it is, the picture takes " + number(study.rows[study.present].pictureSeconds) +
                       " s. 95 % of its pixels are within CIEDE2000 " + number(error.p95Colour) +
                       " of the same figure without any error of sampling (mean " + number(error.meanColour) +
                       ", largest " + number(error.largestColour) + "); root mean square error " + number(error.rmse) +
                       ", largest " + number(error.largest) + " of the full range.</p>\n<p><strong>" +
                       escapedXml(study.limiting) + "</strong></p>\n";
    text +=
        "<p class=\"quiet\">The reference is the figure's own model - its voxels, interpolation, gradients and rays "
        "per pixel - with steps down to " +
        number(study.referenceStep) + " voxel, observed order " + number(study.referenceOrder) +
        (study.extrapolated ? ", extrapolated" : ", not extrapolated") + "; it is itself good to " +
        number(study.errorBar) + ", single precision and tables included.</p>\n";
    if (study.lines.any) {
        text += "<p>Contours and silhouettes lie " + number(study.lines.meanDistance) +
                " pixels from where they should (95 % within " + number(study.lines.p95Distance) + "); " +
                number(100 * study.lines.disagreement) +
                " % of their pixels are in one of the two pictures only.</p>\n";
    }
    if (!study.perceived.empty()) {
        const ColourSummary seen = summaryOf(study.perceived);
        text += "<p>Seen from 300 mm away, where fine patterns blend, 95 % of the pixels are within CIEDE2000 " +
                number(seen.p95) + " of the best picture (mean " + number(seen.mean) + ", largest " +
                number(seen.largest) + ").</p>\n";
    }
    for (const std::string& note : study.notes) {
        text += "<p class=\"quiet\">" + escapedXml(note) + "</p>\n";
    }
    return text;
}

std::string choicesTable(const Study& study) {
    std::string text = "<h2>The cheapest settings for a tolerance</h2>\n<table><tr><th>tolerance</th><th>settings</th>"
                       "<th>asked</th><th>delivered</th><th>picture</th></tr>\n";
    for (const auto& [name, choice] : study.choices) {
        const auto row =
            std::find_if(study.rows.begin(), study.rows.end(),
                         [&, &wanted = choice.quality](const StudyRow& r) { return r.measured.quality == wanted; });
        text += "<tr><td>" + escapedXml(name) + "</td><td>" + escapedXml(choice.words) + "</td><td>" +
                number(choice.asked.value) + "</td><td>" + number(choice.heldOutError) +
                (choice.reached ? "" : " <strong class=\"no\">not reached</strong>") + "</td><td>" +
                (row == study.rows.end() ? "" : number(row->pictureSeconds) + " s") + "</td></tr>\n";
    }
    return text + "</table>\n<p class=\"quiet\">Delivered: on the half of the probe that the search has not seen. " +
           escapedXml("Longest step allowed: " + number(study.limit.voxels) + " voxels (" + study.limit.reason + ").") +
           "</p>\n";
}

std::string budgetTable(const Study& study) {
    std::string text = "<h2>What each setting costs in error</h2>\n<table><tr><th>setting</th><th>as it is</th>"
                       "<th>error, all else at its best</th></tr>\n";
    for (const KnobBudget& knob : study.budget) {
        text += std::string("<tr><td>") + nameOf(knob.knob) + "</td><td>" + escapedXml(knob.present) + "</td><td>" +
                number(knob.error) + "</td></tr>\n";
    }
    return text + "</table>\n";
}

std::string rowsTable(const Study& study) {
    std::string text =
        "<h2>Everything that was measured</h2>\n<table><tr><th></th><th>settings</th><th>picture, s</th>"
        "<th>RMSE</th><th>max</th><th>99.9 %</th><th>PSNR, dB</th><th>dE00 mean</th><th>95 %</th><th>max</th></tr>\n";
    for (const StudyRow& row : study.rows) {
        const PictureError& e = row.measured.error;
        text += "<tr><td>" + escapedXml(row.method) + "</td><td>" + escapedXml(row.words) + "</td>";
        for (const double value :
             {row.pictureSeconds, e.rmse, e.largest, e.most999, e.psnr(), e.meanColour, e.p95Colour, e.largestColour}) {
            text += "<td>" + number(value) + "</td>";
        }
        text += "</tr>\n";
    }
    return text + "</table>\n";
}

std::string pictures(const Study& study, const Figure& figure) {
    if (study.best.size() != study.picture.size()) {
        return "";
    }
    const glm::dvec3 paper(figure.background.rgba);
    const std::string under = imageTag(study.picture, &paper, "the figure");
    const auto mapped = [&](const std::vector<float>& errors, const std::string& caption) {
        return "<figure><div class=\"map\">" + under +
               imageTag(errorMap(errors, study.size, kWorstShown), nullptr, "error of every pixel") +
               "</div><figcaption>" + caption + "</figcaption></figure>";
    };
    return "<h2>Where the error is</h2>\n<div class=\"pictures\"><figure>" + under +
           "<figcaption>The figure as it is</figcaption></figure>" +
           mapped(colourDifferences(study.picture, study.best, paper),
                  "Its error over it: yellow to red to black at CIEDE2000 " + number(kWorstShown)) +
           mapped(study.perceived, "What a reader can see of it at 300 mm (S-CIELAB)") + "</div>\n";
}

} // namespace

std::string reportHtml(const Study& study, const Figure& figure) {
    return head(study) + summary(study) + errorChart(study) + choicesTable(study) + budgetTable(study) +
           pictures(study, figure) + rowsTable(study) + "</body></html>\n";
}

} // namespace limner::accuracy
