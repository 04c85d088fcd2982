// The papers' formulas, twins of core/optics: written from the specification (numerics.md), on their own.

// Opacity (numerics.md 2b).

float opticalDepth(float opacity) { return -log1p(-opacity); }

/// Opacity of `ratio` reference lengths: 1 - (1 - a)^ratio.
float opacityOfLength(float opacity, float ratio) {
    float through = log1p(-clamp(opacity, 0.0, 1.0 - 5.96046448e-8));
    float corrected = opacity >= 1.0 ? 1.0 : -expm1(ratio * through);
    return ratio > 0.0 ? corrected : 0.0;
}

/// Directional opacity times the uniform one to a power from 1/2 to 3/2, by the 100-percent rule.
float illustrativeOpacity(float directional, float opacity, float facing, float width, float gradientMagnitude) {
    float inside = max(0.0, clampedToUnit(facing) - width);
    float exponent = 0.5 + inside * (1.0 - clampedToUnit(gradientMagnitude));
    return opacity > 0.0 ? directional * powc(min(opacity, 1.0), exponent) : 0.0;
}

// Contours (numerics.md 2a).

/// c = sqrt(x (2 - x)), x = thickness times curvature.
float contourWidth(float thicknessTimesCurvature) {
    float x = clampedToUnit(thicknessTimesCurvature);
    return sqrt(x * (2.0 - x));
}

/// Radius on the sphere's picture: pushed out by 1 / delta on a contour, onto the rim where that is beyond it.
float contourPush(float radius, float facing, float width) {
    float f = clampedToUnit(facing);
    float r = clampedToUnit(radius);
    if (f >= width) {
        return r;
    }
    return r * width >= f ? 1.0 : r * width / f;
}

/// Ink over a plain colour: 1 on the contour, 0 beyond it, over the last tenth of its width between.
float contourCoverage(float facing, float width) {
    return width > 0.0 ? 1.0 - smoothStep(0.9 * width, width, facing) : 0.0;
}

/// Angle between two normals over their distance.
float curvatureOfNormals(vec3 n0, vec3 n1, float apart) {
    bool second = dot(n1, n1) < dot(n0, n0);
    vec3 across = cross(second ? n1 : n0, n1 - n0); // of nearly equal vectors no digit is lost
    return apart > 0.0 ? preciseAtan2(sqrt(dot(across, across)), dot(n0, n1)) / apart : 0.0;
}

/// |t' H t| / (|t|^2 |g|), t the view's part in the tangent plane.
float curvatureAlongView(float secondDerivative, float tangentSquared, float gradientMagnitude) {
    float scale = tangentSquared * gradientMagnitude;
    return scale > 0.0 ? abs(secondDerivative) / scale : 0.0;
}

// Mip levels of lit spheres (style-transfer-functions.md 7).

const float kStructureVoxels = 32.0;

float mipLevel(float radiusTexels, float footprint, float curvature) {
    float turn = footprint * max(1.0 / kStructureVoxels, abs(curvature));
    return clampedToUnit(footprint - 1.0) * preciseLog2(max(1.0, radiusTexels * turn));
}

// Measures of importance (numerics.md 2d).

const float kGreatestExtinction = 1e6;
const float kUnoccluded = 20.0;
const float kGreatestImportance = 64.0;

float wholePower(float x, int exponent) {
    float power = 1.0;
    for (int bits = exponent; bits > 0; bits >>= 1) {
        power *= (bits & 1) != 0 ? x : 1.0;
        x *= x;
    }
    return power;
}

float intensityImportance(float value) { return clampedToUnit(value); }

float extinctionImportance(float extinction) { return log1p(clamp(extinction, 0.0, kGreatestExtinction)); }

/// `terms`: exponent, and the edges of the step in 1 - |n.v|.
float silhouetteness(float gradientMagnitude, float facing, vec3 terms) {
    return powc(clampedToUnit(gradientMagnitude), terms.x) *
           smoothStep(terms.y, terms.z, 1.0 - clampedToUnit(facing));
}

float unocclusionImportance(float depthSoFar) { return max(0.0, kUnoccluded - depthSoFar); }

/// Half way between light and viewer; zero where they are opposite.
vec3 halfwayDirection(vec3 light, vec3 viewer) {
    vec3 sum = light + viewer;
    float largest = max(abs(sum.x), max(abs(sum.y), abs(sum.z)));
    vec3 scaled = sum / (largest > 0.0 ? largest : 1.0);
    return largest > 0.0 ? scaled / sqrt(dot(scaled, scaled)) : vec3(0.0);
}

/// `exponents`: of highlight, diffuse light and gradient.
float lightingImportance(float cosineHalfway, float cosineLight, float gradientMagnitude, ivec3 exponents) {
    return 3.0 - wholePower(clampedToUnit(cosineHalfway), exponents.x) -
           wholePower(clampedToUnit(cosineLight), exponents.y) -
           wholePower(1.0 - clampedToUnit(gradientMagnitude), exponents.z);
}

float totalImportance(float weight, float sum) { return clamp(finiteOr(weight * sum, 0.0), 0.0, kGreatestImportance); }

/// Importance of what can hardly be seen fades from four floors of extinction to one.
float importanceOfVisible(float importance, float extinction, float floor_) {
    return importance * smoothStep(floor_, 4.0 * floor_, extinction);
}

float circularLens(float weight, float apart, float radius) { return apart > radius ? 0.0 : weight; }

float gaussianLens(float weight, float apart, float radius) {
    float ratio = apart / (radius > 0.0 ? radius : 1.0);
    return radius > 0.0 ? weight * preciseExp(-2.0 * ratio * ratio) : 0.0;
}

// Composition by importance (numerics.md 2c).

/// The ray's colour, opacity a, share e and reference importance Iref: E = e exp(Iref).
struct ImportanceRay {
    float colour, opacity, share, reference;
};

ImportanceRay startOfRay() { return ImportanceRay(0.0, 0.0, 1.0, 0.0); }

ImportanceRay withSample(ImportanceRay ray, float colour, float opacity, float importance) {
    if (!(opacity > 0.0)) {
        return ray;
    }
    float alpha = min(opacity, 1.0);
    float e = ray.share;
    float fall = preciseExp(-abs(importance - ray.reference));
    float x = fall;
    if (importance > ray.reference) {
        e *= fall;
        x = 1.0;
    }
    float whole = ray.opacity + (1.0 - ray.opacity) * alpha;
    float risen = e + alpha * max(0.0, x - e);
    float kept = ray.opacity * x > e ? e / risen : ray.opacity / whole;
    return ImportanceRay(colour + (ray.colour - colour) * kept, whole, risen, max(ray.reference, importance));
}

/// I = Iref + ln e
float importanceSoFar(ImportanceRay ray) { return ray.reference + 0.693147181 * preciseLog2(ray.share); }

/// The same with E = e^I itself, for importances that single precision's exponential holds: changes a and E, and gives
/// the share of the colour so far that is kept.
float keptBehind(inout float opacity, inout float exponential, float sampleOpacity, float sampleExponential) {
    float whole = opacity + (1.0 - opacity) * sampleOpacity;
    float risen = exponential + sampleOpacity * max(0.0, sampleExponential - exponential);
    float kept = opacity * sampleExponential > exponential ? exponential / risen : opacity / whole;
    opacity = whole;
    exponential = risen;
    return kept;
}

// Layers (paper 003).

/// Place on a tone's ramp: 0 turned away from the light, 1 towards it.
float tonePlace(float normalToLight, float definedness) {
    return 0.5 * (1.0 + definedness * clamp(normalToLight, -1.0, 1.0));
}

float silhouetteShare(float facing, float full, float none, float definedness) {
    return definedness * (1.0 - smoothStep(full, none, abs(facing)));
}

/// Cosine of the normal with the half-way direction of light and viewer.
float halfway(float normalToLight, float facing, float lightToViewer) {
    float squared = 2.0 + 2.0 * lightToViewer;
    return squared > 1e-6 ? clampedToUnit((normalToLight + facing) / sqrt(squared)) : 0.0;
}

float withLine(float shading, float line) { return shading + line - shading * line; }

float lineShare(float shading, float line) {
    float all = withLine(shading, line);
    return all > 0.0 ? line / all : 0.0;
}

float keptByPlane(float inside, float reach) {
    float share = clampedToUnit(0.5 + inside / (reach > 1e-6 ? reach : 1.0));
    return reach > 1e-6 ? share : (inside >= 0.0 ? 1.0 : 0.0);
}

float cutFaceShare(float insideVoxels) { return clampedToUnit(2.0 - insideVoxels); }

/// A whole copy's slope is off by up to 1: what is within that is 0.
float slopeOfCopy(float slope) {
    float beyond = max(0.0, abs(slope) - 1.0);
    return slope < 0.0 ? -beyond : beyond;
}

float blurLevel(float depth, float focus, float strength) { return min(3.0, 4.0 * strength * abs(depth - focus)); }

float ambientOcclusion(float mean, float normalDotVector, float definedness) {
    return definedness * clampedToUnit(mean + 2.0 * normalDotVector);
}

float shadowed(float occlusion, float normalToLight, float definedness) {
    return definedness * clampedToUnit(occlusion) * smoothStep(0.0, 0.3, normalToLight);
}

// Textures.

/// n^4 of each axis over their sum; zero for a zero normal.
vec3 projectionWeights(vec3 normal) {
    vec3 square = normal * normal;
    vec3 fourth = square * square;
    float sum = fourth.x + fourth.y + fourth.z;
    return sum > 0.0 ? fourth / sum : vec3(0.0);
}

// Stippling (numerics.md 2e). `curve`: constant, scale, exponent.

float stippleFactor(float raw) { return clampedToUnit(finiteOr(raw, 1.0)); }

float boundaryFactor(float value, float gradientMagnitude, vec3 curve) {
    return stippleFactor(value * (curve.x + curve.y * powc(clampedToUnit(gradientMagnitude), curve.z)));
}

float silhouetteFactor(float value, float cosineEye, vec3 curve) {
    return stippleFactor(value * (curve.x + curve.y * powc(1.0 - clampedToUnit(abs(cosineEye)), curve.z)));
}

float resolutionFactor(float nearest, float apart, float reference, float exponent) {
    float far = nearest + apart;
    return far > 0.0 ? stippleFactor(powc((nearest + reference) / far, exponent)) : 1.0;
}

float distanceFactor(float depth, float halfDepth, float exponent) {
    float ratio = clamp(depth / (halfDepth > 0.0 ? halfDepth : 1.0), -1.0, 1.0);
    float power = spow(ratio, abs(exponent));
    float factor = 0.5 * (1.0 + (exponent < 0.0 ? -power : power));
    return halfDepth > 0.0 && exponent != 0.0 ? stippleFactor(factor) : 1.0;
}

float interiorFactor(float gradientMagnitude, float exponent) {
    return stippleFactor(powc(clampedToUnit(gradientMagnitude), exponent));
}

float lightingFactor(float cosineLight, float exponent) {
    return stippleFactor(1.0 - powc(clampedToUnit(cosineLight), exponent));
}
