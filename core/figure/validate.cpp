#include "core/figure/figure_json.h"
#include "core/figure/quantity.h"
#include "core/figure/validate_annotations.h"
#include "core/figure/validate_transfer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace limner {
namespace {

/// Collects problems while walking over a figure.
class Validator {
  public:
    explicit Validator(const Figure& figure) : figure_(figure) {}

    std::vector<Problem> run() {
        checkCamera(figure_.camera, "/camera");
        checkClip(figure_.clip, "/clip");
        for (std::size_t i = 0; i < figure_.cleanup.size(); ++i) {
            checkCleanup(figure_.cleanup[i], item("/cleanup", i));
        }
        checkStyles();
        for (std::size_t i = 0; i < figure_.layers.size(); ++i) {
            checkLayer(figure_.layers[i], item("/layers", i));
        }
        if (figure_.layers.empty()) {
            note("/layers", "there is no layer: the picture shows the background alone",
                 "add a layer or take a preset");
        }
        for (const auto& [id, pointer] : faces_) {
            checkStyleId(id, pointer);
        }
        checkOutput();
        checkAnnotations(figure_, problems_);
        checkUse();
        return std::move(problems_);
    }

  private:
    static std::string item(const std::string& list, std::size_t index) { return list + "/" + std::to_string(index); }

    void fatal(const std::string& pointer, const std::string& why, const std::string& mend) {
        problems_.push_back({pointer, why, mend, true});
    }
    void note(const std::string& pointer, const std::string& why, const std::string& mend) {
        problems_.push_back({pointer, why, mend, false});
    }

    void checkCamera(const Camera& camera, const std::string& pointer) {
        const double direction = glm::length(camera.direction);
        const double up = glm::length(camera.up);
        if (!(direction > 0) || !std::isfinite(direction)) {
            fatal(pointer + "/direction", "the view direction has no length", "give it one, such as [0, 1, 0]");
        } else if (!(up > 0) || !std::isfinite(up)) {
            fatal(pointer + "/up", "the up direction has no length", "give it one, such as [0, 0, 1]");
        } else {
            // Below a ten-thousandth of a degree the picture's right is rounding noise.
            constexpr double kSmallestSine = 1e-6;
            const glm::dvec3 right = glm::cross(camera.direction / direction, camera.up / up);
            if (glm::length(right) < kSmallestSine) {
                fatal(pointer + "/up", "up is along the view direction", "turn it away from the view direction");
            }
        }
        if (!(camera.heightMm > 0)) {
            fatal(pointer + "/height_mm", "the picture has no height", "write a number > 0");
        }
        if (camera.projection == Projection::perspective && !(camera.fovDeg > 0 && camera.fovDeg < 180)) {
            fatal(pointer + "/fov_deg", "the field of view is not between 0 and 180 degrees", "30 is a good one");
        }
    }

    void checkClip(const Clip& clip, const std::string& pointer) {
        if (clip.boxMm) {
            const BoxMm& box = *clip.boxMm;
            if (!(box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z)) {
                fatal(pointer + "/box_mm", "the box is empty: a low corner is not below the high one",
                      "swap the corners");
            }
        }
        for (std::size_t i = 0; i < clip.planes.size(); ++i) {
            if (!(glm::length(clip.planes[i].normal) > 0)) {
                fatal(item(pointer + "/planes", i) + "/normal", "the plane's normal has no length",
                      "such as [1, 0, 0]");
            }
        }
        if (clip.face && !clip.face->style.empty()) {
            faces_.emplace_back(clip.face->style, pointer + "/face/style");
        }
    }

    void checkCleanup(const CleanupStep& step, const std::string& pointer) {
        if (step.kind == CleanupKind::scissors) {
            if (step.polygon.size() < 3) {
                fatal(pointer + "/polygon", "the outline has " + std::to_string(step.polygon.size()) + " points",
                      "it needs at least 3");
            }
            if (step.camera) {
                checkCamera(*step.camera, pointer + "/camera");
            } else {
                fatal(pointer + "/camera", "the outline has no view, so nothing says where it cuts",
                      "store the view it was drawn in");
            }
        }
        if (step.kind == CleanupKind::keepAt && !step.atMm) {
            fatal(pointer + "/at_mm", "keep-at does not say where", "give a point of the island in mm");
        }
        if (step.kind == CleanupKind::eraseLabel && !figure_.labels) {
            fatal(pointer + "/kind", "there are no labels to erase", "give the figure a label volume");
        }
    }

    void checkStyles() {
        for (std::size_t i = 0; i < figure_.styles.size(); ++i) {
            const StyleEntry& style = figure_.styles[i];
            const std::string pointer = item("/styles", i);
            if (style.id.empty()) {
                fatal(pointer + "/id", "the style has no id", "give it one");
            } else if (!styleIds_.insert(style.id).second) {
                fatal(pointer + "/id", "two styles are called \"" + style.id + "\"", "rename one");
            }
            if (style.file.empty() && style.sphere == nullptr) {
                fatal(pointer + "/file", "the style has no picture", "name a picture, or bundled:ID");
            }
            if (style.texture && style.texture->file.empty() && style.texture->tile == nullptr) {
                fatal(pointer + "/texture/file", "the texture has no picture", "name a picture, or bundled:ID");
            }
        }
    }

    void checkStyleId(const std::string& id, const std::string& pointer) {
        used_.insert(id);
        if (styleIds_.count(id) == 0) {
            fatal(pointer, "there is no style \"" + id + "\"", "add it to /styles or take another one");
        }
    }

    void checkLayer(const Layer& layer, const std::string& pointer) {
        const Transfer& transfer = layer.transfer;
        checkTransferAxes(figure_, transfer, pointer + "/transfer", problems_);
        if (transfer.kind == TransferKind::oneDimensional) {
            checkNodes(transfer, pointer + "/transfer/nodes");
            checkCurve(transfer.opacity, pointer + "/transfer/opacity");
        } else {
            checkGrid(transfer, pointer + "/transfer");
            checkOpacityShapes(transfer, pointer + "/transfer", problems_);
            if (!transfer.opacity.empty()) {
                checkCurve(transfer.opacity, pointer + "/transfer/opacity");
            }
        }
        if (transfer.grid && !transfer.nodes.empty()) {
            note(pointer + "/transfer/nodes", "there are nodes and a grid of nodes; only one is kept in a file",
                 "remove one");
        }
        if (!(layer.opacity >= 0 && layer.opacity <= 1)) {
            fatal(pointer + "/opacity", "the opacity is not in 0 to 1", "write a number from 0 to 1");
        }
        if (layer.gradientOpacity) {
            checkCurve(*layer.gradientOpacity, pointer + "/gradient_opacity");
        }
        if (layer.lineGradientOpacity) {
            checkCurve(*layer.lineGradientOpacity, pointer + "/line_gradient_opacity");
        }
        if (layer.tone) {
            checkRising(layer.tone->keys, pointer + "/tone/keys");
        }
        if (layer.position) {
            checkRising(layer.position->ramp, pointer + "/position/ramp");
            if (layer.position->axis == "direction" && !(glm::length(layer.position->direction) > 0)) {
                fatal(pointer + "/position/direction", "the direction has no length", "such as [0, 0, 1]");
            }
        }
        if (layer.clip) {
            checkClip(*layer.clip, pointer + "/clip");
        }
        if (layer.labels && !figure_.labels) {
            note(pointer + "/labels", "the figure has no label volume", "give it one or remove this");
        }
    }

    template <class Key>
    void checkRising(const std::vector<Key>& keys, const std::string& pointer) {
        for (std::size_t i = 1; i < keys.size(); ++i) {
            if (keys[i].at < keys[i - 1].at) {
                fatal(item(pointer, i) + "/at", "it is below the one before", "sort them by rising value");
                return;
            }
        }
    }

    void checkNodes(const Transfer& transfer, const std::string& pointer) {
        if (transfer.nodes.empty()) {
            fatal(pointer, "the transfer function has no node", "add one with a style or a colour");
        }
        checkRising(transfer.nodes, pointer);
        for (std::size_t i = 0; i < transfer.nodes.size(); ++i) {
            const TransferNode& node = transfer.nodes[i];
            if (!node.style.empty()) {
                checkStyleId(node.style, item(pointer, i) + "/style");
            }
            if (node.style.empty() && !node.rgb) {
                fatal(item(pointer, i), "the node has neither style nor colour", "write \"style\" or \"rgb\"");
            } else if (!node.style.empty() && node.rgb) {
                note(item(pointer, i), "the node has a style and a colour; the style is drawn", "remove one");
            }
        }
    }

    void checkCurve(const std::vector<glm::dvec2>& points, const std::string& pointer) {
        if (points.empty()) {
            note(pointer, "the curve has no point: nothing shows", "add points");
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!(points[i].y >= 0 && points[i].y <= 1)) {
                fatal(item(pointer, i) + "/1", "the opacity is not in 0 to 1", "write a number from 0 to 1");
            }
            if (i > 0 && points[i].x < points[i - 1].x) {
                fatal(item(pointer, i) + "/0", "it is below the point before", "sort the points by rising value");
            }
        }
    }

    void checkGrid(const Transfer& transfer, const std::string& pointer) {
        if (!transfer.grid || transfer.grid->x.empty() || transfer.grid->y.empty()) {
            fatal(pointer + "/nodes", "there is no grid of nodes", "give x, y and styles");
            return;
        }
        const TransferGrid& grid = *transfer.grid;
        for (const auto& [values, name] : {std::pair(&grid.x, "/nodes/x"), std::pair(&grid.y, "/nodes/y")}) {
            for (std::size_t i = 1; i < values->size(); ++i) {
                if (!((*values)[i] > (*values)[i - 1])) {
                    fatal(item(pointer + name, i), "it is not above the one before", "sort them by rising value");
                    break;
                }
            }
        }
        bool fits = grid.styles.size() == grid.y.size();
        for (std::size_t y = 0; y < grid.styles.size(); ++y) {
            fits = fits && grid.styles[y].size() == grid.x.size();
            for (std::size_t x = 0; x < grid.styles[y].size(); ++x) {
                checkCell(grid.styles[y][x], item(item(pointer + "/nodes/styles", y), x));
            }
        }
        if (!fits) {
            fatal(pointer + "/nodes/styles", "the rows do not fit the grid's x and y",
                  "a row per y with a style per x");
        }
    }

    void checkCell(const std::string& cell, const std::string& pointer) {
        if (!cell.starts_with('#')) {
            checkStyleId(cell, pointer);
        } else if (!plainColour(cell)) {
            fatal(pointer, "\"" + cell + "\" is no colour", "write #rrggbb or the id of a style");
        }
    }

    void checkOutput() {
        const Output& output = figure_.output;
        if (!(output.widthMm > 0) || !(output.heightMm > 0) || !(output.dpi > 0)) {
            fatal("/output", "the output is empty", "give it a width, a height and dpi > 0");
            return;
        }
        // 2^20 pixels are the longest side that picture files take; sizePixels would leave the integers beyond 2^31.
        constexpr double kLongestPixels = 1048576;
        constexpr double kMmPerInchHere = 25.4;
        if (std::max(output.widthMm, output.heightMm) * output.dpi / kMmPerInchHere > kLongestPixels) {
            fatal("/output", "the output is longer than 1048576 pixels", "lower the dpi or the size");
        }
    }

    void checkUse() {
        for (std::size_t i = 0; i < figure_.styles.size(); ++i) {
            const std::string& id = figure_.styles[i].id;
            if (!id.empty() && used_.count(id) == 0) {
                note(item("/styles", i), "no layer uses the style \"" + id + "\"", "");
            }
        }
        checkObjects();
        const int samples = figure_.quality.samplesPerPixel;
        if (samples != 1 && samples != 4 && samples != 16) {
            fatal("/quality/samples_per_pixel", std::to_string(samples) + " rays do not fill a square",
                  "write 1, 4 or 16");
        }
        if (figure_.cleanup.empty() && figure_.layers.empty() && !figure_.volume) {
            note("/volume", "the figure names no scan", "open one");
        }
    }

    void checkObjects() {
        if (!figure_.importance || !(figure_.importance->weights.object > 0)) {
            return;
        }
        if (figure_.importance->objects.empty()) {
            note("/importance/objects", "objects are weighed and none has a weight", "write label and weight");
        } else if (!figure_.labels) {
            fatal("/importance/objects", "objects are weighed and the figure has no labels", "give it a label volume");
        }
    }

    const Figure& figure_;
    std::vector<Problem> problems_;
    std::set<std::string> styleIds_;
    std::set<std::string> used_;
    std::vector<std::pair<std::string, std::string>> faces_; ///< of cuts: style and pointer
};

} // namespace

std::vector<Problem> validateFigure(const Figure& figure) { return Validator(figure).run(); }

} // namespace limner
