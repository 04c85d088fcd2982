#pragma once

#include <glm/vec3.hpp>

namespace limner::accuracy {

/// CIE XYZ of an sRGB-encoded colour, 0..1 (IEC 61966-2-1), Y of white 1. Out of gamut: continued.
glm::dvec3 xyzOfSrgb(const glm::dvec3& rgb);

/// CIE L*a*b* of such an XYZ; white: D65.
glm::dvec3 labOfXyz(const glm::dvec3& xyz);

/// CIE L*a*b* of an sRGB-encoded colour, 0..1 (white: D65, IEC 61966-2-1). Out of gamut: continued.
glm::dvec3 labOfSrgb(const glm::dvec3& rgb);

/// The colour difference CIEDE2000 of two L*a*b* colours, all weights 1 (Sharma, Wu and Dalal 2005).
double ciede2000(const glm::dvec3& first, const glm::dvec3& second);

} // namespace limner::accuracy
