// Whether a candidate is drawn in this view, and where.
layout(location = 0) in vec2 onFace;
layout(location = 1) in uvec2 voxelAndOrder; // the order: rank in the upper half, chance in the lower

uniform sampler2D voxelCounts; // of dot_counts.frag
uniform sampler2D voxelFaces;
uniform sampler2D nearest; // depth of matter, by cells of the paper
uniform vec3 stepX, stepY, stepZ; // cells along the grid's axes, mm
uniform mat3 stepSeen;
uniform float spreadMm;
uniform float faintest;
uniform float cellMm;

struct PlacedDot {
    vec2 mm; // on paper
    float depth;
    float radius;  // pixels
    float opacity; // 0: not drawn
};

#if HIDES
float visible(vec2 mm, float depth, float tolerated) {
    const float kFarCells = 32768.0;
    vec2 at = mm / cellMm - 0.5;
    if (!(abs(at.x) < kFarCells && abs(at.y) < kFarCells)) {
        return 1.0;
    }
    ivec2 low = ivec2(floor(at));
    vec2 f = at - vec2(low);
    ivec2 cells = textureSize(nearest, 0);
    float sum = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 step = ivec2(k & 1, k >> 1);
        ivec2 cell = low + step;
        float weight = (step.x != 0 ? f.x : 1.0 - f.x) * (step.y != 0 ? f.y : 1.0 - f.y);
        float t = 0.0;
        if (all(greaterThanEqual(cell, ivec2(0))) && all(lessThan(cell, cells))) {
            t = clampedToUnit((texelFetch(nearest, cell, 0).r - depth) / tolerated - 1.0);
        }
        sum += weight * (1.0 - t * t * (3.0 - 2.0 * t));
    }
    return min(sum, 1.0);
}
#endif

PlacedDot placedDot() {
    PlacedDot dot_ = PlacedDot(vec2(0.0), 0.0, 0.0, 0.0);
    ivec2 at = texelOfVoxel(int(voxelAndOrder.x));
    vec4 count = texelFetch(voxelCounts, at, 0);
    float rank = float(voxelAndOrder.y >> 16u) / 65536.0;
    if (!(rank < count.x + 0.5 * count.y)) {
        return dot_;
    }
    float shown = count.z * min((count.x - rank) / count.y + 0.5, 1.0);
    vec4 face = texelFetch(voxelFaces, at, 0);
    vec3 normal = texelFetch(voxelNormals, at, 0).xyz;
    int axis = int(texelFetch(voxelSurfaces, at, 0).w);
    vec3 rises = vec3(dot(normal, stepX), dot(normal, stepY), dot(normal, stepZ));
    int first = axis == 0 ? 1 : 0;
    int second = axis == 2 ? 1 : 2;
    vec3 up = stepSeen[axis] / rises[axis];
    float chance = float(voxelAndOrder.y & 0xFFFFu) / 32768.0 - 1.0;
    vec3 seen = face.xyz + onFace.x * (stepSeen[first] - rises[first] * up) +
                onFace.y * (stepSeen[second] - rises[second] * up) + chance * spreadMm * (viewAxes * normal);
    float scale = scaleAt(seen);
    if (!(scale > 0.0) || isCut(seen)) {
        return dot_;
    }
    dot_.mm = onPaper(seen, scale);
    dot_.depth = seen.z;
    dot_.radius = count.w;
#if HIDES
    shown *= visible(dot_.mm, seen.z, face.w);
#endif
    dot_.opacity = shown >= faintest ? min(shown, 1.0) : 0.0;
    return dot_;
}
