// Rays of the picture, relative to their tile's middle, which is worked out in double (numerics.md 2f, posters).
uniform vec3 tileStart;     // cells: where the tile's middle ray passes the box's middle
uniform vec3 tileDirection; // cells: per mm; perspective: of the middle ray to the target plane
uniform vec3 startRight;    // cells per sub-pixel
uniform vec3 startDown;
uniform float stepMm;
uniform float stepRatio; // step over the reference length
uniform float phase;
uniform vec3 boxLow;
uniform vec3 boxHigh;
uniform int clipPlanes;      // number
uniform int clipPlaneTable;  // of colours: normal and offset, kept is dot(normal, q) <= offset
#if PERSPECTIVE
uniform vec3 directionRight; // cells per sub-pixel
uniform vec3 directionDown;
uniform vec3 middleEye;      // mm in eye space: the middle ray's direction
uniform vec2 perPixelEye;    // mm
uniform float nearest;       // of tileStart along tileDirection
#endif

const float kParallel = 1e-20; // steps below this are rounding noise of a ray along a face
const float kFar = 1e30;

/// Position of parameter s, in steps: start + s step; sample k of the lattice stands for [k, k + 1).
struct Ray {
    vec3 start, step, inverse;
    vec3 view;        // unit, eye space, towards the viewer
    float first, end; // the visible stretch, in steps
};

void enterBox(inout Ray ray) {
    vec3 a = (boxLow - ray.start) * ray.inverse;
    vec3 b = (boxHigh - ray.start) * ray.inverse;
    vec3 low = min(a, b);
    vec3 high = max(a, b);
    // A ray along a face is inside or outside as a whole.
    bvec3 along = lessThan(abs(ray.step), vec3(kParallel));
    bvec3 inside = bvec3(ivec3(greaterThanEqual(ray.start, boxLow)) & ivec3(lessThanEqual(ray.start, boxHigh)));
    vec3 without = mix(vec3(-kFar), vec3(kFar), inside);
    low = mix(low, -without, along);
    high = mix(high, without, along);
    ray.first = max(ray.first, max(low.x, max(low.y, low.z)));
    ray.end = min(ray.end, min(high.x, min(high.y, high.z)));
    // The lattice begins at the entry.
    bool hit = ray.first < ray.end;
    float entry = hit ? ray.first : 0.0;
    ray.start += ray.step * entry;
    ray.end = hit ? ray.end - entry : -1.0;
    ray.first = 0.0;
}

void cutByPlanes(inout Ray ray) {
    for (int i = 0; i < clipPlanes; ++i) {
        vec4 plane = colourAt(clipPlaneTable + i);
        float along = dot(plane.xyz, ray.step);
        float rest = plane.w - dot(plane.xyz, ray.start);
        float t = rest / (abs(along) > kParallel ? along : 1.0);
        if (along > kParallel) {
            ray.end = min(ray.end, t);
        } else if (along < -kParallel) {
            ray.first = max(ray.first, t);
        } else if (rest < 0.0) {
            ray.end = -1.0;
        }
    }
}

/// `d`: sub-pixels from the tile's middle, right and down.
Ray rayOf(vec2 d) {
    Ray ray;
    ray.start = tileStart + d.x * startRight + d.y * startDown;
    ray.end = kFar;
#if PERSPECTIVE
    vec3 eye = middleEye + vec3(d * perPixelEye, 0.0);
    float inverseLength = 1.0 / sqrt(dot(eye, eye));
    float perStep = stepMm * inverseLength;
    ray.step = perStep * (tileDirection + (d.x * directionRight + d.y * directionDown));
    ray.view = -eye * inverseLength;
    ray.first = -nearest / perStep; // the eye
#else
    ray.step = tileDirection * stepMm;
    ray.view = vec3(0.0, 0.0, 1.0);
    ray.first = -kFar; // there is no eye to be in front of
#endif
    ray.inverse = 1.0 / mix(ray.step, vec3(kParallel), lessThan(abs(ray.step), vec3(kParallel)));
    enterBox(ray);
    cutByPlanes(ray);
    return ray;
}
