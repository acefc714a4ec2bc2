// frame.glsl -- what every pass of a frame reads: the view, the fur, the buffers of the document.
#include "types.glsl"

layout(std140, binding = 0) uniform FrameBlock {
    mat4 viewProjection;   // world to clip, shifted by the sample's sub-pixel offset
    vec3 eye;              // world
    float pixelsPerMetre;  // perspective: at distance 1 from the eye; orthographic: everywhere
    vec3 forward;          // unit
    float perspective;     // 1, or 0 for orthographic
    Light light;
    vec2 overlayRange;     // values shown as the coldest and the hottest color
    uint overlay;          // enum Overlay
    uint segments;         // of a polyline; at most, if they adapt
    ivec2 size;            // pixels
    float overWidth;       // m, width of overcoat hair at the root
    float underWidth;
    float hairsPerArea;    // 1/m^2 at density 1
    uint coats;            // bit 0: draw the overcoat, bit 1: the undercoat
    uint textured;         // 1 if corners carry texture coordinates or colors
    uint adapts;           // 1: polylines have the segments that the tolerance needs
    float seconds;         // how long the wind has blown
    float tolerance;       // pixels by which the chords of a curve may miss it
    uint sides;            // of a tube; 0 = as many as it needs
} frame;

layout(std140, binding = 1) uniform FurBlock { Fur fur; };

struct Corner {  // one per source vertex
    vec2 uv;
    uint color;  // RGBA8, linear
    uint skinVertex;
};

struct Material {
    vec3 color;   // linear RGB factor
    float layer;  // of the texture array, -1 = none
};

layout(std430, binding = 0) readonly buffer SkinVertices { SkinVertex skinVertices[]; };
layout(std430, binding = 1) readonly buffer FurVertices { FurVertex furVertices[]; };
layout(std430, binding = 2) readonly buffer Triangles { uvec4 triangles[]; };  // corners, material
layout(std430, binding = 3) readonly buffer SourceTriangles { uint sourceTriangles[]; };
layout(std430, binding = 4) readonly buffer Corners { Corner corners[]; };
layout(std430, binding = 5) readonly buffer Materials { Material materials[]; };
layout(binding = 0) uniform sampler2DArray baseColors;

vec3 toEye(vec3 position) {
    return frame.perspective > 0.0 ? normalize(frame.eye - position) : -frame.forward;
}

// Pixels that a metre is wide there.
float pixelsPerMetreAt(vec3 place) {
    return frame.perspective > 0.0
               ? frame.pixelsPerMetre / max(dot(place - frame.eye, frame.forward), 1e-6)
               : frame.pixelsPerMetre;
}

// Depth in the window.
float windowDepth(vec3 place) {
    vec4 clip = frame.viewProjection * vec4(place, 1.0);
    return clamp(0.5 + 0.5 * clip.z / clip.w, 0.0, 1.0);
}

// Base color of a material at a texture coordinate.
vec3 materialColor(uint material, vec2 uv) {
    Material m = materials[material];
    vec3 color = m.color;
    if (m.layer >= 0.0) color *= textureLod(baseColors, vec3(uv, m.layer), 0.0).rgb;
    return color;
}

const uint kOverlaySegment = 5u;  // of enum Overlay

// True where the overlay is a value in heat colors.
bool heated() { return frame.overlay == 1u || frame.overlay == 2u || frame.overlay == 4u; }

// Heat colors from cold (dark blue) over green to hot (red), for the overlays; linear RGB.
vec3 heat(float value) {
    float x = clamp((value - frame.overlayRange.x) /
                    max(frame.overlayRange.y - frame.overlayRange.x, 1e-20), 0.0, 1.0);
    vec3 c = clamp(vec3(1.5) - abs(4.0 * x - vec3(3.0, 2.0, 1.0)), 0.0, 1.0);
    return c * c;
}
