// The volume as a field. Positions are in cells: the voxel v has its middle at v + 1. Numbers come as they are stored.
uniform ivec3 pageFirst;  // voxel at the begin of the textures; 0 where they hold the whole volume
uniform vec3 pageSize;    // voxels
uniform vec3 lastCell;    // largest position that still has a cell
uniform sampler3D field;
uniform vec2 storedField; // stored number = texture's * x + y

uniform vec3 placeScale;  // place in the textures = q * placeScale + placeShift
uniform vec3 placeShift;

vec3 texturePlace(vec3 q) { return q * placeScale + placeShift; }

/// Whole voxels around a cell, kept inside the texture, from one before the cell's lower voxel.
struct Around {
    ivec4 x, y, z;
    vec3 f; // place inside the cell
};

Around aroundCell(vec3 q) {
    vec3 cell = floor(q);
    ivec3 low = ivec3(cell) - 2 - pageFirst; // lower voxel of cell c: c - 1
    ivec3 last = ivec3(pageSize) - 1;
    ivec4 step = ivec4(0, 1, 2, 3);
    return Around(clamp(low.x + step, 0, last.x), clamp(low.y + step, 0, last.y), clamp(low.z + step, 0, last.z),
                  q - cell);
}

float storedOf(sampler3D volume, vec2 stored, vec3 q) {
    return textureLod(volume, texturePlace(q), 0.0).r * stored.x + stored.y;
}

// Weights of the four voxels of an axis.

vec4 splineTaps(float f) {
    float g = 1.0 - f;
    return vec4(g * g * g / 6.0, 2.0 / 3.0 - f * f * (1.0 - 0.5 * f), 2.0 / 3.0 - g * g * (1.0 - 0.5 * g),
                f * f * f / 6.0);
}

vec4 splineSlopeTaps(float f) {
    float g = 1.0 - f;
    return vec4(-0.5 * g * g, f * (1.5 * f - 2.0), -g * (1.5 * g - 2.0), 0.5 * f * f);
}

vec4 splineBendTaps(float f) { return vec4(1.0 - f, 3.0 * f - 2.0, 1.0 - 3.0 * f, f); }

/// Central differences at the cell's corners, interpolated.
vec4 differenceTaps(float f) { return 0.5 * vec4(f - 1.0, -f, 1.0 - f, f); }

/// (1, centre, 1) / (2 + centre) at the cell's corners, interpolated.
vec4 smoothingTaps(float f, float centre) {
    float g = 1.0 - f;
    return vec4(g, g * centre + f, f * centre + g, f) / (2.0 + centre);
}

vec4 rowOf(sampler3D volume, vec2 stored, Around a, int y, int z) {
    ivec2 yz = ivec2(a.y[y], a.z[z]);
    return vec4(texelFetch(volume, ivec3(a.x.x, yz), 0).r, texelFetch(volume, ivec3(a.x.y, yz), 0).r,
                texelFetch(volume, ivec3(a.x.z, yz), 0).r, texelFetch(volume, ivec3(a.x.w, yz), 0).r) *
               stored.x +
           stored.y;
}

float fieldAt(vec3 q) {
#if SPLINE
    // Pairs of weights of one sign are one linear look-up each: 8 instead of 64.
    vec3 cell = floor(q);
    vec3 f = q - cell;
    vec3 g = 1.0 - f;
    vec3 w0 = g * g * g / 6.0;
    vec3 w1 = 2.0 / 3.0 - f * f * (1.0 - 0.5 * f);
    vec3 w3 = f * f * f / 6.0;
    vec3 lower = w0 + w1;
    vec3 upper = 1.0 - lower;
    vec3 from = cell - 1.0 + w1 / lower;
    vec3 to = cell + 1.0 + w3 / upper;
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        bvec3 high = notEqual(ivec3(i) & ivec3(1, 2, 4), ivec3(0));
        vec3 weight = mix(lower, upper, vec3(high));
        sum += weight.x * weight.y * weight.z * storedOf(field, storedField, mix(from, to, vec3(high)));
    }
    return sum;
#else
    return storedOf(field, storedField, q);
#endif
}

#if READS_NORMAL
// Gradients, in the units that eyeFromGradient expects.
uniform mat3 eyeFromGradient;
uniform float gradientFloor;
uniform float perGradientMax;
#if GRADIENT == GRADIENT_TAPS
uniform sampler3D gradientField;
uniform vec2 storedGradient;
uniform float gradientRounding; // components up to this are 0
#endif

#if GRADIENT == GRADIENT_TAPS
vec3 gradientAt(vec3 q) {
    Around a = aroundCell(q);
#if GRADIENT_KERNEL == KERNEL_SPLINE
    vec4 vx = splineTaps(a.f.x), vy = splineTaps(a.f.y), vz = splineTaps(a.f.z);
    vec4 sx = splineSlopeTaps(a.f.x), sy = splineSlopeTaps(a.f.y), sz = splineSlopeTaps(a.f.z);
#else
    const float centre = GRADIENT_KERNEL == KERNEL_SOBEL ? 2.0 : 1.0;
    vec4 vx = smoothingTaps(a.f.x, centre), vy = smoothingTaps(a.f.y, centre), vz = smoothingTaps(a.f.z, centre);
    vec4 sx = differenceTaps(a.f.x), sy = differenceTaps(a.f.y), sz = differenceTaps(a.f.z);
#endif
    vec3 g = vec3(0.0);
    for (int k = 0; k < 4; ++k) {
        vec3 slice = vec3(0.0); // slope along x, along y, value
        for (int j = 0; j < 4; ++j) {
            vec4 row = rowOf(gradientField, storedGradient, a, j, k);
            float value = dot(row, vx);
            slice += vec3(vy[j] * dot(row, sx), sy[j] * value, vy[j] * value);
        }
        g += vec3(vz[k] * slice.x, vz[k] * slice.y, sz[k] * slice.z);
    }
    return mix(vec3(0.0), g, greaterThan(abs(g), vec3(gradientRounding)));
}
#else
vec3 differencesOver(vec3 q, float reach) {
    vec3 low = clamp(q - reach, vec3(0.0), lastCell);
    vec3 high = clamp(q + reach, vec3(0.0), lastCell);
    return vec3(storedOf(field, storedField, vec3(high.x, q.yz)) - storedOf(field, storedField, vec3(low.x, q.yz)),
                storedOf(field, storedField, vec3(q.x, high.y, q.z)) -
                    storedOf(field, storedField, vec3(q.x, low.y, q.z)),
                storedOf(field, storedField, vec3(q.xy, high.z)) - storedOf(field, storedField, vec3(q.xy, low.z)));
}
/// f(q + 1) - f(q - 1) along each axis, or of fourth order like such a difference.
vec3 gradientAt(vec3 q) {
#if GRADIENT == GRADIENT_FOURTH_ORDER
    return (8.0 * differencesOver(q, 1.0) - differencesOver(q, 2.0)) / 6.0;
#else
    return differencesOver(q, 1.0);
#endif
}
#endif
#endif

#if BEND
uniform sampler3D bendField;
uniform vec2 storedBend;
uniform mat3 eyeFromBend;

/// Curvature along the view by the second derivatives of the bend field, 1/mm.
float bendAt(vec3 q, vec3 view) {
    Around a = aroundCell(q);
    vec4 vx = splineTaps(a.f.x), vy = splineTaps(a.f.y), vz = splineTaps(a.f.z);
    vec4 sx = splineSlopeTaps(a.f.x), sy = splineSlopeTaps(a.f.y), sz = splineSlopeTaps(a.f.z);
    vec4 bx = splineBendTaps(a.f.x), by = splineBendTaps(a.f.y), bz = splineBendTaps(a.f.z);
    vec3 slope = vec3(0.0), bend = vec3(0.0), twist = vec3(0.0); // xx yy zz; xy xz yz
    for (int k = 0; k < 4; ++k) {
        vec3 plane = vec3(0.0);  // along x, along y, value
        vec3 second = vec3(0.0); // xx, yy, xy
        for (int j = 0; j < 4; ++j) {
            vec4 row = rowOf(bendField, storedBend, a, j, k);
            float value = dot(row, vx);
            float along = dot(row, sx);
            plane += vec3(vy[j] * along, sy[j] * value, vy[j] * value);
            second += vec3(vy[j] * dot(row, bx), by[j] * value, sy[j] * along);
        }
        slope += vec3(vz[k] * plane.xy, sz[k] * plane.z);
        bend += vec3(vz[k] * second.xy, bz[k] * plane.z);
        twist += vec3(vz[k] * second.z, sz[k] * plane.xy);
    }
    vec3 g = eyeFromBend * slope;
    float squared = dot(g, g);
    vec3 tangent = view - dot(g, view) / max(squared, 1e-36) * g;
    vec3 u = tangent * eyeFromBend; // the transposed matrix
    float along = dot(u * u, bend) + 2.0 * dot(vec3(u.x * u.y, u.x * u.z, u.y * u.z), twist);
    return curvatureAlongView(along, dot(tangent, tangent), sqrt(squared));
}
#endif
