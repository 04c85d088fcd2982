flat in vec4 placed;
flat in float radius;

layout(location = 0) out vec4 listed;
layout(location = 1) out vec4 listedRadius;

void main() {
    listed = placed;
    listedRadius = vec4(radius);
}
