/// A sample that can be seen.
struct Sample {
    vec3 q;
    float entry;
    float part;
};

/// All layers of one sample, one behind the other.
void addSample(inout Pixel pixel, Ray ray, Sample found) {
    Facts facts = measure(found.q, ray.view, found.entry, found.part);
#if IMPORTANCE
    Measures0 measures = measuresOf0(facts);
    float dark = 1.0;
#if M_SILHOUETTE_0
    dark = preciseExp(-darkening * min(weightHere() * actsPerWeight, 1.0) * measures.silhouette);
#endif
#endif
    vec4 colour;
    float opacity;
