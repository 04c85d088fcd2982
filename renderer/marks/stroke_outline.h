#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <span>

namespace limner {

/// A point of a stroke's middle line and half its width there.
struct OutlinePoint {
    glm::vec2 place{0};
    float radius = 0;
};

/// Walks one side of a stroke from its first point to its last and around the end. On the inner side of a bend it turns
/// where the sides meet; where a piece is too short for that it goes through the middle line, so that pieces which
/// overlap add up and never cancel, and the non-zero rule fills the union.
/// `at(i)` is point i; neighbours differ in place.
template <typename At, typename Sink>
void traceSide(std::size_t count, At at, Sink& sink) {
    // Where the outer side bends by less, the chord is taken for the arc: 1/4000 of the radius off.
    constexpr float kStraight = 0.05F;
    glm::vec2 step = at(1).place - at(0).place;
    float length = glm::length(step);
    for (std::size_t i = 1;; ++i) {
        const OutlinePoint p = at(i);
        const glm::vec2 along = step / length;
        const glm::vec2 normal(-along.y, along.x);
        if (i + 1 == count) {
            sink.lineTo(p.place + normal * p.radius);
            sink.arcTo(p.place, p.radius, normal, -normal);
            return;
        }
        step = at(i + 1).place - p.place;
        const float nextLength = glm::length(step);
        const glm::vec2 next = step / nextLength;
        const glm::vec2 nextNormal(-next.y, next.x);
        const float bend = along.x * next.y - along.y * next.x;
        const float same = glm::dot(along, next);
        if (bend > 0 && p.radius * bend <= (1 + same) * std::min(length, nextLength)) {
            sink.lineTo(p.place + (normal + nextNormal) * (p.radius / (1 + same)));
        } else {
            sink.lineTo(p.place + normal * p.radius);
            if (bend <= 0 && (bend < -kStraight || same < 0))
                sink.arcTo(p.place, p.radius, normal, nextNormal);
            else {
                if (bend > 0)
                    sink.lineTo(p.place);
                sink.lineTo(p.place + nextNormal * p.radius);
            }
        }
        length = nextLength;
    }
}

/// The outline of a stroke with round ends and joins, its width linear between points: sink.moveTo(place),
/// sink.lineTo(place), sink.arcTo(centre, radius, from, to) with unit vectors from the centre, always turning from +y
/// to +x by at most half a turn. Closed at its start. A single point gives a circle.
template <typename Sink>
void traceStroke(std::span<const OutlinePoint> points, Sink& sink) {
    const std::size_t count = points.size();
    const OutlinePoint& first = points.front();
    if (count == 1) {
        const glm::vec2 up(0, 1);
        sink.moveTo(first.place + up * first.radius);
        sink.arcTo(first.place, first.radius, up, -up);
        sink.arcTo(first.place, first.radius, -up, up);
        return;
    }
    const glm::vec2 along = glm::normalize(points[1].place - first.place);
    sink.moveTo(first.place + glm::vec2(-along.y, along.x) * first.radius);
    traceSide(
        count, [&](std::size_t i) { return points[i]; }, sink);
    traceSide(
        count, [&](std::size_t i) { return points[count - 1 - i]; }, sink);
}

/// The angle of an arc that turns from +y to +x, positive.
inline float arcAngle(const glm::vec2& from, const glm::vec2& to) {
    constexpr float kPi = 3.14159265F;
    const float angle = std::atan2(from.y * to.x - from.x * to.y, glm::dot(from, to));
    return angle > 0 ? angle : kPi; // opposite vectors, whichever way rounding sees them
}

} // namespace limner
