// Sums of the samples and shaded samples of blocks of the rays' state.
uniform sampler2D rayState;

layout(location = 0) out vec4 sums;

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * kBlock;
    vec2 sum = vec2(0.0);
    for (int y = 0; y < kBlock; ++y) {
        for (int x = 0; x < kBlock; ++x) {
            sum += texelFetch(rayState, first + ivec2(x, y), 0).zw;
        }
    }
    sums = vec4(sum, 0.0, 0.0);
}
