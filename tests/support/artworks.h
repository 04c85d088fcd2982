#pragma once

#include "core/style/extraction/forms.h"
#include "core/style/extraction/picture.h"
#include "core/style/lit_sphere.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <vector>

namespace limner::testing {

/// A form drawn in a known style on a plain ground, antialiased, and the truth about it.
struct SyntheticArt {
    ArtPicture picture;
    Mask form;                      ///< pixels whose centre lies on it
    std::vector<glm::vec2> normals; ///< at pixel centres, n_y up; NaN off the form
};

/// The normal (n_x, n_y up) at a place in pixels, or NaN off the form.
using FormNormal = std::function<glm::dvec2(glm::dvec2)>;

SyntheticArt drawn(int width, int height, const FormNormal& form, const LitSphere& style);

FormNormal ballForm(const Ellipse& ellipse);
/// An ellipsoid of semi-axes `axes` (x, y, towards the viewer) in pixels.
FormNormal ellipsoidForm(glm::dvec2 centre, glm::dvec3 axes);
/// A ring seen from the front: `around` is the radius of the circle in its middle, `thick` that of the ring.
FormNormal torusForm(glm::dvec2 centre, double around, double thick);
/// Three balls that melt into one another: where the sum of their Gaussians is 1/2. Spans about 200 pixels.
FormNormal blobForm(glm::dvec2 centre);

/// A smooth style lit from the upper left with a gleam and a warm shadow: nothing in it is finer than a tenth.
LitSphere plainStyle(int size = 256);
/// One with a hard step, stripes at the rim, and strong colours.
LitSphere boldStyle(int size = 256);

/// Seeded noise of that deviation on each channel, clipped.
ArtPicture withNoise(ArtPicture picture, double deviation);
/// Through a JPEG of that quality.
ArtPicture throughJpeg(const ArtPicture& picture, int quality);
/// Black letters over the picture, rows of them.
ArtPicture withLetters(ArtPicture picture);

/// Paper with a circle of radius 100 and a few lines inside it, and no tone: 300 pixels square.
ArtPicture lineDrawing();

/// RMSE over the channels between two spheres where `covered` says so and the texel lies on the disk.
double sphereError(const LitSphere& a, const LitSphere& b, const Mask& covered);

} // namespace limner::testing
