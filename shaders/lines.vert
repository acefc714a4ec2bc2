// lines.vert -- overlay lines: cursor rings, arrows. Two rows of the buffer a vertex.
layout(std430, binding = 11) readonly buffer Lines { vec4 rows[]; };  // position, color
layout(location = 0) uniform mat4 viewProjection;
out vec4 lineColor;

void main() {
    lineColor = rows[2 * gl_VertexID + 1];
    gl_Position = viewProjection * vec4(rows[2 * gl_VertexID].xyz, 1.0);
}
