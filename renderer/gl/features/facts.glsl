// What layers read at a sample.
uniform vec4 depthFromCell; // depth over the target's, linear in the position
uniform mat3 cellFromEye;   // 1 mm in eye space, in cells
uniform mat3 mmFromEye;     // turns a direction to patient coordinates
uniform float lastEntry;    // of the table over the value

struct Facts {
    vec3 q;    // position, cells
    vec3 view; // unit, eye space, towards the viewer
    float entry;
    float part;          // share of a step that the sample stands for
    vec3 normal;         // unit, eye space, out of dense matter; where some layer reads it; so are all that follow
    float facing;        // normal . view
    float magnitude;     // of the gradient, stored units per mm
    float trusted;       // 0: the normal means nothing, 1: it is sound
    float unitMagnitude; // of the gradient, over the one that counts as 1
    float bend;          // curvature along the view by the Hessian, 1/mm
    float depth;         // distance along the view over the target's
    bool moved;          // the surface is a cut's or blurred, no longer the field's own
    float planeShare;    // share of a cut's face
    vec4 face;           // colour of the figure's cut and its share
    vec4 ownFace;        // of the layer's own cut
};

float linearAt(vec4 fromCell, vec3 q) { return dot(fromCell.xyz, q) + fromCell.w; }

#if READS_NORMAL
void setNormal(inout Facts facts, vec3 gradientEye) {
    facts.magnitude = sqrt(dot(gradientEye, gradientEye));
    facts.normal = gradientEye * (-1.0 / max(facts.magnitude, 1e-18));
    facts.facing = dot(facts.normal, facts.view);
}

/// How far a normal is trusted: 0 at the gradient floor, 1 from twice of it on (numerics.md 2a).
float trustOf(float magnitude) {
    float t = clamp((magnitude - gradientFloor) / max(gradientFloor, 1e-30), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

void setScale(inout Facts facts) {
    facts.trusted = trustOf(facts.magnitude);
    facts.unitMagnitude = min(facts.magnitude * perGradientMax, 1.0);
}

/// Curvature along the view by two normals on the ray, `probe` mm apart; 0 where one of them means nothing.
float turnOf(Facts facts, float probe) {
    Facts other = facts;
    setNormal(other, eyeFromGradient * gradientAt(clamp(facts.q + probe * (cellFromEye * facts.view), vec3(0.0), lastCell)));
    Facts here = facts;
    if (facts.moved) {
        setNormal(here, eyeFromGradient * gradientAt(facts.q));
        here.trusted = trustOf(here.magnitude);
    }
    float both = here.trusted * trustOf(other.magnitude);
    float curvature = curvatureOfNormals(other.normal, here.normal, probe);
    return (both > 0.0 ? both * curvature : 0.0) * (1.0 - facts.planeShare);
}
#endif

#if LABELS
uniform usampler3D labels;
int memberSlot[8];
float memberWeight[8]; // 0: merged with an earlier one

/// Label slots around a place, merged, with their trilinear weights.
void findMembers(vec3 q) {
    vec3 cell = floor(q);
    vec3 f = q - cell;
    ivec3 low = ivec3(cell) - 1 - pageFirst;
    ivec3 last = ivec3(pageSize) - 1;
    for (int i = 0; i < 8; ++i) {
        ivec3 step = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 weight = mix(1.0 - f, f, vec3(step));
        memberSlot[i] = int(texelFetch(labels, clamp(low + step, ivec3(0), last), 0).r);
        memberWeight[i] = weight.x * weight.y * weight.z;
    }
    for (int i = 0; i < 7; ++i) {
        for (int j = i + 1; j < 8; ++j) {
            bool same = memberSlot[j] == memberSlot[i];
            memberWeight[i] += same ? memberWeight[j] : 0.0;
            memberWeight[j] = same ? 0.0 : memberWeight[j];
        }
    }
}
#endif

#if CUTS
uniform float cutPerVoxel; // 1 / mm

struct Cut {
    int table; // of colours: three entries for each plane: mm inside from cells, normal in eye space, colour
    int planes;
    bool coloured;
};

/// Where a sample lies in the face of a cut, its surface is the cut's.
void layOntoFace(inout Facts facts, Cut cut, inout vec4 face) {
    float inside = 1e30;
    int nearest = 0;
    for (int i = 0; i < cut.planes; ++i) {
        float here = linearAt(colourAt(cut.table + 3 * i), facts.q);
        nearest = here < inside ? i : nearest;
        inside = min(inside, here);
    }
    float share = cutFaceShare(inside * cutPerVoxel);
    if (share <= 0.0) {
        return;
    }
#if READS_NORMAL
    vec3 plane = colourAt(cut.table + 3 * nearest + 1).xyz;
    vec3 n = facts.trusted * (1.0 - share) * facts.normal + share * plane;
    float size = sqrt(dot(n, n));
    facts.normal = size > 1e-6 ? n / size : plane;
    facts.facing = dot(facts.normal, facts.view);
    facts.trusted = mix(facts.trusted, 1.0, share);
    facts.bend *= 1.0 - share;
    facts.planeShare = max(facts.planeShare, share);
    facts.moved = true;
#endif
    if (cut.coloured) {
        face = vec4(colourAt(cut.table + 3 * nearest + 2).rgb, share);
    }
}

/// Share of a sample's length that a cut leaves, by the plane that leaves least.
float keptByCut(Facts facts, Cut cut) {
    float kept = 1.0;
    for (int i = 0; i < cut.planes; ++i) {
        vec3 normal = colourAt(cut.table + 3 * i + 1).xyz;
        float reach = abs(dot(normal, facts.view)) * facts.part * stepMm;
        kept = min(kept, keptByPlane(linearAt(colourAt(cut.table + 3 * i), facts.q), reach));
    }
    return kept;
}
#endif

#if FACES
uniform int faceTable;
uniform int facePlanes;
uniform int facesColoured;
Cut figureFaces() { return Cut(faceTable, facePlanes, facesColoured != 0); }
#endif

/// Measures what the layers read, and nothing else.
Facts measure(vec3 q, vec3 view, float entry, float part) {
    Facts facts = Facts(q, view, entry, part, vec3(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, false, 0.0, vec4(0.0), vec4(0.0));
#if READS_NORMAL
    setNormal(facts, eyeFromGradient * gradientAt(q));
#if READS_SCALE
    setScale(facts);
#if BEND
    facts.bend = facts.trusted > 0.0 ? facts.trusted * bendAt(q, view) : 0.0;
#endif
    facts.depth = linearAt(depthFromCell, q);
#endif
#endif
#if LABELS
    findMembers(q);
#endif
#if FACES
    layOntoFace(facts, figureFaces(), facts.face);
#endif
    return facts;
}

#if BLURS
// Blurred copies of the scan for depth of field.
uniform sampler3D blurs[3];
uniform vec2 storedBlur;
uniform vec2 entryOfBlur[3]; // table entry = stored * x + y
uniform mat3 eyeFromBlur[3];

vec4 cellOf(sampler3D volume, vec3 q) { // slope per cell, value
    vec3 cell = floor(q);
    vec3 f = q - cell;
    ivec3 low = ivec3(cell) - 1 - pageFirst;
    ivec3 last = ivec3(pageSize) - 1;
    vec4 near, far; // ends of the four edges along x, y fastest
    for (int i = 0; i < 4; ++i) {
        ivec3 at = low + ivec3(0, i & 1, i >> 1);
        near[i] = texelFetch(volume, clamp(at, ivec3(0), last), 0).r * storedBlur.x + storedBlur.y;
        far[i] = texelFetch(volume, clamp(at + ivec3(1, 0, 0), ivec3(0), last), 0).r * storedBlur.x + storedBlur.y;
    }
    vec4 edge = mix(near, far, f.x);
    float a = mix(mix(near.x, near.y, f.y), mix(near.z, near.w, f.y), f.z);
    float b = mix(mix(far.x, far.y, f.y), mix(far.z, far.w, f.y), f.z);
    return vec4(b - a, mix(edge.y - edge.x, edge.w - edge.z, f.z), mix(edge.z - edge.x, edge.w - edge.y, f.y),
                mix(a, b, f.x));
}

/// Moves value and surface to the blur of a layer's depth of field.
void blur(inout Facts facts, float depthPlace, float focus, float strength) {
    float level = blurLevel(clamp(depthPlace, 0.0, 1.0), focus, strength);
    float sharp = max(1.0 - abs(level), 0.0);
    float entry = sharp * facts.entry;
#if READS_NORMAL
    Facts own = facts;
    if (facts.moved) { // not a cut's
        setNormal(own, eyeFromGradient * gradientAt(facts.q));
    }
    vec3 g = -sharp * own.magnitude * own.normal;
#endif
    for (int k = 0; k < 3; ++k) {
        float weight = max(1.0 - abs(level - float(k + 1)), 0.0);
        vec4 copy = k == 0 ? cellOf(blurs[0], facts.q) : k == 1 ? cellOf(blurs[1], facts.q) : cellOf(blurs[2], facts.q);
        entry += weight * (copy.w * entryOfBlur[k].x + entryOfBlur[k].y);
#if READS_NORMAL
        g += weight * (eyeFromBlur[k] * vec3(slopeOfCopy(copy.x), slopeOfCopy(copy.y), slopeOfCopy(copy.z)));
#endif
    }
    facts.entry = clamp(entry, 0.0, lastEntry);
#if READS_NORMAL
    facts.moved = true;
    setNormal(facts, g);
    setScale(facts);
#endif
}
#endif
