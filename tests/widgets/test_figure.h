#pragma once

#include "core/figure/figure.h"

#include <array>
#include <cstring>
#include <vector>

namespace limner::testing {

/// A small CT-like ball in HU: air, tissue, and a bone core; 32^3 voxels of 2 mm.
inline std::shared_ptr<const Volume> smallVolume() {
    constexpr int kSize = 32;
    std::vector<std::int16_t> stored;
    for (int z = 0; z < kSize; ++z)
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const glm::dvec3 d = glm::dvec3(x, y, z) - 15.5;
                const double r2 = d.x * d.x + d.y * d.y + d.z * d.z;
                stored.push_back(static_cast<std::int16_t>(r2 < 36 ? 1000 : r2 < 144 ? 40 : -1000));
            }
    Volume::Contents contents;
    contents.grid.dims = glm::ivec3(kSize);
    contents.grid.spacingMm = glm::dvec3(2);
    contents.type = VoxelType::int16;
    contents.range = {-1000, 1000};
    contents.modality = Modality::ct;
    contents.unit = "HU";
    return std::make_shared<const Volume>(contents, std::as_bytes(std::span(stored)));
}

inline std::shared_ptr<const LitSphere> plainSphere(float r, float g, float b) {
    return std::make_shared<const LitSphere>(8, std::vector<Rgba>(64, Rgba{r, g, b, 1}));
}

/// Two layers: bone with two nodes of one style, skin with a plain colour.
inline Figure smallFigure() {
    Figure figure;
    figure.volume = VolumeReference{};
    figure.volume->data = smallVolume();
    figure.camera.targetMm = figure.volume->data->grid().centreMm();
    figure.camera.heightMm = 80;
    figure.styles.push_back({"ivory", "bundled:ivory", "Ivory", "", "", plainSphere(0.9F, 0.85F, 0.7F)});
    Layer bone;
    bone.name = "Bone";
    bone.transfer.nodes = {{200, "ivory", std::nullopt}, {900, "ivory", std::nullopt}};
    bone.transfer.opacity = {{150, 0}, {250, 0.9}, {1000, 1}};
    Layer skin;
    skin.name = "Skin";
    skin.shading = Shading::flat;
    skin.transfer.nodes = {{0, "", glm::dvec3(0.8, 0.5, 0.4)}};
    skin.transfer.opacity = {{-200, 0}, {-100, 0.1}, {100, 0.1}, {150, 0}};
    figure.layers = {bone, skin};
    return figure;
}

} // namespace limner::testing
