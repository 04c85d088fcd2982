// What layer @ makes of a sample: its transfer function, contours, transparency and colour.
uniform vec2 valueOfEntry@; // entry of the layer's table = the scene's * x + y
uniform int stepOpacity@;   // table: opacity of one step by value
uniform int slabTable@;     // pre-integration: slabs.glsl
uniform int opacity@;       // of the reference length; in two dimensions its rows one after the other
uniform int indexTable@;    // fractional node column of an entry
uniform int rowIndex@;      // fractional node row of a row
uniform int rowStride@;
uniform int rows@;
uniform ivec2 lastNode@;    // column, row
uniform ivec2 nodeStride@;
uniform int nodeColours@;   // of colours
uniform int entryColours@;  // of colours: plain colours by value
uniform int nodeSlots@;     // of numbers: a node's slot among the styles
uniform int nodeTextures@;  // of numbers: a node's texture
uniform int singleSlot@;
uniform int slotRows@;      // of numbers: a label slot's row, -1: none
uniform int slotShown@;     // of numbers: 1 where a label slot shows
uniform vec4 light@;        // ambient, diffuse, strength, exponent
uniform vec3 contour@;      // thickness mm, fixed width, mm between two normals
uniform float importanceOfLayer@;
#if CUT_@
uniform int cutTable@;
uniform int cutPlanes@;
uniform int cutColoured@;
Cut cut@() { return Cut(cutTable@, cutPlanes@, cutColoured@ != 0); }
#endif
#if FOCUS_@
uniform vec4 depthPlace@; // linear in the position
uniform vec2 focus@;      // place, strength
#endif

/// Where contours end, |n.v|; 0: there are none.
float contourWidth@(Facts facts) {
#if CONTOURS_@ == CONTOURS_FIXED
    return contour@.y * facts.trusted;
#elif CONTOURS_@ == CONTOURS_BEND
    return contourWidth(contour@.x * facts.depth * facts.bend);
#elif CONTOURS_@ == CONTOURS_NORMALS
    return contourWidth(contour@.x * facts.depth * turnOf(facts, contour@.z));
#else
    return 0.0;
#endif
}

/// What a contour's ink leaves of a plain colour.
float uninked@(Facts facts, float width) { return 1.0 - contourCoverage(abs(facts.facing), width); }

#if STYLE_@
SphereQuery sphereQuery@(Facts facts, float width) {
    vec2 place = facts.normal.xy;
#if PERSPECTIVE
    place -= facts.view.xy * ((facts.facing + facts.normal.z) / (1.0 + facts.view.z)); // in the frame of the ray
#endif
    float stretch = 1.0;
#if CONTOURS_@
    float radius = min(length(place), 1.0);
    float pushed = contourPush(radius, min(abs(facts.facing), 1.0), width);
    stretch = radius > 0.0 ? pushed / max(radius, 1e-20) : 1.0;
#endif
#if TWO_SIDED_@
    stretch = facts.facing < 0.0 ? -stretch : stretch;
#endif
    float level = 0.0;
#if MIP_LEVELS
    float curvature = 0.0;
#if CURVED_LEVELS_@
    curvature = voxelMm * facts.bend * uninked@(facts, width); // contours read the rim, however the surface turns
#endif
    level = min(mipLevel(radiusTexels, footprintVoxels * facts.depth, curvature), lastLevel);
#endif
    return SphereQuery(place * stretch, level, facts.trusted);
}
#endif

/// Phong's light over a plain colour, and the contours' ink.
vec3 shadePlain@(Facts facts, float width, vec3 plain) {
#if PHONG_@
#if TWO_SIDED_@
    float lit = min(abs(facts.facing), 1.0);
#else
    float lit = clamp(facts.facing, 0.0, 1.0);
#endif
    plain = min(plain * (light@.x + light@.y * lit) + light@.z * powc(lit, light@.w), vec3(1.0));
#endif
#if CONTOURS_@
    plain *= uninked@(facts, width);
#endif
    return plain;
}

/// The blend of the nodes around a place: fractional column and row.
vec4 blendNodes@(Facts facts, float width, vec2 at) {
    ivec2 low = ivec2(at);
    ivec2 high = min(low + 1, lastNode@);
    vec2 f = at - vec2(low);
#if STYLE_@
    SphereQuery query = sphereQuery@(facts, width);
    vec4 single = vec4(0.0);
#if SINGLE_@
    single = sphereColour(query, singleSlot@);
#if !TEXTURES_@
    return single;
#endif
#endif
#endif
    vec4 sum = vec4(0.0);
#if STYLE_@ && TEXTURES_@
    vec4 factors = vec4(0.0);
#endif
#if ROWS_@
    const int count = 4;
#else
    const int count = 2;
#endif
    for (int i = 0; i < count; ++i) {
        float weight = ((i & 1) != 0 ? f.x : 1.0 - f.x);
        int node = ((i & 1) != 0 ? high.x : low.x) * nodeStride@.x;
#if ROWS_@
        weight *= (i >> 1) != 0 ? f.y : 1.0 - f.y;
        node += ((i >> 1) != 0 ? high.y : low.y) * nodeStride@.y;
#endif
        if (weight > 0.0) {
#if STYLE_@
#if !SINGLE_@
            single = sphereColour(query, int(numberAt(nodeSlots@ + node)));
#endif
            sum += weight * single;
#if TEXTURES_@
            factors += weight * laidFactor(facts, nodeTextures@ + 4 * node);
#endif
#else
            sum += weight * colourAt(nodeColours@ + node);
#endif
        }
    }
#if STYLE_@ && TEXTURES_@
    sum.rgb = min(sum.rgb * factors.rgb, vec3(1.0));
#endif
    return sum;
}

vec4 colourOf@(Facts facts, float width, vec2 at) {
    vec4 colour = blendNodes@(facts, width, at);
#if !STYLE_@
    colour = vec4(shadePlain@(facts, width, colour.rgb), 1.0);
#endif
    return colour;
}

float transparency@(Facts facts, float width, float opacity, vec4 colour) {
#if DIRECTIONAL_@
    float directional = colour.a;
#else
    float directional = 1.0;
#endif
#if ILLUSTRATIVE_@
    return illustrativeOpacity(directional, opacity, min(abs(facts.facing), 1.0), width, facts.unitMagnitude);
#else
    return directional * opacity;
#endif
}

#if !BY_VALUE_@
uniform vec3 axisX@; // entry = raw * x + y, at most z
uniform vec3 axisY@;
uniform mat3 mmFromCellOfAxis@; // distance from a point
uniform vec3 axisFrom@;
#if STORED_AXIS_@
uniform sampler3D distanceField@;
uniform vec2 storedDistance@;
#endif

/// In entries of the layer's table.
float axisEntry@(Facts facts, int axis, vec3 scale) {
    float raw = facts.entry;
#if READS_SCALE
    if (axis == AXIS_GRADIENT) {
        raw = facts.unitMagnitude;
    }
    if (axis == AXIS_CURVATURE) {
        raw = facts.bend;
    }
#endif
    if (axis == AXIS_DISTANCE) {
#if STORED_AXIS_@
        raw = storedOf(distanceField@, storedDistance@, facts.q);
#else
        raw = length(mmFromCellOfAxis@ * (facts.q - axisFrom@));
#endif
    }
#if SECOND_VOLUME
    if (axis == AXIS_SECOND) {
        raw = storedOf(secondVolume, storedSecond, facts.q);
    }
#endif
#if AXIS_MEASURES
    if (axis == AXIS_IMPORTANCE) {
        raw = importanceSum1(measuresOf1(facts), 0.0);
    }
#endif
    return clamp(raw * scale.x + scale.y, 0.0, scale.z);
}

/// Opacity of the reference length at a place whose row is given (label axes) or found.
float row@(Facts facts, float width, float rowEntry, out vec4 colour) {
    float x = axisEntry@(facts, AXIS_X_@, axisX@);
    colour = vec4(0.0);
#if ROWS_@
#if LABEL_AXIS_@
    float y = rowEntry;
#else
    float y = axisEntry@(facts, AXIS_Y_@, axisY@);
#endif
    int low = int(y);
    int high = min(low + 1, rows@ - 1);
    float f = y - float(low);
    float opacity =
        mix(readTable(opacity@ + low * rowStride@, x), readTable(opacity@ + high * rowStride@, x), f);
    if (opacity <= 0.0) {
        return opacity;
    }
    float nodeRow = max(mix(numberAt(rowIndex@ + low), numberAt(rowIndex@ + high), f), 0.0);
    colour = colourOf@(facts, width, vec2(readTable(indexTable@, x), nodeRow));
#else
    float opacity = readTable(opacity@, x);
    if (opacity <= 0.0) {
        return opacity;
    }
    colour = colourOf@(facts, width, vec2(readTable(indexTable@, x), 0.0));
#endif
    return transparency@(facts, width, opacity, colour);
}

#if LABEL_AXIS_@
/// Each label around the sample is a row of the table; their parts add up by opacity, so that an invisible neighbour's
/// colour does not bleed.
float byLabels@(Facts facts, float width, out vec4 colour) {
    vec4 sum = vec4(0.0);
    float total = 0.0;
    for (int i = 0; i < 8; ++i) {
        float tableRow = numberAt(slotRows@ + memberSlot[i]);
        bool shown = tableRow >= 0.0;
#if SHOWN_@
        shown = shown && numberAt(slotShown@ + memberSlot[i]) > 0.0;
#endif
        if (shown && memberWeight[i] > 0.0) {
            vec4 part;
            float opacity = row@(facts, width, tableRow, part) * memberWeight[i];
            if (opacity > 0.0) {
                total += opacity;
                sum += opacity * part;
            }
        }
    }
    colour = sum / max(total, 1e-30);
    return min(total, 1.0);
}
#endif

float shownShare@() {
    float share = 1.0;
#if SHOWN_@ && !LABEL_AXIS_@
    share = 0.0;
    for (int i = 0; i < 8; ++i) {
        share += numberAt(slotShown@ + memberSlot[i]) * memberWeight[i];
    }
#endif
    return share;
}
#endif

/// Share of a step that a sample stands for in this layer.
float partOf@(Facts facts) {
#if CUT_@
    return facts.part * keptByCut(facts, cut@());
#else
    return facts.part;
#endif
}

/// The layer's own facts where its surface is not the field's own.
Facts moved@(Facts facts) {
#if FOCUS_@
    blur(facts, linearAt(depthPlace@, facts.q), focus@.x, focus@.y);
#if FACES
    facts.face = vec4(0.0); // blurred is what is inside
    layOntoFace(facts, figureFaces(), facts.face);
#endif
#endif
#if CUT_FACES_@
    layOntoFace(facts, cut@(), facts.ownFace);
#endif
    return facts;
}

#if BY_VALUE_@
/// Colour at an entry of the layer's table over the value.
vec4 colourByValue@(Facts facts, float entry) {
    float width = contourWidth@(facts);
#if STYLE_@
#if SINGLE_@ && !TEXTURES_@
    vec4 colour = colourOf@(facts, width, vec2(0.0));
#else
    vec4 colour = colourOf@(facts, width, vec2(readTable(indexTable@, entry), 0.0));
#endif
#else
    vec4 colour = vec4(shadePlain@(facts, width, readColours(entryColours@, entry).rgb), 1.0);
#endif
    applyParts@(facts, 1.0, colour);
    return colour;
}
#endif

/// What the sample covers of what is behind; `colour` is of no use where that is nothing.
float evaluate@(Facts shared_, out vec4 colour) {
    Facts facts = moved@(shared_);
    colour = vec4(0.0);
#if BY_VALUE_@
    float entry = facts.entry * valueOfEntry@.x + valueOfEntry@.y;
    // Parts go by the reference length: a long step's opacity is 1 but for rounding, and tells no depth.
    float opacity = facts.part >= 1.0 ? readTable(stepOpacity@, entry)
                                      : opacityOfLength(readTable(opacity@, entry), stepRatio * facts.part);
    if (opacity > 0.0) {
        colour = colourByValue@(facts, entry);
    }
#else
    float width = contourWidth@(facts);
#if LABEL_AXIS_@
    float opacity = byLabels@(facts, width, colour);
#else
    float opacity = row@(facts, width, 0.0, colour) * shownShare@();
#endif
    if (opacity > 0.0) {
        opacity = applyParts@(facts, opacity, colour);
    }
    float part = partOf@(facts);
    opacity = part > 0.0 ? opacityOfLength(opacity, stepRatio * part) : 0.0;
#endif
#if CUES
    colour.rgb = lightByCues(facts, colour.rgb);
#endif
    return opacity;
}
