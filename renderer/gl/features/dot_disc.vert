// A voxel's disc of matter, for what lies behind it.
uniform float least; // v of matter that hides
uniform float discMm;
uniform float cellMm;
uniform vec2 cells;  // of the paper
uniform float guard; // cells around it that points may have their middle in

flat out vec3 normalSeen;
flat out vec4 disc; // middle (cells), depth, mm of the volume to a cell

void main() {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // nowhere
    gl_PointSize = 1.0;
    normalSeen = vec3(0.0);
    disc = vec4(0.0);
    ivec2 at = texelOfVoxel(gl_VertexID);
    vec4 place = texelFetch(voxelPlaces, at, 0);
    vec3 normal = texelFetch(voxelNormals, at, 0).xyz;
    vec4 surface = texelFetch(voxelSurfaces, at, 0);
    normalSeen = viewAxes * normal;
    bool towards = dot(normalSeen, towardsEye(viewAxes * place.xyz + viewMiddle)) > 0.0;
    vec3 seen = viewAxes * (place.xyz + normal * surface.y) + viewMiddle;
    float scale = scaleAt(seen);
    if (!(place.w >= least && surface.x > 0.0 && towards && scale > 0.0) || isCut(seen)) {
        return;
    }
    disc = vec4(onPaper(seen, scale) / cellMm, seen.z, cellMm / scale);
    gl_PointSize = 2.0 * ceil(discMm / disc.w) + 1.0;
    gl_Position = vec4((disc.xy + guard) / (cells + 2.0 * guard) * 2.0 - 1.0, 0.0, 1.0);
}
