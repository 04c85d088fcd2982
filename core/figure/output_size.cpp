#include "core/figure/output_size.h"

#include "core/base/error.h"
#include "core/base/units.h"

#include <cmath>
#include <string>

namespace limner {

namespace {

constexpr double kMostPixels = 1e6; // an edge: the longest of any picture format here
constexpr double kMostDpi = 1e5;    // beyond any press or plotter

void check(double value, double most, const char* name) {
    if (!(value > 0 && value <= most)) {
        throw Error(ErrorKind::usage,
                    {"cannot make a picture of that size", name,
                     std::isfinite(value) ? "it is not in the range that makes sense" : "it is not a finite number",
                     "give a number above 0 and at most " + std::to_string(std::lround(most))});
    }
}

} // namespace

Output resized(const Output& output, const SizeRequest& request) {
    if (request.pixels && (request.widthMm || request.heightMm)) {
        throw Error(ErrorKind::usage,
                    {"cannot make a picture of that size", "", "pixels and millimetres are both given",
                     "give pixels (and dpi), or millimetres (and dpi)"});
    }
    Output out = output;
    out.dpi = request.dpi.value_or(output.dpi);
    check(out.dpi, kMostDpi, "dpi");
    if (request.pixels) {
        check(request.pixels->x, kMostPixels, "width in pixels");
        check(request.pixels->y, kMostPixels, "height in pixels");
        out.widthMm = mmFromPixels(request.pixels->x, out.dpi);
        out.heightMm = mmFromPixels(request.pixels->y, out.dpi);
    } else if (request.widthMm || request.heightMm) {
        const double shape = output.heightMm / output.widthMm;
        out.widthMm = request.widthMm ? *request.widthMm : *request.heightMm / shape;
        out.heightMm = request.heightMm ? *request.heightMm : *request.widthMm * shape;
    }
    const double mostMm = mmFromPixels(kMostPixels, out.dpi);
    check(out.widthMm, mostMm, "width in mm");
    check(out.heightMm, mostMm, "height in mm");
    return out;
}

Camera fittedTo(const Output& output, const Camera& camera) {
    Camera fitted = camera;
    if (output.heightMm > output.widthMm) {
        fitted.heightMm *= output.heightMm / output.widthMm;
    }
    return fitted;
}

} // namespace limner
