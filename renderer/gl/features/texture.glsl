// Textures laid on the object, apart from its lighting.
uniform mat3 mmFromCell;
uniform vec3 mmOrigin; // of the position 0
uniform int textureTable; // of numbers: for each node of each layer where its tile begins in colours (-1: none), its
                          // size, tiles per mm and strength

/// Bilinear, repeating.
vec4 tileFactor(int first, int size, vec2 tiles) {
    vec2 at = fract(tiles) * float(size) - 0.5;
    vec2 below = floor(at);
    ivec2 low = ivec2(below) & (size - 1);
    ivec2 high = (low + 1) & (size - 1);
    vec4 top = mix(colourAt(first + low.y * size + low.x), colourAt(first + low.y * size + high.x), at.x - below.x);
    vec4 base = mix(colourAt(first + high.y * size + low.x), colourAt(first + high.y * size + high.x), at.x - below.x);
    return mix(top, base, at.y - below.y);
}

/// One style's factor of the colours; `entry`: of its four numbers.
vec4 laidFactor(Facts facts, int entry) {
    int first = int(numberAt(entry));
    if (first < 0) {
        return vec4(1.0);
    }
    int size = int(numberAt(entry + 1));
    vec3 mm = (mmFromCell * facts.q + mmOrigin) * numberAt(entry + 2);
    vec3 weight = projectionWeights(mmFromEye * facts.normal);
    vec4 laid = vec4(0.0);
    float sum = 0.0;
    if (weight.x > 0.0) {
        laid += weight.x * tileFactor(first, size, vec2(mm.y, -mm.z));
        sum += weight.x;
    }
    if (weight.y > 0.0) {
        laid += weight.y * tileFactor(first, size, vec2(mm.x, -mm.z));
        sum += weight.y;
    }
    if (weight.z > 0.0) {
        laid += weight.z * tileFactor(first, size, mm.xy);
        sum += weight.z;
    }
    return vec4(1.0) + (laid - vec4(1.0)) * (numberAt(entry + 3) * facts.trusted * sum);
}
