#include "core/figure/validate_transfer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace limner {
namespace {

constexpr const char* kAxes[] = {"value", "gradient", "label", "distance", "importance", "curvature", "second"};

/// The parts of one transfer function, each with its place in the document.
class TransferChecks {
  public:
    TransferChecks(std::string pointer, std::vector<Problem>& problems)
        : pointer_(std::move(pointer)), problems_(problems) {}

    void axis(const Figure& figure, const Transfer& transfer, const std::string& name, const std::string& place) {
        if (std::find(std::begin(kAxes), std::end(kAxes), name) == std::end(kAxes)) {
            fatal(place, "there is no axis \"" + name + "\"",
                  "value, gradient, label, distance, importance, curvature or second");
        }
        if (name == "label" && !figure.labels) {
            note(place, "the figure has no label volume", "give it one or take another axis");
        }
        if (name == "second" && !figure.secondVolume) {
            note(place, "the figure has no second scan", "give it one or take another axis");
        }
        if (name == "importance" && !figure.importance) {
            fatal(place, "the figure weighs nothing by importance", "weigh some measures, or take another axis");
        }
        if (name == "distance" && !transfer.distance) {
            fatal("/distance", "nothing says what distances are measured from", "give a point or a label");
        } else if (name == "distance" && !transfer.distance->fromMm && !figure.labels) {
            note("/distance/label", "the figure has no label volume", "give it one, or a point instead");
        }
    }

    void shape(const OpacityShape& shape, const std::string& place) {
        for (const auto& [corners, side] : {std::pair(&shape.x, "/x"), std::pair(&shape.y, "/y")}) {
            checkCorners(shape.shape, *corners, place + side);
        }
        if (shape.shape == "polygon" && shape.x.size() != shape.y.size()) {
            fatal(place + "/y",
                  "there are " + std::to_string(shape.x.size()) + " numbers in x and " +
                      std::to_string(shape.y.size()) + " in y",
                  "a polygon has one of each for a point");
        }
        checkShare(shape.opacity, place + "/opacity", "opacity");
        checkShare(shape.soft, place + "/soft", "softness");
        if (shape.shape == "mask") {
            checkMask(shape, place);
        }
    }

    void fatal(const std::string& place, const std::string& why, const std::string& mend) {
        problems_.push_back({pointer_ + place, why, mend, true});
    }
    void note(const std::string& place, const std::string& why, const std::string& mend) {
        problems_.push_back({pointer_ + place, why, mend, false});
    }

  private:
    void checkCorners(const std::string& kind, const std::vector<double>& corners, const std::string& place) {
        const bool polygon = kind == "polygon";
        const std::size_t wanted = polygon ? 3 : kind == "trapezoid" ? 4 : 2;
        if (polygon ? corners.size() < wanted : corners.size() != wanted) {
            fatal(place, "there are " + std::to_string(corners.size()) + " numbers",
                  "a " + kind + " has " + (polygon ? "at least " : "") + std::to_string(wanted));
            return;
        }
        const auto isFinite = [](double corner) { return std::isfinite(corner); };
        const auto strange = std::find_if_not(corners.begin(), corners.end(), isFinite);
        const auto wrong = strange != corners.end() || polygon ? strange : outOfOrder(corners);
        if (wrong != corners.end()) {
            const std::string item = place + "/" + std::to_string(wrong - corners.begin());
            fatal(item, strange != corners.end() ? "the number is not finite" : "it is below the one before",
                  strange != corners.end() ? "write a finite number" : "sort them by rising value");
        }
    }

    static std::vector<double>::const_iterator outOfOrder(const std::vector<double>& corners) {
        return std::is_sorted_until(corners.begin(), corners.end());
    }

    void checkShare(double share, const std::string& place, const std::string& what) {
        if (!(share >= 0 && share <= 1)) {
            fatal(place, "the " + what + " is not in 0 to 1", "write a number from 0 to 1");
        }
    }

    void checkMask(const OpacityShape& mask, const std::string& place) {
        if (mask.columns < 1) {
            fatal(place + "/columns", "the mask has no columns", "write how many numbers a row has");
        } else if (mask.values.empty() || mask.values.size() % static_cast<std::size_t>(mask.columns) != 0) {
            fatal(place + "/values",
                  std::to_string(mask.values.size()) + " numbers do not fill rows of " + std::to_string(mask.columns),
                  "write whole rows, at least one");
        }
        const auto isShare = [](double value) { return value >= 0 && value <= 1; };
        const auto wrong = std::find_if_not(mask.values.begin(), mask.values.end(), isShare);
        if (wrong != mask.values.end()) {
            fatal(place + "/values/" + std::to_string(wrong - mask.values.begin()), "it is not in 0 to 1",
                  "write a number from 0 to 1");
        }
    }

    std::string pointer_;
    std::vector<Problem>& problems_;
};

} // namespace

void checkTransferAxes(const Figure& figure, const Transfer& transfer, const std::string& pointer,
                       std::vector<Problem>& problems) {
    TransferChecks checks(pointer, problems);
    if (transfer.kind == TransferKind::oneDimensional) {
        checks.axis(figure, transfer, transfer.axis, "/axis");
        return;
    }
    if (transfer.axes.size() != 2) {
        checks.fatal("/axes", "there are " + std::to_string(transfer.axes.size()) + " axes",
                     "name two, such as [\"value\", \"gradient\"]");
        return;
    }
    checks.axis(figure, transfer, transfer.axes[0], "/axes/0");
    if (transfer.axes[1] == transfer.axes[0]) {
        checks.fatal("/axes/1", "both axes are \"" + transfer.axes[0] + "\"", "take another one");
    } else {
        checks.axis(figure, transfer, transfer.axes[1], "/axes/1");
    }
}

void checkOpacityShapes(const Transfer& transfer, const std::string& pointer, std::vector<Problem>& problems) {
    TransferChecks checks(pointer, problems);
    for (std::size_t i = 0; i < transfer.opacity2d.size(); ++i) {
        const OpacityShape& shape = transfer.opacity2d[i];
        const std::string place = "/opacity_2d/" + std::to_string(i);
        constexpr const char* kShapes[] = {"rectangle", "trapezoid", "ellipse", "polygon", "mask"};
        if (std::find(std::begin(kShapes), std::end(kShapes), shape.shape) == std::end(kShapes)) {
            checks.fatal(place + "/shape", "there is no shape \"" + shape.shape + "\"",
                         "rectangle, trapezoid, ellipse, polygon or mask");
            continue;
        }
        checks.shape(shape, place);
    }
    if (transfer.opacity2d.empty() && transfer.opacity.empty()) {
        checks.note("/opacity_2d", "there is neither shape nor curve: everything is opaque", "add one");
    }
}

} // namespace limner
