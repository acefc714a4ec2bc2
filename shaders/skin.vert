// skin.vert -- the skin under the fur, one vertex per source vertex.
//
// Programs with OVERLAY show one, those with TEXTURED have a base-color texture.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "segment_color.glsl"

layout(location = 0) in vec2 cornerUv;  // members of a Corner
layout(location = 1) in vec4 cornerColor;
layout(location = 2) in uint skinVertex;
layout(location = 0) uniform uint material;  // of the part that is drawn
out vec3 shade;  // color of the vertex times the light that reaches it through the coat
#ifdef TEXTURED
out vec2 uv;
#endif
#ifdef OVERLAY
layout(std430, binding = 6) readonly buffer Mask { float mask[]; };
layout(std430, binding = 13) readonly buffer SegmentOf { uint segmentOf[]; };
out float field;  // value of the overlay
#endif

void main() {
    SkinVertex v = skinVertices[skinVertex];
    vec3 n = v.normal;
    if (dot(n, toEye(v.position)) < 0.0) n = -n;  // open meshes are seen from inside too
    vec3 color = materials[material].color * cornerColor.rgb;
    float depth = 0.0;
#ifdef OVERLAY
    FurVertex f = furVertices[skinVertex];
    if (frame.overlay == kOverlaySegment) color = segmentColor(segmentOf[skinVertex]);
    if (heated()) color = vec3(1.0);
    field = frame.overlay == 1u   ? f.furLength
            : frame.overlay == 2u ? f.density
            : frame.overlay == 4u ? mask[skinVertex]
                                  : 0.0;
#else
    depth = depthInCoat(fur, frame.hairsPerArea * furVertices[skinVertex].density,
                        furVertices[skinVertex].furLength, frame.overWidth, frame.underWidth, 0u,
                        0.0);
#endif
    shade = skinRadiance(frame.light, fur.under, color, n, depth);
#ifdef TEXTURED
    uv = cornerUv;
#endif
    gl_Position = frame.viewProjection * vec4(v.position, 1.0);
}
