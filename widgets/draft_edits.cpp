#include "widgets/draft_edits.h"

#include <QPainter>
#include <QPolygonF>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limner {
namespace {

constexpr double kLeastAxis = 1; // artwork pixels: a smaller ball could not be grabbed again

/// From `a` to `b`: the nearest place of that line to `p`.
glm::dvec2 nearestOnLine(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    return length2 > 0 ? a + along * std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : a;
}

std::uint8_t byteOf(double share) { return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255)); }

} // namespace

glm::dvec2 firstAxis(const Ellipse& ellipse) {
    const double turn = glm::radians(ellipse.degrees);
    return {std::cos(turn), std::sin(turn)};
}

glm::dvec2 secondAxis(const Ellipse& ellipse) {
    const glm::dvec2 first = firstAxis(ellipse);
    return {-first.y, first.x};
}

glm::dvec2 handlePlace(const Ellipse& ellipse, EllipseHandle handle, double knob) {
    switch (handle) {
    case EllipseHandle::centre: break;
    case EllipseHandle::first: return ellipse.centre + firstAxis(ellipse) * ellipse.semiAxes.x;
    case EllipseHandle::firstOpposite: return ellipse.centre - firstAxis(ellipse) * ellipse.semiAxes.x;
    case EllipseHandle::second: return ellipse.centre + secondAxis(ellipse) * ellipse.semiAxes.y;
    case EllipseHandle::secondOpposite: return ellipse.centre - secondAxis(ellipse) * ellipse.semiAxes.y;
    case EllipseHandle::turn: return ellipse.centre + firstAxis(ellipse) * (ellipse.semiAxes.x + knob);
    }
    return ellipse.centre;
}

Ellipse withHandleAt(const Ellipse& ellipse, EllipseHandle handle, glm::dvec2 place, bool round) {
    Ellipse changed = ellipse;
    const glm::dvec2 out = place - ellipse.centre;
    const auto grow = [&](double& axis, double& other, double to) {
        const double grown = std::max(kLeastAxis, std::abs(to));
        if (round)
            other = std::max(kLeastAxis, other * grown / axis);
        axis = grown;
    };
    switch (handle) {
    case EllipseHandle::centre: changed.centre = place; break;
    case EllipseHandle::first:
    case EllipseHandle::firstOpposite:
        grow(changed.semiAxes.x, changed.semiAxes.y, glm::dot(out, firstAxis(ellipse)));
        break;
    case EllipseHandle::second:
    case EllipseHandle::secondOpposite:
        grow(changed.semiAxes.y, changed.semiAxes.x, glm::dot(out, secondAxis(ellipse)));
        break;
    case EllipseHandle::turn:
        if (out != glm::dvec2(0, 0))
            changed.degrees = glm::degrees(std::atan2(out.y, out.x));
        break;
    }
    return changed;
}

bool contains(const Ellipse& ellipse, glm::dvec2 place) {
    const glm::dvec2 out = place - ellipse.centre;
    const glm::dvec2 inDisk(glm::dot(out, firstAxis(ellipse)) / ellipse.semiAxes.x,
                            glm::dot(out, secondAxis(ellipse)) / ellipse.semiAxes.y);
    return glm::dot(inDisk, inDisk) <= 1;
}

Ellipse drawnEllipse(glm::dvec2 from, glm::dvec2 to, const EllipseDrag& how) {
    Ellipse ellipse;
    ellipse.centre = how.fromCentre ? from : (from + to) / 2.0;
    const glm::dvec2 reach = (to - from) * (how.fromCentre ? 1.0 : 0.5);
    ellipse.semiAxes = how.circle ? glm::dvec2(glm::length(reach)) : glm::abs(reach);
    ellipse.semiAxes = glm::max(ellipse.semiAxes, glm::dvec2(kLeastAxis));
    return ellipse;
}

Mask blankMask(const ArtworkPlate& plate) {
    Mask mask;
    mask.width = plate.reducedSize().width();
    mask.height = plate.reducedSize().height();
    mask.values.resize(mask.offset(0, mask.height));
    return mask;
}

bool marksAnything(const Mask& mask) {
    return std::any_of(mask.values.begin(), mask.values.end(), [](std::uint8_t value) { return value >= 128; });
}

MaskPtr withStroke(const Mask& mask, const BrushStroke& stroke) {
    auto changed = std::make_shared<Mask>(mask);
    const double reach = stroke.radius + 1;
    const glm::dvec2 low = glm::min(stroke.from, stroke.to) - reach;
    const glm::dvec2 high = glm::max(stroke.from, stroke.to) + reach;
    const int x0 = static_cast<int>(std::clamp(std::floor(low.x), 0.0, static_cast<double>(mask.width)));
    const int y0 = static_cast<int>(std::clamp(std::floor(low.y), 0.0, static_cast<double>(mask.height)));
    const int x1 = static_cast<int>(std::clamp(std::ceil(high.x), 0.0, static_cast<double>(mask.width)));
    const int y1 = static_cast<int>(std::clamp(std::ceil(high.y), 0.0, static_cast<double>(mask.height)));
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const glm::dvec2 pixel(x + 0.5, y + 0.5);
            const double away = glm::distance(pixel, nearestOnLine(stroke.from, stroke.to, pixel));
            const std::uint8_t painted = byteOf(stroke.radius + 0.5 - away);
            std::uint8_t& value = changed->values[changed->offset(x, y)];
            value =
                stroke.erases ? std::min(value, static_cast<std::uint8_t>(255 - painted)) : std::max(value, painted);
        }
    return changed;
}

MaskPtr withEnclosed(const Mask& mask, const ArtPath& path, bool takeAway) {
    QImage image(mask.width, mask.height, QImage::Format_Grayscale8);
    for (int y = 0; y < mask.height; ++y)
        std::copy_n(mask.values.data() + mask.offset(0, y), mask.width, image.scanLine(y));
    QPolygonF outline;
    for (const glm::dvec2& place : path)
        outline << QPointF(place.x, place.y);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(takeAway ? Qt::black : Qt::white);
    painter.drawPolygon(outline, Qt::WindingFill);
    painter.end();
    auto changed = std::make_shared<Mask>(mask);
    for (int y = 0; y < mask.height; ++y)
        std::copy_n(image.constScanLine(y), mask.width, changed->values.data() + mask.offset(0, y));
    return changed;
}

MaskPtr withCutMarked(const ArtworkPlate& plate, const Mask& mask, const ArtCut& cut, const Mask& overCut) {
    auto changed = std::make_shared<Mask>(mask);
    if (overCut.empty())
        return changed;
    const glm::dvec2 low = cut.toArtwork({0, 0}) / plate.reduction();
    const glm::dvec2 high = cut.toArtwork({overCut.width, overCut.height}) / plate.reduction();
    const int x1 = std::min(mask.width, static_cast<int>(std::ceil(high.x)));
    const int y1 = std::min(mask.height, static_cast<int>(std::ceil(high.y)));
    for (int y = std::max(0, static_cast<int>(low.y)); y < y1; ++y)
        for (int x = std::max(0, static_cast<int>(low.x)); x < x1; ++x) {
            const glm::dvec2 in = cut.toCut(glm::dvec2(x + 0.5, y + 0.5) * plate.reduction());
            const int column = static_cast<int>(std::floor(in.x));
            const int row = static_cast<int>(std::floor(in.y));
            if (column < 0 || row < 0 || column >= overCut.width || row >= overCut.height)
                continue;
            std::uint8_t& value = changed->values[changed->offset(x, y)];
            value = std::max(value, overCut.values[overCut.offset(column, row)]);
        }
    return changed;
}

PathMiddle middleOf(const ArtPath& path) {
    double whole = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        whole += glm::distance(path[i - 1], path[i]);
    double left = whole / 2;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double length = glm::distance(path[i - 1], path[i]);
        if (length > 0 && length >= left) {
            const glm::dvec2 direction = (path[i] - path[i - 1]) / length;
            return {path[i - 1] + direction * left, direction};
        }
        left -= length;
    }
    return {path.empty() ? glm::dvec2(0, 0) : path.front(), {1, 0}};
}

double distanceTo(const ArtPath& path, glm::dvec2 place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < path.size(); ++i)
        nearest = std::min(nearest, glm::distance(place, nearestOnLine(path[i > 0 ? i - 1 : 0], path[i], place)));
    return nearest;
}

std::optional<Rgba> colourAt(const ArtworkPlate& plate, glm::dvec2 place, double radius) {
    const ArtCut& cut = plate.artwork->reduced();
    const glm::dvec2 centre = cut.toCut(place);
    const ArtPixels& pixels = cut.picture;
    if (centre.x < 0 || centre.y < 0 || centre.x >= pixels.width || centre.y >= pixels.height)
        return std::nullopt;
    const double reach = std::max(0.0, radius / cut.scale);
    double weight = 0;
    double r = 0;
    double g = 0;
    double b = 0;
    const auto add = [&](int x, int y) {
        const Rgba& c = pixels.at(x, y);
        weight += c.a;
        r += static_cast<double>(c.r) * c.a;
        g += static_cast<double>(c.g) * c.a;
        b += static_cast<double>(c.b) * c.a;
    };
    for (int y = std::max(0, static_cast<int>(centre.y - reach)); y < pixels.height && y <= centre.y + reach; ++y)
        for (int x = std::max(0, static_cast<int>(centre.x - reach)); x < pixels.width && x <= centre.x + reach; ++x)
            if (glm::distance(glm::dvec2(x + 0.5, y + 0.5), centre) <= std::max(reach, 0.75)) // at least its own pixel
                add(x, y);
    constexpr double kClear = 0.05; // less than that shows the ground, not paint
    if (weight < kClear)
        return std::nullopt;
    return Rgba{static_cast<float>(r / weight), static_cast<float>(g / weight), static_cast<float>(b / weight), 1};
}

} // namespace limner
