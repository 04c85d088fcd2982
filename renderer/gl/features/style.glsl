// Lit spheres: the colour of a normal (spec style-transfer-functions.md 1 and 7).
uniform sampler2DArray styles;
uniform int styleMeans; // of colours
#if MIP_LEVELS
uniform float lastLevel;
uniform float radiusTexels;
uniform float footprintVoxels;
uniform float voxelMm;
#endif

/// What a sample asks of every sphere.
struct SphereQuery {
    vec2 place; // on the disk, y up
    float level;
    float trusted;
};

/// Where a normal means little, a style shows its mean.
vec4 sphereColour(SphereQuery query, int slot) {
    vec2 at = vec2(0.5 + 0.5 * query.place.x, 0.5 - 0.5 * query.place.y);
    vec4 colour = textureLod(styles, vec3(at, float(slot)), query.level);
    return mix(colourAt(styleMeans + slot), colour, query.trusted);
}
