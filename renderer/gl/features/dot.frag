// The share of a pixel that a dot covers: the blending takes it off what still shows through.
uniform sampler2D stencils; // 1024 a row, each four texels of four pixels

flat in ivec3 corner;
flat in vec4 disc;

layout(location = 0) out vec4 share;

/// As edge_share.h has it.
float halfPlane(float inside, vec2 normal) {
    float a = abs(normal.x);
    float b = abs(normal.y);
    float most = 0.5 * (a + b);
    if (abs(inside) >= most) {
        return inside > 0.0 ? 1.0 : 0.0;
    }
    if (abs(inside) <= 0.5 * abs(a - b)) {
        return 0.5 + inside / max(a, b);
    }
    float beyond = (most - abs(inside)) * (most - abs(inside)) / (2.0 * a * b);
    return inside > 0.0 ? 1.0 - beyond : beyond;
}

void main() {
    ivec2 from = ivec2(gl_FragCoord.xy) - corner.xy;
    float covered = 0.0;
    if (corner.z >= 0) {
        if (any(lessThan(from, ivec2(0))) || any(greaterThan(from, ivec2(3)))) {
            discard;
        }
        covered = texelFetch(stencils, ivec2(4 * (corner.z & 1023) + from.y, corner.z >> 10), 0)[from.x];
    } else {
        vec2 d = vec2(from) - disc.xy;
        float apart = length(d);
        covered = apart <= max(disc.z - 0.75, 0.0)  ? 1.0
                  : apart >= disc.z + 0.75 ? 0.0
                                           : halfPlane(disc.z - apart, d / apart);
    }
    share = vec4(min(covered * disc.w, 1.0));
}
