#include "support/rendering.h"

#include "support/gl_backend.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace limner::testing {

std::shared_ptr<const RenderPlan> planOf(const Figure& figure, const PlanRequest& request) {
    Task task;
    return Planner().plan(figure, request, task);
}

std::shared_ptr<const RenderPlan> planOf(const accuracy::AnalyticScene& scene) {
    return planOf(scene.figure, scene.request);
}

Picture renderWhole(const Backend& backend, const RenderPlan& plan) {
    Task task;
    return backend.render(plan, {{0, 0}, plan.size}, task).picture;
}

Picture renderWhole(const Backend& backend, const accuracy::AnalyticScene& scene) {
    return renderWhole(backend, *planOf(scene));
}

Picture renderTiles(const Backend& backend, const RenderPlan& plan, glm::ivec2 tiles) {
    Picture whole(plan.size);
    Task task;
    for (int ty = 0; ty < tiles.y; ++ty) {
        for (int tx = 0; tx < tiles.x; ++tx) {
            const glm::ivec2 from = plan.size * glm::ivec2(tx, ty) / tiles;
            const glm::ivec2 to = plan.size * glm::ivec2(tx + 1, ty + 1) / tiles;
            const Picture tile = backend.render(plan, {from, to - from}, task).picture;
            for (int y = 0; y < tile.size().y; ++y) {
                std::memcpy(whole.pixel(from.x, from.y + y), tile.pixel(0, y),
                            static_cast<std::size_t>(tile.size().x) * 4 * sizeof(float));
            }
        }
    }
    return whole;
}

double rootMeanSquare(const Picture& a, const Picture& b) {
    EXPECT_EQ(a.size(), b.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba().size(); ++i) {
        const double difference = static_cast<double>(a.rgba()[i]) - b.rgba()[i];
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(a.rgba().size()));
}

double largestDifference(const Picture& a, const Picture& b) {
    EXPECT_EQ(a.size(), b.size());
    double largest = 0;
    for (std::size_t i = 0; i < a.rgba().size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<double>(a.rgba()[i]) - b.rgba()[i]));
    }
    return largest;
}

bool sameBits(const Picture& a, const Picture& b) {
    return a.size() == b.size() && std::memcmp(a.rgba().data(), b.rgba().data(), a.rgba().size_bytes()) == 0;
}

int unsoundPixels(const Picture& picture) {
    int count = 0;
    for (std::size_t i = 0; i < picture.rgba().size(); i += 4) {
        const auto pixel = picture.rgba().subspan(i, 4);
        const bool finite = std::all_of(pixel.begin(), pixel.end(), [](float v) { return std::isfinite(v); });
        count += finite && pixel[3] >= 0 && pixel[3] <= 1 ? 0 : 1;
    }
    return count;
}

double observedOrder(double errorCoarse, double errorFine) { return std::log2(errorCoarse / errorFine); }

BackendTest::BackendTest() {
    if (GetParam() == "gl") {
        backend_ = std::shared_ptr<const Backend>(sharedGl(), [](const Backend*) {}); // the program's own
    } else {
        backend_ = GetParam() == "cpu" ? makeCpuBackend() : makeReferenceBackend();
    }
}

std::string backendName(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

} // namespace limner::testing
