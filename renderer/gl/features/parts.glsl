// Layer @'s parts beside its transfer function (paper 003; core/optics/layers.h).
#if PARTS_@
uniform float lastRampEntry@;
uniform vec3 partLight@; // eye space, unit
#if TONE_@
uniform int toneTable@; // of colours
#endif
#if POSITION_@
uniform int positionTable@; // of colours
uniform vec4 placeOnRamp@;  // linear in the position
#endif
#if GRADIENT_OPACITY_@
uniform int gradientOpacity@;
#endif
#if LINE_OPACITY_@
uniform int lineOpacity@;
#endif
#if SILHOUETTE_@
uniform vec3 silhouette@; // opacity, |n.v| of the full line, and of none
uniform vec3 silhouetteRgb@;
#endif
#if SPECULAR_@
uniform vec2 specular@; // strength, exponent
#endif

float rampEntry@(float place) { return clamp(place, 0.0, 1.0) * lastRampEntry@; }

/// Turned to the viewer where both sides are drawn alike.
float towards@(Facts facts, float v) {
#if TWO_SIDED_@
    return facts.facing < 0.0 ? -v : v;
#else
    return v;
#endif
}

float toLight@(Facts facts) { return towards@(facts, dot(facts.normal, partLight@)); }

#if SPECULAR_@
float highlight@(Facts facts) {
#if OWN_LIGHT_@
    float normalToLight = toLight@(facts);
    float lightToViewer = dot(facts.view, partLight@);
#else
#if TWO_SIDED_@
    float normalToLight = abs(facts.facing);
#else
    float normalToLight = facts.facing;
#endif
    float lightToViewer = 1.0;
#endif
    float cosine = halfway(normalToLight, towards@(facts, facts.facing), lightToViewer);
    return powc(cosine, specular@.y) * facts.trusted * specular@.x;
}
#endif
#endif

/// Changes the colour, and gives the opacity of the reference length with the parts.
float applyParts@(Facts facts, float opacity, inout vec4 colour) {
#if CUTS
    colour.rgb = mix(colour.rgb, facts.face.rgb, facts.face.a);
    colour.rgb = mix(colour.rgb, facts.ownFace.rgb, facts.ownFace.a);
#endif
#if PARTS_@
#if TONE_@
    colour *= readColours(toneTable@, rampEntry@(tonePlace(toLight@(facts), facts.trusted)));
#endif
    float fade = 1.0;
#if POSITION_@
    vec4 tint = readColours(positionTable@, rampEntry@(linearAt(placeOnRamp@, facts.q)));
    fade = tint.a;
#endif
    float lineMap = 1.0;
#if LINE_OPACITY_@
    lineMap = readTable(lineOpacity@, rampEntry@(facts.unitMagnitude));
#endif
    float shading = opacity * fade;
#if GRADIENT_OPACITY_@
    shading *= readTable(gradientOpacity@, rampEntry@(facts.unitMagnitude));
#endif
    shading = min(shading, 1.0);
    float all = shading;
#if SILHOUETTE_@
    float outline = silhouetteShare(facts.facing, silhouette@.y, silhouette@.z, facts.trusted);
    float line = min(opacity * lineMap * fade * silhouette@.x * outline, 1.0);
    colour.rgb = mix(colour.rgb, silhouetteRgb@, lineShare(shading, line));
    all = withLine(shading, line);
#endif
#if SPECULAR_@
    colour.rgb += lineMap * highlight@(facts);
#endif
#if POSITION_@
    colour *= tint;
#endif
    colour = min(colour, vec4(1.0));
    return all;
#else
    return opacity;
#endif
}
