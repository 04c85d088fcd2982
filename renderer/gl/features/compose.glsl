// Composition: one sample's layers into the pixel, the ordinary way or by importance (paper 001).
uniform float opaque; // a ray ends at this opacity

struct Pixel {
    vec4 rgba;         // ordinary: premultiplied; by importance: not until it is finished
    float exponential; // e^I
    float depth;       // optical
    bool done;         // nothing that follows can change it
};

Pixel beginPixel() { return Pixel(vec4(0.0), 1.0, 0.0, false); }

Pixel resumePixel(vec4 rgba, vec2 state) {
    bool done = state.y < 0.0;
    return Pixel(rgba, state.x, done ? -1.0 - state.y : state.y, done);
}

vec2 stateOf(Pixel pixel) { return vec2(pixel.exponential, pixel.done ? -1.0 - pixel.depth : pixel.depth); }

#if IMPORTANCE
uniform float globalWeight;
#if LENSES
uniform sampler2D weights; // global weight of every sub-pixel
#endif
uniform float importanceLimit;
uniform float backgroundImportance;
uniform float noiseFloor;
uniform float darkening;
uniform float actsPerWeight;
uniform float unocclusionWeight;
uniform float layerMost;     // greatest weight of a layer
uniform vec4 slabOfCell;     // slab of depth, linear in the position
uniform float ahead[64];     // for each slab the greatest sum of measures in it and behind

float weightHere() {
#if LENSES
    return texelFetch(weights, ivec2(gl_FragCoord.xy), 0).r;
#else
    return globalWeight;
#endif
}

const float kGreatestOfAll = 64.0;

float backgroundOf(float weight) { return min(weight * backgroundImportance, kGreatestOfAll); }

/// One layer's part of a sample. `part`: of a step in that layer.
void composeLayer(inout Pixel pixel, Facts facts, vec3 colour, float opacity, float part, float sharedSum,
                  float extinctionTerm, float ofLayer) {
    float depth = opticalDepth(opacity);
    float extinction = depth / (stepRatio * max(part, 1e-6));
    float gate = importanceOfVisible(1.0, extinction, noiseFloor);
    float sum = sharedSum + extinctionTerm * extinctionImportance(extinction);
    float weight = weightHere();
#if UNOCCLUSION
    float total = min(weight * ofLayer * (sum + unocclusionWeight * unocclusionImportance(pixel.depth)), importanceLimit);
#else
    float total = min(totalImportance(weight * ofLayer, sum), importanceLimit);
#endif
    float kept = keptBehind(pixel.rgba.a, pixel.exponential, opacity, preciseExp(total * gate));
    pixel.rgba.rgb = mix(colour, pixel.rgba.rgb, kept);
    pixel.depth += min(depth, 1e6);
}

/// Ends a pixel where no more than the picture's tolerance can change behind a sample.
void endWhereCertain(inout Pixel pixel, vec3 q) {
    float weight = weightHere();
    int slab = int(clamp(linearAt(slabOfCell, q), 0.0, 63.0));
    float most = ahead[slab];
#if UNOCCLUSION
    most += unocclusionWeight * unocclusionImportance(pixel.depth) * layerMost;
#endif
    float greatest = min(max(min(weight * most, importanceLimit), backgroundOf(weight)), kGreatestOfAll);
    pixel.done = pixel.rgba.a * min(1.0, pixel.exponential * preciseExp(-greatest)) >= opaque;
}

bool isDone(Pixel pixel) { return pixel.done; }

/// Premultiplied, the background's importance counted.
vec4 finished(Pixel pixel) {
    float alpha = min(pixel.rgba.a, pixel.exponential * preciseExp(-backgroundOf(weightHere())));
    return vec4(pixel.rgba.rgb * alpha, alpha);
}
#else
bool isDone(Pixel pixel) { return pixel.rgba.a >= opaque; }
vec4 finished(Pixel pixel) { return pixel.rgba; }

void composeLayer(inout Pixel pixel, vec3 colour, float opacity) {
    // What the opacity takes in: near 1 it stands still, and thousands of colours would go on adding up.
    precise float covered = pixel.rgba.a + (1.0 - pixel.rgba.a) * opacity;
    precise float weight = covered - pixel.rgba.a;
    pixel.rgba = vec4(pixel.rgba.rgb + weight * colour, covered);
}
#endif
