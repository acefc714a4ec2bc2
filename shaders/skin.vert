// skin.vert -- the skin under the fur, one vertex per source vertex.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"

layout(std430, binding = 6) readonly buffer Mask { float mask[]; };

out vec3 normal;
out vec2 uv;
out vec3 vertexColor;
out vec3 position;
out float depth;   // optical depth of the coat above
out float field;   // value of the overlay

void main() {
    Corner corner = corners[gl_VertexID];
    SkinVertex v = skinVertices[corner.skinVertex];
    FurVertex f = furVertices[corner.skinVertex];
    position = v.position;
    normal = v.normal;
    uv = corner.uv;
    vertexColor = unpackUnorm4x8(corner.color).rgb;
    depth = depthInCoat(fur, frame.hairsPerArea * f.density, f.furLength, frame.overWidth,
                        frame.underWidth, 0u, 0.0);
    field = frame.overlay == 1u   ? f.furLength
            : frame.overlay == 2u ? f.density
            : frame.overlay == 3u ? length(f.direction)
            : frame.overlay == 4u ? mask[corner.skinVertex]
                                  : 0.0;
    gl_Position = frame.viewProjection * vec4(v.position, 1.0);
}
