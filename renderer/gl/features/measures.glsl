// How important a sample is (paper 001): the measures that all layers of a sample share. Only those with a weight are
// in the program. Instance 0: of composition, 1: of transfer functions' axis "importance".
uniform float intensityWeight@;
uniform vec2 intensityOfEntry@; // the measure = entry * x + y
uniform float gradientWeight@;
uniform float silhouetteWeight@;
uniform vec3 silhouetteTerms@; // exponent, and the edges of the step
uniform float lightingWeight@;
uniform vec3 importanceLight@; // eye space, unit
uniform ivec3 lightingExponents@;
uniform float objectWeight@;
uniform int objectTable@; // of numbers: weight of a label slot
uniform float extinctionWeight@;
#if M_STATISTICS_@
uniform sampler3D statistics@;
uniform vec2 storedStatistics@; // times the measure's weight
#endif

struct Measures@ {
    float sum;
    float silhouette;
};

#if M_LIGHTING_@
float lightingOf@(Facts facts) {
    float side = facts.facing < 0.0 ? -1.0 : 1.0; // two-sided
    vec3 half_ = halfwayDirection(importanceLight@, facts.view);
    return lightingImportance(side * dot(facts.normal, half_), side * dot(facts.normal, importanceLight@),
                              facts.unitMagnitude, lightingExponents@);
}
#endif

Measures@ measuresOf@(Facts facts) {
    Measures@ found = Measures@(0.0, 0.0);
#if M_INTENSITY_@
    found.sum += intensityWeight@ * intensityImportance(facts.entry * intensityOfEntry@.x + intensityOfEntry@.y);
#endif
#if M_GRADIENT_@
    found.sum += gradientWeight@ * facts.unitMagnitude;
#endif
#if M_SILHOUETTE_@
    found.silhouette = silhouetteness(facts.unitMagnitude, abs(facts.facing), silhouetteTerms@);
    found.sum += silhouetteWeight@ * found.silhouette;
#endif
#if M_LIGHTING_@
    found.sum += lightingWeight@ * lightingOf@(facts);
#endif
#if M_OBJECT_@
    float objects = 0.0;
    for (int i = 0; i < 8; ++i) {
        objects += numberAt(objectTable@ + memberSlot[i]) * memberWeight[i];
    }
    found.sum += objectWeight@ * objects;
#endif
#if M_STATISTICS_@
    found.sum += storedOf(statistics@, storedStatistics@, facts.q);
#endif
    return found;
}

/// Weighted sum for a layer, but unocclusion.
float importanceSum@(Measures@ measures, float extinction) {
#if M_EXTINCTION_@
    return measures.sum + extinctionWeight@ * extinctionImportance(extinction);
#else
    return measures.sum;
#endif
}
