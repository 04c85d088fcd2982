/// A sample that can be seen.
struct Sample {
    float s; // where on the ray; of a slab: its front
    float entry;
    float part;
    float back; // entry at a slab's back
};

vec3 positionAt(Ray ray, float s) { return min(ray.start + ray.step * s, lastCell); }

/// All layers of one sample, one behind the other.
void addSample(inout Pixel pixel, Ray ray, Sample found) {
#if !SLABS
    Facts facts = measure(positionAt(ray, found.s), ray.view, found.entry, found.part);
#endif
#if IMPORTANCE
    Measures0 measures = measuresOf0(facts);
    float dark = 1.0;
#if M_SILHOUETTE_0
    dark = preciseExp(-darkening * min(weightHere() * actsPerWeight, 1.0) * measures.silhouette);
#endif
#endif
    vec4 colour;
    float opacity;
