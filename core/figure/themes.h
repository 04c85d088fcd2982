#pragma once

#include "core/figure/figure.h"

#include <string>
#include <vector>

namespace limner {

/// A theme exchanges the whole look of a figure at once (paper 000, figure 10): a style for every role, the pen of
/// the contours, and the paper.
struct ThemeCard {
    std::string id;   ///< "gray"
    std::string name; ///< "Gray's engraving"
    std::string help; ///< one sentence: what it looks like
};

/// The themes in `resourcesFolder()/themes`, in the order of their ranks. Throws Error(badInput) where there is none or
/// one is damaged. Thread-safe.
const std::vector<ThemeCard>& bundledThemes();

/// The figure in another look: every style that has a role takes the theme's bundled style of that role (of "any" where
/// the theme does not name the role), every layer that is shaded by such a style takes the theme's contours or loses
/// its own, and the background takes the theme's paper. Ids, roles and textures stay, so transfer functions, plain
/// colours and a background's picture do too. A locked layer keeps its look; layers that share a style with it get a
/// copy of that style, under an id of its own. What could not be exchanged is added to `notes`. Throws Error(usage) for
/// an unknown theme, naming the known ones.
Figure withTheme(const Figure& figure, const std::string& theme, std::vector<std::string>& notes);

} // namespace limner
