#pragma once

#include "core/figure/figure.h"
#include "core/volume/import.h"

#include <string>
#include <vector>

namespace limner {

struct PresetCard {
    std::string id;       ///< "skull"
    std::string name;     ///< "Skull"
    std::string help;     ///< one sentence: what it shows and of which data
    std::string modality; ///< "CT", "MR", "any", or "labels": for figures with labels
};

/// The bundled presets, "auto" first.
const std::vector<PresetCard>& bundledPresets();

/// A figure of the volume by a preset: layers, styles (resolved), camera that fits the matter, clean-up, output.
/// `auto` reads modality and histogram and gives a sensible figure of any volume, with labels the preset "labelled";
/// what it decided is added to `notes`. Throws Error(usage) for an unknown preset, naming the known ones, and for
/// "labelled" without labels.
Figure figureFromPreset(const std::string& preset, std::shared_ptr<const Volume> volume,
                        std::vector<std::string>& notes, const std::optional<LabelReference>& labels = std::nullopt);

/// The preset's look (styles, layers, shading) laid over a figure whose camera, clips and output stay.
Figure withPreset(const Figure& figure, const std::string& preset, std::vector<std::string>& notes);

enum class StandardView { anterior, posterior, left, right, superior, inferior, threeQuarter };

/// A camera that looks at the volume's box, or its matter (what lies above `matterAbove`), from a standard side.
Camera standardView(const Volume& volume, StandardView view, std::optional<double> matterAbove = std::nullopt);

} // namespace limner
