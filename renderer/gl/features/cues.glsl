// Depth cues over the layers' colours: fields on coarse cells (paper 003; core/optics/layers.h).
#if CUE_AMBIENT
uniform sampler3D cueAmbient;
uniform vec3 ambientSize; // cells
uniform vec3 ambientCell; // cell = q * x + y; read z mm out of the surface
uniform float ambientStrength;
#endif
#if CUE_SHADOW
uniform sampler3D cueShadow;
uniform vec3 shadowSize;
uniform vec3 shadowCell;
uniform float shadowStrength;
uniform vec3 shadowLight; // eye space, unit
#endif
#if CUE_HALO
uniform sampler3D cueHalo;
uniform vec3 haloSize;
uniform vec3 haloCell;
uniform float haloStrength;
uniform vec3 haloRgb;
#endif

vec4 cueAt(sampler3D cue, vec3 size, vec3 cell, vec3 q) {
    return textureLod(cue, (q * cell.x + cell.y + 0.5) / size, 0.0);
}

vec3 outside(Facts facts, float mm) { return facts.q + facts.trusted * mm * (cellFromEye * facts.normal); }

/// What the cues make of a layer's colour at a sample.
vec3 lightByCues(Facts facts, vec3 colour) {
    float lit = 1.0;
#if CUE_AMBIENT
    vec4 found = cueAt(cueAmbient, ambientSize, ambientCell, outside(facts, ambientCell.z));
    float along = dot(mmFromEye * facts.normal, found.yzw);
    lit -= ambientStrength * ambientOcclusion(found.x, along, facts.trusted);
#endif
#if CUE_SHADOW
    float occlusion = cueAt(cueShadow, shadowSize, shadowCell, outside(facts, shadowCell.z)).x;
    lit *= 1.0 - shadowStrength * shadowed(occlusion, dot(facts.normal, shadowLight), facts.trusted);
#endif
#if CUE_HALO
    float halo = haloStrength * cueAt(cueHalo, haloSize, haloCell, facts.q).x;
    return colour * (lit * (1.0 - halo)) + haloRgb * halo;
#else
    return colour * lit;
#endif
}
