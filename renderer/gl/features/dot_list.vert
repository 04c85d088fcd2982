// A candidate as a pixel of a list.
uniform vec2 listSize;

flat out vec4 placed;
flat out float radius;

void main() {
    PlacedDot dot_ = placedDot();
    placed = vec4(dot_.mm, dot_.depth, dot_.opacity);
    radius = dot_.radius;
    vec2 pixel = vec2(texelOfVoxel(gl_VertexID)) + 0.5;
    gl_PointSize = 1.0;
    gl_Position = vec4(pixel / listSize * 2.0 - 1.0, 0.0, 1.0);
}
