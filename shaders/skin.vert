// skin.vert -- the skin under the fur, one vertex per source vertex.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "segment_color.glsl"

layout(std430, binding = 6) readonly buffer Mask { float mask[]; };
layout(std430, binding = 13) readonly buffer SegmentOf { uint segmentOf[]; };

out vec2 uv;
out vec3 shade;    // color of the vertex times the light that reaches it through the coat
out float field;   // value of the overlay
flat out float layer;
layout(location = 0) uniform uint material;  // of the part that is drawn

void main() {
    Corner corner = corners[gl_VertexID];
    SkinVertex v = skinVertices[corner.skinVertex];
    FurVertex f = furVertices[corner.skinVertex];
    uv = corner.uv;
    vec3 n = v.normal;
    if (dot(n, toEye(v.position)) < 0.0) n = -n;  // open meshes are seen from inside too
    float depth = frame.overlay != 0u
                      ? 0.0
                      : depthInCoat(fur, frame.hairsPerArea * f.density, f.furLength,
                                    frame.overWidth, frame.underWidth, 0u, 0.0);
    Material m = materials[material];
    bool segments = frame.overlay == kOverlaySegment;
    layer = segments ? -1.0 : m.layer;
    vec3 color = segments   ? segmentColor(segmentOf[corner.skinVertex])
                 : heated() ? vec3(1.0)
                            : m.color * unpackUnorm4x8(corner.color).rgb;
    shade = skinRadiance(frame.light, fur.under, color, n, depth);
    field = frame.overlay == 1u   ? f.furLength
            : frame.overlay == 2u ? f.density
            : frame.overlay == 3u ? length(f.direction)
            : frame.overlay == 4u ? mask[corner.skinVertex]
                                  : 0.0;
    gl_Position = frame.viewProjection * vec4(v.position, 1.0);
}
