// Once a view for each voxel: how many of its points are drawn (paper 004), how large, and where its face lies.
uniform mat3 stepSeen; // columns: a cell along the grid's axes, as seen
uniform float wholeScale;
uniform float density;
uniform float perFace;    // dots' areas in a voxel's face, a mm of it being one on paper
uniform float perPoint;   // 1 / points of a face in the pattern
uniform float fadingPart;
uniform float wholeFacing;
uniform float smallestDot;
uniform float fullestTone;
uniform float largestRadius; // pixels
uniform vec2 tolerance;      // behind matter, mm: face-on; how it grows with the slant
uniform float leastFacing;
uniform vec2 matterRamp;
uniform vec3 boundary;
uniform vec3 silhouette;
uniform float resolution;
uniform vec2 distance_; // exponent, half the volume's depth
uniform float centreDepth;
uniform float interior;
uniform float lighting;
uniform vec3 light;
uniform sampler2D coverage; // of densities from 0 to mostDensity, at even steps
uniform float mostDensity;

layout(location = 0) out vec4 count; // rank up to which dots are drawn, ranks over which they fade, opacity, radius
layout(location = 1) out vec4 face;  // its middle, seen; mm behind matter from where dots are hidden

float densityFor(float wanted) {
    int entries = textureSize(coverage, 0).x;
    int low = 0;
    int high = entries; // the first entry beyond what is wanted
    while (low < high) {
        int middle = (low + high) / 2;
        if (texelFetch(coverage, ivec2(middle, 0), 0).r > wanted) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    if (low == 0 || low == entries) {
        return low == 0 ? 0.0 : mostDensity;
    }
    float before = texelFetch(coverage, ivec2(low - 1, 0), 0).r;
    float part = (wanted - before) / (texelFetch(coverage, ivec2(low, 0), 0).r - before);
    return (float(low - 1) + part) / float(entries - 1) * mostDensity;
}

struct Factors {
    float tone, count, size, shrinking; // as in renderer/marks/ink.cpp
};

Factors factorsOf(float value, float gradient, vec3 seen, vec3 normal, float cosine, float scale) {
    Factors f = Factors(1.0, 1.0, gradient, 1.0);
#if OF_LAYERS
    f.tone = smoothStep(matterRamp.x, matterRamp.y, value);
#endif
#if BOUNDARY
    f.tone *= boundaryFactor(value, gradient, boundary);
#endif
#if SILHOUETTE
    f.tone *= silhouetteFactor(value, cosine, silhouette);
#endif
#if RESOLUTION
    float nearness = scale / wholeScale;
    f.count = resolutionFactor(0.0, 1.0 / nearness, 1.0, resolution);
    if (nearness < 1.0) {
        f.shrinking = min(nearness / sqrt(max(f.count, 1e-12)), 1.0);
    }
#endif
#if DISTANCE
    float deep = distanceFactor(seen.z - centreDepth, distance_.y, distance_.x);
    f.tone *= deep;
    f.size *= deep;
#endif
#if INTERIOR
    float inside = interiorFactor(gradient, interior);
    f.tone *= inside;
    f.size *= inside;
#endif
#if LIGHTING
    f.tone *= lightingFactor(dot(light, normal), lighting);
#endif
    return f;
}

void main() {
    count = vec4(0.0);
    face = vec4(0.0);
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 place = texelFetch(voxelPlaces, at, 0);
    vec4 normalAndGradient = texelFetch(voxelNormals, at, 0);
    vec4 surface = texelFetch(voxelSurfaces, at, 0);
    vec3 seen = viewAxes * place.xyz + viewMiddle;
    vec3 normal = viewAxes * normalAndGradient.xyz;
    float cosine = dot(normal, towardsEye(seen));
    float scale = scaleAt(seen);
    bool away = FACING_ONLY != 0 && cosine <= 0.0;
    if (!(surface.x > 0.0) || away || !(scale > 0.0) || isCut(seen)) {
        return;
    }
    float facing = abs(cosine);
    Factors f = factorsOf(place.w, normalAndGradient.w, seen, normal, cosine, scale);
    float size = max(f.size, smallestDot);
    float asked = density * f.tone;
#if COUNT_TONE
    float share = asked * (f.size / size) * (f.size / size);
#else
    float share = densityFor(min(asked, fullestTone)) / (size * size);
#endif
    float onPaper_ = max(scale, wholeScale);
    float end = surface.x * facing * perFace * onPaper_ * onPaper_ * share * f.count * perPoint;
    count = vec4(end, min(perPoint, fadingPart * end), min(facing / wholeFacing, 1.0),
                 largestRadius * size * f.shrinking);
    int axis = int(surface.w);
    face.xyz = seen + stepSeen[axis] * surface.z;
    face.w = tolerance.x * (1.0 + tolerance.y * (1.0 / max(facing, leastFacing) - 1.0));
}
