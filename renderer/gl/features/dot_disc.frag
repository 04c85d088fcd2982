// The depth of a disc at a cell of the paper: the blending keeps the largest.
uniform float discMm;

flat in vec3 normalSeen;
flat in vec4 disc;

layout(location = 0) out vec4 nearest;

void main() {
    vec2 d = (gl_FragCoord.xy - disc.xy) * disc.w; // mm of the volume, y down
    float rise = -(normalSeen.x * d.x - normalSeen.y * d.y) / max(normalSeen.z, 0.05);
    if (normalSeen.z < 0.0) {
        rise = (normalSeen.x * d.x - normalSeen.y * d.y) / max(-normalSeen.z, 0.05);
    }
    if (d.x * d.x + d.y * d.y + rise * rise > discMm * discMm) {
        discard;
    }
    nearest = vec4(disc.z + rise);
}
