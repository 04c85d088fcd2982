#include "app/cli/style_extract_options.h"

#include "app/cli/facts.h"
#include "app/cli/style_words.h"
#include "core/base/error.h"
#include "core/figure/quantity.h"
#include "core/style/extraction/mask_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limner::cli {

namespace {

namespace fs = std::filesystem;

constexpr double kFull = 360;

glm::dvec2 outlinePoint(const Ellipse& ellipse, double turn) {
    const double angle = turn * 2 * std::numbers::pi;
    const double tilt = ellipse.degrees * 2 * std::numbers::pi / kFull;
    const glm::dvec2 straight{ellipse.semiAxes.x * std::cos(angle), ellipse.semiAxes.y * std::sin(angle)};
    return ellipse.centre + glm::dvec2(straight.x * std::cos(tilt) - straight.y * std::sin(tilt),
                                       straight.x * std::sin(tilt) + straight.y * std::cos(tilt));
}

/// Says so where an outline leaves the picture.
void noteOutside(const Artwork& artwork, const Ellipse& ellipse, Task& task) {
    constexpr int kPlaces = 360;
    int outside = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 at = outlinePoint(ellipse, i / double(kPlaces));
        const bool inside = at.x >= 0 && at.y >= 0 && at.x <= artwork.width() && at.y <= artwork.height();
        outside += inside ? 0 : 1;
    }
    if (outside > 0 && outside < kPlaces) { // an outline that is nowhere on it is an error to come
        task.warn(std::to_string(std::max(1, 100 * outside / kPlaces)) +
                  " % of the outline lies outside the picture; that side of the ball is filled in");
    }
}

/// The part of the artwork around an outline, fine enough to find its edge.
ArtCut cutAround(const Artwork& artwork, const Ellipse& ellipse, Task& task) {
    constexpr int kLongest = 1024; // a tenth of a percent of the ball
    constexpr double kAround = 1.5;
    const double reach = kAround * std::max(ellipse.semiAxes.x, ellipse.semiAxes.y);
    const auto whole = [](double value, int most) { return static_cast<int>(std::clamp(value, 0.0, double(most))); };
    ArtRect rect;
    rect.x = whole(ellipse.centre.x - reach, artwork.width());
    rect.y = whole(ellipse.centre.y - reach, artwork.height());
    rect.width = whole(std::ceil(ellipse.centre.x + reach), artwork.width()) - rect.x;
    rect.height = whole(std::ceil(ellipse.centre.y + reach), artwork.height()) - rect.y;
    return artwork.cut(rect, kLongest, task);
}

/// A mask that lies over the whole artwork; says so where its shape is another.
Mask maskOver(const Artwork& artwork, const std::string& file, Task& task) {
    constexpr double kSame = 0.02; // of the aspect: what rounding to whole pixels may do
    Mask mask = loadMask(file);
    const double aspect = double(artwork.width()) / artwork.height();
    const double own = double(mask.width) / mask.height;
    if (std::abs(own / aspect - 1) > kSame) {
        task.warn("the mask " + file + " has another shape than the artwork; it is stretched over all of it");
    }
    return mask;
}

Rgba colourOf(const std::string& text) {
    const glm::dvec4 colour = parseColour(text, "--swatches");
    return {static_cast<float>(colour.r), static_cast<float>(colour.g), static_cast<float>(colour.b), 1};
}

[[noreturn]] void refuseSwatches(const std::string& why) {
    throw Error(ErrorKind::usage, {"cannot mix the swatches", "--swatches", why,
                                   "write light=#rrggbb,shadow=#rrggbb, and mid, rim, highlight if you like"});
}

Swatches parsedSwatches(const std::string& text) {
    Swatches swatches;
    bool hasLight = false;
    bool hasShadow = false;
    for (const std::string& part : partsOf(text)) {
        const std::size_t equals = part.find('=');
        const std::string key = part.substr(0, equals);
        if (equals == std::string::npos) {
            refuseSwatches("\"" + part.substr(0, 40) + "\" has no colour");
        }
        const Rgba colour = colourOf(part.substr(equals + 1));
        if (key == "light") {
            swatches.light = colour;
            hasLight = true;
        } else if (key == "shadow") {
            swatches.shadow = colour;
            hasShadow = true;
        } else if (key == "mid" || key == "rim" || key == "highlight") {
            (key == "mid" ? swatches.mid : key == "rim" ? swatches.rim : swatches.highlight) = colour;
        } else {
            refuseSwatches("\"" + key.substr(0, 40) + "\" is no part of a ball");
        }
    }
    if (!hasLight || !hasShadow) {
        refuseSwatches(hasLight ? "shadow is missing" : "light is missing");
    }
    return swatches;
}

AlphaCurve parsedAlpha(const std::string& text) {
    AlphaCurve curve;
    for (std::string part : partsOf(text)) {
        std::replace(part.begin(), part.end(), ':', ',');
        const std::vector<double> point = numbersOf(part, "--alpha", "0,1");
        const bool sound =
            point[0] >= (curve.empty() ? 0 : curve.back().x) && point[0] <= 1 && point[1] >= 0 && point[1] <= 1;
        if (!sound) {
            throw Error(ErrorKind::usage, {"wrong value", "--alpha", "\"" + text.substr(0, 60) + "\"",
                                           "write radius:alpha, both from 0 to 1, by rising radius: 0:0.2,1:1"});
        }
        curve.emplace_back(point[0], point[1]);
    }
    return curve;
}

} // namespace

bool isCircle(const Ellipse& ellipse) {
    constexpr double kAlike = 0.002; // a twentieth of a pixel in a ball of fifty
    return std::abs(ellipse.semiAxes.x - ellipse.semiAxes.y) <= kAlike * ellipse.semiAxes.x;
}

std::string ellipseWords(const Ellipse& ellipse) {
    const std::string centre = numberText(ellipse.centre.x) + "," + numberText(ellipse.centre.y) + ",";
    return isCircle(ellipse) ? "circle " + centre + numberText(ellipse.semiAxes.x)
                             : "ellipse " + centre + numberText(ellipse.semiAxes.x) + "," +
                                   numberText(ellipse.semiAxes.y) + "," + numberText(ellipse.degrees);
}

std::vector<RoundThing> roundThings(const Artwork& artwork, Task& task) {
    return findRoundThings(artwork.reduced(), task);
}

void ExtractOptions::declareForm(CLI::App& app) {
    app.add_option("--circle", circle_, "A ball: centre and radius in the artwork's pixels, y down")
        ->option_text("X,Y,R");
    app.add_option("--ellipse", ellipse_, "A ball seen as an ellipse: centre, half axes, degrees clockwise")
        ->option_text("X,Y,A,B,DEG");
    app.add_flag("--detect", detect_, "Find round shaded things and take the best; without -o only list them");
    app.add_option("--pick", pick_, "Take the Nth of the things found [1]")
        ->option_text("N")
        ->check(CLI::Range(1, 1000).description(""));
    app.add_flag("--snap", snap_, "Move the outline to the picture's edge near it");
    app.add_option("--region", region_, "Any shaded form: a picture over the whole artwork, white inside it")
        ->option_text("MASK");
    app.add_option("--marks", marks_,
                   "What is known of that form's normals: a JSON file with normals, creases and open parts of the "
                   "outline")
        ->option_text("FILE");
    app.add_option("--swatches", swatches_,
                   "No artwork but a few colours: light=#rrggbb,shadow=#rrggbb and, if you like, mid, rim, highlight")
        ->option_text("COLOURS");
    app.add_option("--light", light_,
                   "Where the brightest place of the swatches' ball is, x to the right, y up "
                   "[-0.5,0.5]")
        ->option_text("X,Y");
}

void ExtractOptions::declareLook(CLI::App& app) {
    app.add_option("--ignore", ignore_, "A picture over the whole artwork, white where it is not to be looked at")
        ->option_text("MASK");
    app.add_flag("--keep-lettering", keepLettering_, "Look at printed letters and leader lines too");
    app.add_flag("--paper-cast", paperCast_, "Take the paper's colour out, as if painted on white");
    app.add_option("--size", size_, "Edge of the style's picture in pixels [512]")
        ->option_text("N")
        ->check(CLI::Range(16, 2048).description(""));
    app.add_option("--smoothing", smoothing_, "Smooth the ball, 0 to 1; edges stay [0]")
        ->option_text("AMOUNT")
        ->check(CLI::Range(0.0, 1.0).description(""));
    app.add_flag("--symmetric", symmetric_, "Make both sides of the light's direction alike");
    app.add_option("--turn", turn_, "Turn the light counter-clockwise [0]")
        ->option_text("DEG")
        ->check(CLI::Range(-3600.0, 3600.0).description(""));
    app.add_option("--alpha", alpha_, "Opacity by the distance from the ball's centre: 0:0.2,0.8:1 [opaque]")
        ->option_text("R:A,...");
}

bool ExtractOptions::hasForm() const {
    return !circle_.empty() || !ellipse_.empty() || detect_ || !region_.empty() || hasSwatches();
}

void ExtractOptions::checkForm() const {
    const int ways =
        int(!circle_.empty()) + int(!ellipse_.empty()) + int(detect_) + int(!region_.empty()) + int(hasSwatches());
    const auto refuse = [](const std::string& option, const std::string& why, const std::string& remedy) {
        throw Error(ErrorKind::usage, {"cannot take a style", option, why, remedy});
    };
    if (ways != 1) {
        refuse("", ways == 0 ? "nothing says where it is" : "several options say where it is",
               "give one of --circle, --ellipse, --detect, --region and --swatches");
    }
    if (!marks_.empty() && region_.empty()) {
        refuse("--marks", "marks belong to a region", "give --region too");
    }
    if (!light_.empty() && !hasSwatches()) {
        refuse("--light", "it belongs to swatches", "turn an artwork's light by --turn");
    }
    if (snap_ && (hasSwatches() || !region_.empty())) {
        refuse("--snap", "only circles and ellipses snap", "leave it out");
    }
    if (!circle_.empty() || !ellipse_.empty()) {
        static_cast<void>(given());
    }
    static_cast<void>(edits());
}

Ellipse ExtractOptions::given() const {
    Ellipse ellipse;
    if (!circle_.empty()) {
        const std::vector<double> n = numbersOf(circle_, "--circle", "310,240,85");
        ellipse = {{n[0], n[1]}, {n[2], n[2]}, 0};
    } else {
        const std::vector<double> n = numbersOf(ellipse_, "--ellipse", "310,240,85,60,30");
        ellipse = {{n[0], n[1]}, {n[2], n[3]}, n[4]};
    }
    if (ellipse.semiAxes.x <= 0 || ellipse.semiAxes.y <= 0) {
        throw Error(ErrorKind::usage,
                    {"cannot take a style", circle_.empty() ? "--ellipse" : "--circle",
                     "a radius must be greater than 0", "measure from the ball's centre to its edge"});
    }
    return ellipse;
}

Ellipse ExtractOptions::ellipse(const Artwork& artwork, Task& task) const {
    Ellipse ellipse;
    if (detect_) {
        const std::vector<RoundThing> found = roundThings(artwork, task);
        if (found.empty()) {
            throw Error(ErrorKind::badInput,
                        {"cannot take a style", artwork.file().string(), "there is no round shaded thing to be found",
                         "name one by --circle X,Y,R, or a form by --region MASK"});
        }
        if (static_cast<std::size_t>(pick_) > found.size()) {
            throw Error(ErrorKind::usage, {"cannot take a style", "--pick",
                                           "only " + std::to_string(found.size()) + " round things were found",
                                           "--detect alone lists them"});
        }
        ellipse = found[static_cast<std::size_t>(pick_) - 1].ellipse;
    } else {
        ellipse = given();
    }
    if (snap_) {
        const std::optional<Ellipse> snapped = snapEllipse(cutAround(artwork, ellipse, task), ellipse);
        if (!snapped) {
            task.warn("there is no edge near the outline to snap to; it stays where it was put");
        }
        ellipse = snapped.value_or(ellipse);
    }
    noteOutside(artwork, ellipse, task);
    return ellipse;
}

PlacedForm ExtractOptions::form(const Artwork& artwork, Task& task) const {
    if (region_.empty()) {
        const Ellipse round = ellipse(artwork, task);
        return {round, ellipseWords(round)};
    }
    FormRegion region{maskOver(artwork, region_, task), {}};
    if (!marks_.empty()) {
        region.marks = loadFormMarks(marks_);
    }
    return {std::move(region), "region " + fs::path(region_).filename().string()};
}

SphereEdits ExtractOptions::edits() const {
    if (!std::isfinite(smoothing_) || !std::isfinite(turn_)) {
        throw Error(ErrorKind::usage, {"wrong value", std::isfinite(turn_) ? "--smoothing" : "--turn",
                                       "it is no number", "write for example 0.3"});
    }
    return {smoothing_, symmetric_, turn_, parsedAlpha(alpha_)};
}

ExtractionRequest ExtractOptions::request(const Artwork& artwork, const PlacedForm& form, Task& task) const {
    ExtractionRequest request;
    request.form = form.form;
    if (!ignore_.empty()) {
        request.ignored = maskOver(artwork, ignore_, task);
    }
    request.skipLettering = !keepLettering_;
    request.removePaperCast = paperCast_;
    request.size = size_;
    request.edits = edits();
    return request;
}

SpherePtr ExtractOptions::mixed() const {
    Swatches swatches = parsedSwatches(swatches_);
    if (!light_.empty()) {
        const std::vector<double> n = numbersOf(light_, "--light", "-0.5,0.5");
        swatches.towardsLight = {n[0], n[1]};
        if (std::hypot(n[0], n[1]) > 1) {
            throw Error(ErrorKind::usage, {"wrong value", "--light", "the place lies outside the ball",
                                           "its distance from 0,0 is at most 1"});
        }
    }
    return edited(sphereOfSwatches(swatches, size_), edits());
}

} // namespace limner::cli
