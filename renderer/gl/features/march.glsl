// The march along a ray: skip empty space, sample, shade, compose.
uniform usampler3D distances; // blocks to the nearest one that can contribute
uniform vec2 entryOfTexel;    // the same from what the field's texture holds
uniform vec2 entryOfStored;   // entry of the value's table = stored * x + y
uniform vec2 visibleEntries;  // up to the first and from the second on nothing shows
uniform vec2 gapEntries;      // nor from the first to the second, where that is the greater one
uniform int visibility;       // table: > 0 where anything shows between an entry and the next; SLABS: how often before
uniform ivec3 pageLow;  // cells whose samples are this pass's
uniform ivec3 pageHigh;

layout(location = 0) out vec4 picture;
layout(location = 1) out vec4 rayState; // exponential, optical depth (-1 - it: done), samples, shaded

#if PAGED
uniform sampler2D picturePassed;
uniform sampler2D rayStatePassed;
uniform int lastPass;
uniform vec2 stretch; // samples of the ray that are this pass's: from, up to
#endif

const float kBurst = 8.0;          // steps between two looks at the skip grid
const float kBlockCells = 4.0; // along an edge of a block

/// The stretch of the lattice's sample k that is inside the visible part: begin and length, in steps.
vec2 segmentAt(Ray ray, float k) {
    float begin = max(k, ray.first);
    return vec2(begin, min(k + 1.0, ray.end) - begin);
}

/// The next sample past the empty space around sample k; k itself where its block can contribute. A slab is passed over
/// only where all of it lies in blocks that show nothing.
float pastEmpty(Ray ray, float k) {
    vec2 part = segmentAt(ray, k);
#if SLABS
    float s = part.x;
    const float last = 1.0; // of a sample, what must still be in the block
    float within = part.y;
#else
    float s = part.x + part.y * phase;
    float last = phase;
    const float within = -kFar;
#endif
    vec3 q = positionAt(ray, s);
    vec3 block = floor(q / kBlockCells);
    float away = float(texelFetch(distances, ivec3(block), 0).r);
    vec3 wall = mix(block - away + 1.0, block + away, greaterThan(ray.step, vec3(0.0)));
    vec3 leave = (wall * kBlockCells - q) * ray.inverse;
    float wayOut = min(leave.x, min(leave.y, leave.z));
    float next = floor(s + wayOut - last) + 1.0;
    return away > 0.0 && wayOut >= within ? max(next, k + 1.0) : k;
}

/// The ray in the field's texture.
struct Line {
    vec3 start, step;
};

bool isOwn(Ray ray, float s) {
#if PAGED
    ivec3 cell = ivec3(positionAt(ray, s));
    return all(greaterThanEqual(cell, pageLow)) && all(lessThan(cell, pageHigh));
#else
    return true;
#endif
}

/// Whether anything may show from one entry to another.
bool mayShow(float low, float high) {
    return high > visibleEntries.x && low < visibleEntries.y && (low < gapEntries.x || high > gapEntries.y);
}

#if SLABS
float entryAt(Ray ray, Line line, float s) {
#if SPLINE
    float entry = fieldAt(positionAt(ray, s)) * entryOfStored.x + entryOfStored.y;
#else
    float entry = textureLod(field, line.start + line.step * s, 0.0).r * entryOfTexel.x + entryOfTexel.y;
#endif
    return clamp(entry, 0.0, lastEntry);
}

vec2 passedEnd; // of the slab before: where on the ray, and the entry there

/// Looks up the slab of sample k; whether it can be seen.
bool look(Ray ray, Line line, float k, out Sample found) {
    float end = min(k + 1.0, ray.end);
    found.s = max(k, ray.first);
    found.part = end - found.s;
    found.entry = passedEnd.x == found.s ? passedEnd.y : entryAt(ray, line, found.s);
    found.back = entryAt(ray, line, end);
    passedEnd = vec2(end, found.back);
    float low = min(found.entry, found.back);
    float high = max(found.entry, found.back);
    bool inRange = mayShow(low, high) && isOwn(ray, 0.5 * (found.s + end));
    return inRange && numberAt(visibility + int(high) + 1) > numberAt(visibility + int(low));
}
#else
/// Looks up sample k; whether it can be seen.
bool look(Ray ray, Line line, float k, out Sample found) {
    vec2 part = segmentAt(ray, k);
    found.part = part.y;
    found.s = part.x + part.y * phase;
#if SPLINE
    found.entry = clamp(fieldAt(positionAt(ray, found.s)) * entryOfStored.x + entryOfStored.y, 0.0, lastEntry);
#else
    found.entry = textureLod(field, line.start + line.step * found.s, 0.0).r * entryOfTexel.x + entryOfTexel.y;
#endif
    bool inRange = mayShow(found.entry, found.entry) && isOwn(ray, found.s);
    found.entry = max(found.entry, 0.0);
    return inRange && numberAt(visibility + int(found.entry)) > 0.0;
}
#endif

#if PAGED
/// Cuts a ray to the samples that can lie in the page, one more at both ends: each is asked whether it does.
void cutToPage(Ray ray, inout float k, inout float end) {
    vec3 a = (vec3(pageLow) - ray.start) * ray.inverse;
    // Half a voxel past the last middle the position stays at the last cell: such samples are the last page's.
    vec3 far = vec3(pageHigh) + vec3(greaterThan(vec3(pageHigh), lastCell));
    vec3 b = (far - ray.start) * ray.inverse;
    vec3 low = min(a, b);
    vec3 high = max(a, b);
    k = max(k, floor(max(low.x, max(low.y, low.z))) - 1.0);
    end = min(end, ceil(min(high.x, min(high.y, high.z))) + 1.0);
}
#endif

void main() {
    Ray ray = rayOf(gl_FragCoord.xy - float(kHalfTile));
    Line line = Line(texturePlace(ray.start), ray.step * placeScale);
    Pixel pixel = beginPixel();
    vec2 counts = vec2(0.0);
#if SLABS
    passedEnd = vec2(-1.0, 0.0);
#endif
    float k = floor(ray.first);
    float end = ceil(ray.end);
#if PAGED
    vec4 passed = texelFetch(rayStatePassed, ivec2(gl_FragCoord.xy), 0);
    pixel = resumePixel(texelFetch(picturePassed, ivec2(gl_FragCoord.xy), 0), passed.xy);
    counts = passed.zw;
    cutToPage(ray, k, end);
    k = max(k, stretch.x);
    end = min(end, stretch.y);
#endif
    bool more = ray.first < ray.end && k < end && !isDone(pixel);
#if MARCH_THEN_SHADE
    // Where both sides of a branch are run for all rays of a vector, shading waits until each of them has a sample.
    while (more) {
        Sample found;
        bool seen = false;
        while (k < end && !seen) {
            float next = pastEmpty(ray, k);
            while (next > k && next < end) {
                k = next;
                next = pastEmpty(ray, k);
            }
            k = next;
            float from = k;
            float until = min(k + kBurst, end);
            while (k < until && !seen) {
                seen = look(ray, line, k, found);
                k += 1.0;
            }
            counts.x += k - from;
        }
        if (seen) {
            counts.y += 1.0;
            addSample(pixel, ray, found);
        }
        more = k < end && !isDone(pixel);
    }
#else
    while (more) {
        float next = pastEmpty(ray, k);
        if (next > k) {
            k = next;
        } else {
            Sample found;
            counts.x += 1.0;
            if (look(ray, line, k, found)) {
                counts.y += 1.0;
                addSample(pixel, ray, found);
            }
            k += 1.0;
        }
        more = k < end && !isDone(pixel);
    }
#endif
#if PAGED
    picture = lastPass != 0 ? finished(pixel) : pixel.rgba;
#else
    picture = finished(pixel);
#endif
    rayState = vec4(stateOf(pixel), counts);
}
