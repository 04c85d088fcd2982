// A dot as a point of so many pixels, its stencil or its disc to be laid by dot.frag as band_canvas.h does.
uniform vec2 pixelsPerMm;
uniform ivec2 tileOrigin;
uniform vec2 tileSize;
uniform float guard; // pixels around the tile that points may have their middle in

flat out ivec3 corner; // of the stencil's first pixel, or of the middle one; number of the stencil, or -1
flat out vec4 disc;    // from the middle pixel's middle to the dot's, radius, opacity

const float kFarthest = 2e6;
const float kLargestStencil = 1.5; // DotStencils
const float kSizesPerPixel = 32.0;
const float kFirstSize = 3.0;
const float kSizes = 46.0;

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // nowhere
    gl_PointSize = 1.0;
    corner = ivec3(0);
    disc = vec4(0.0);
    PlacedDot placed = placedDot();
    vec2 place = placed.mm * pixelsPerMm;
    float radius = placed.radius;
    if (!(placed.opacity > 0.0 && radius > 0.0 && abs(place.x) < kFarthest && abs(place.y) < kFarthest)) {
        return;
    }
    ivec2 units = ivec2(floor(place * 256.0 + 0.5));
    vec2 middle;
    if (radius <= kLargestStencil) {
        ivec2 phases = ((units + 4) >> 3) - 48;
        ivec2 pixel = phases >> 5;
        float size = clamp(floor(radius * kSizesPerPixel + 0.5), kFirstSize, kFirstSize + kSizes - 1.0);
        float ratio = radius * kSizesPerPixel / size;
        corner = ivec3(pixel - tileOrigin, (int(size - kFirstSize) * 32 + (phases.y & 31)) * 32 + (phases.x & 31));
        disc = vec4(0.0, 0.0, radius, ratio * ratio * placed.opacity);
        middle = vec2(corner.xy + 2);
        gl_PointSize = 4.0;
    } else {
        ivec2 pixel = units >> 8;
        corner = ivec3(pixel - tileOrigin, -1);
        disc = vec4(vec2(units - pixel * 256) / 256.0 - 0.5, sqrt(radius * radius - 1.0 / 12.0), placed.opacity);
        middle = vec2(corner.xy) + 0.5;
        gl_PointSize = 2.0 * (floor(disc.z) + 2.0) + 1.0;
    }
    gl_Position = vec4((middle + guard) / (tileSize + 2.0 * guard) * 2.0 - 1.0, 0.0, 1.0);
}
