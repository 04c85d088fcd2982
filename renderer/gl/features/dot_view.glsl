// How the figure's paper shows a place of the volume, as renderer/marks/mark_view.h has it. Places that are "seen": mm
// from the target to the right, up and towards the viewer.
uniform vec2 paperMm;
uniform float paperScale;     // mm on paper per mm of the volume in the target plane
uniform float perEyeDistance; // 0: parallel rays
uniform mat3 viewAxes;        // seen = viewAxes * (mm from the volume's middle) + viewMiddle
uniform vec3 viewMiddle;

/// mm on paper per mm of the volume; 0 behind the eye.
float scaleAt(vec3 seen) {
    float w = 1.0 - seen.z * perEyeDistance;
    return w > 0.0 ? paperScale / w : 0.0;
}

/// mm from the paper's top left corner.
vec2 onPaper(vec3 seen, float scale) { return 0.5 * paperMm + scale * vec2(seen.x, -seen.y); }

vec3 towardsEye(vec3 seen) {
    return perEyeDistance > 0.0 ? normalize(vec3(0.0, 0.0, 1.0 / perEyeDistance) - seen) : vec3(0.0, 0.0, 1.0);
}

#if CUTS > 0
uniform vec4 cuts[CUTS]; // beyond w along xyz everything is cut away
#endif

bool isCut(vec3 seen) {
#if CUTS > 0
    for (int i = 0; i < CUTS; ++i) {
        if (dot(cuts[i].xyz, seen) > cuts[i].w) {
            return true;
        }
    }
#endif
    return false;
}

// The voxels that draw, row by row.
uniform sampler2D voxelPlaces;   // mm from the volume's middle; v
uniform sampler2D voxelNormals;  // unit; gradient
uniform sampler2D voxelSurfaces; // share, mm along the normal to the surface, cells along the axis to it, that axis

ivec2 texelOfVoxel(int voxel) { return ivec2(voxel % kAcross, voxel / kAcross); }
