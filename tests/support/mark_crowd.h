#pragma once

#include "renderer/marks/marks.h"

#include <random>
#include <vector>

namespace limner::testing {

/// Paper of as many mm as pixels.
inline Marks paper(int size) {
    Marks marks;
    marks.paperMm = {size, size};
    marks.groups.resize(1);
    return marks;
}

inline void addStroke(MarkGroup& group, const std::vector<StrokePoint>& points, float opacity = 1,
                      InkColour rgb = {0, 0, 0}) {
    group.strokes.push_back(
        {static_cast<std::uint32_t>(group.points.size()), static_cast<std::uint32_t>(points.size()), opacity, rgb});
    group.points.insert(group.points.end(), points.begin(), points.end());
}

/// Dots and strokes all over, in some colours.
inline Marks crowd(int dots, int strokes, int colours, int size = 200, unsigned seed = 3) {
    Marks marks = paper(size);
    marks.groups.resize(2);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> share(0, 1);
    const auto place = [&] { return glm::vec2(share(random), share(random)) * static_cast<float>(size + 20) - 10.0F; };
    const auto colour = [&] {
        const auto c = static_cast<std::uint8_t>(60 * (random() % static_cast<unsigned>(colours)));
        return InkColour(c, 255 - c, 20);
    };
    for (int i = 0; i < dots; ++i)
        marks.groups[static_cast<std::size_t>(i % 2)].dots.push_back(
            {place(), share(random), 3 * share(random), share(random) < 0.5F ? 1 : share(random), colour()});
    for (int i = 0; i < strokes; ++i) {
        std::vector<StrokePoint> points{{place(), 2 * share(random)}};
        const int count = 1 + i % 4;
        for (int k = 0; k < count; ++k)
            points.push_back({points.back().placeMm + 12.0F * glm::vec2(share(random) - 0.5F, share(random) - 0.5F),
                              count == 1 ? points.back().widthMm : 2 * share(random)});
        addStroke(marks.groups[static_cast<std::size_t>(i % 2)], points, share(random), colour());
    }
    return marks;
}

} // namespace limner::testing
