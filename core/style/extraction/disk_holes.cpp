#include "core/style/extraction/disk_holes.h"

#include "core/style/extraction/membrane.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

glm::dvec2 normalAt(int side, int x, int y) { return {(2.0 * x + 1) / side - 1, 1 - (2.0 * y + 1) / side}; }

bool onDisk(int side, int x, int y) {
    const glm::dvec2 n = normalAt(side, x, y);
    return glm::dot(n, n) <= 1;
}

glm::dvec3 direction(int side, int x, int y) {
    const glm::dvec2 n = normalAt(side, x, y);
    return {n, std::sqrt(std::max(0.0, 1 - glm::dot(n, n)))};
}

} // namespace

double diskCoverage(const ArtPicture& disk) {
    int all = 0;
    int covered = 0;
    for (int y = 0; y < disk.height; ++y) {
        for (int x = 0; x < disk.width; ++x) {
            const bool on = onDisk(disk.width, x, y);
            all += on ? 1 : 0;
            covered += on && disk.at(x, y).a > 0 ? 1 : 0;
        }
    }
    return all > 0 ? static_cast<double>(covered) / all : 0;
}

double largestHoleDegrees(const ArtPicture& disk) {
    const int side = disk.width;
    // Distances to covered texels of the disk, and which one is nearest, in the picture's plane.
    cv::Mat uncovered(side, side, CV_8U, cv::Scalar(255));
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (onDisk(side, x, y) && disk.at(x, y).a > 0) {
                uncovered.at<std::uint8_t>(y, x) = 0;
            }
        }
    }
    if (cv::countNonZero(uncovered) == side * side) {
        return 180;
    }
    cv::Mat distance;
    cv::Mat labels;
    cv::distanceTransform(uncovered, distance, labels, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
    std::vector<glm::dvec3> nearest(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) + 1);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (uncovered.at<std::uint8_t>(y, x) == 0) {
                nearest[static_cast<std::size_t>(labels.at<int>(y, x))] = direction(side, x, y);
            }
        }
    }
    double widest = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (onDisk(side, x, y) && uncovered.at<std::uint8_t>(y, x) != 0) {
                const glm::dvec3 here = direction(side, x, y);
                const double cosine = glm::dot(here, nearest[static_cast<std::size_t>(labels.at<int>(y, x))]);
                const double reach = std::acos(std::clamp(cosine, -1.0, 1.0));
                // Beyond the rim there are no directions that could be missing.
                widest = std::max(widest, reach + std::min(reach, std::asin(std::clamp(here.z, 0.0, 1.0))));
            }
        }
    }
    return widest * 180 / 3.14159265358979323846;
}

void fillHoles(ArtPicture& disk, Task& task) {
    const int side = disk.width;
    Membrane membrane{side,
                      side,
                      std::vector<Membrane::Cell>(disk.pixels.size(), Membrane::Cell::wall),
                      std::vector<float>(disk.pixels.size(), 0),
                      0,
                      1};
    bool holes = false;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const bool covered = disk.at(x, y).a > 0;
            // Some texels beyond the rim too: filters between texels read there.
            const glm::dvec2 n = normalAt(side, x, y);
            const bool near = glm::length(n) <= 1 + 6.0 / side;
            membrane.cells[disk.offset(x, y)] =
                covered ? Membrane::Cell::fixed : (near ? Membrane::Cell::free : Membrane::Cell::wall);
            holes = holes || (near && !covered);
        }
    }
    if (holes) {
        tbb::parallel_for(0, 3, [&](int c) {
            Membrane channel = membrane;
            constexpr float Rgba::*kChannels[] = {&Rgba::r, &Rgba::g, &Rgba::b};
            float Rgba::*const colour = kChannels[c];
            for (std::size_t i = 0; i < disk.pixels.size(); ++i) {
                channel.values[i] = disk.pixels[i].a > 0 ? disk.pixels[i].*colour : 0;
            }
            solveMembrane(channel, task);
            for (std::size_t i = 0; i < disk.pixels.size(); ++i) {
                disk.pixels[i].*colour = std::clamp(channel.values[i], 0.0F, 1.0F);
            }
        });
    }
    for (Rgba& texel : disk.pixels) {
        texel.a = 1;
    }
}

} // namespace limner
