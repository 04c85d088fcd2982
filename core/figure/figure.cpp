#include "core/figure/figure.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace limner {

glm::ivec2 Output::sizePixels() const {
    const auto pixels = [this](double lengthMm) {
        return std::max(1, static_cast<int>(std::lround(pixelsFromMm(lengthMm, dpi))));
    };
    return {pixels(widthMm), pixels(heightMm)};
}

const StyleEntry* Figure::findStyle(const std::string& id) const {
    const auto entry = std::find_if(styles.begin(), styles.end(), [&](const StyleEntry& s) { return s.id == id; });
    return entry == styles.end() ? nullptr : &*entry;
}

bool Figure::draws(const Layer& layer) const {
    const bool soloed = std::any_of(layers.begin(), layers.end(), [](const Layer& l) { return l.visible && l.solo; });
    return layer.visible && (layer.solo || !soloed);
}

} // namespace limner
