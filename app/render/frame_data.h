// frame_data.h -- the uniform block of shaders/frame.glsl, as C++.
#pragma once

#include "core/types.h"

namespace pelage {

struct FrameData {
    mat4 viewProjection{1.0f};
    vec3 eye{0.0f};
    float pixelsPerMetre = 0.0f;
    vec3 forward{0.0f};
    float perspective = 1.0f;
    Light light{};
    vec2 overlayRange{0.0f, 1.0f};
    uint overlay = 0;
    uint segments = 8;
    ivec2 size{0};
    float overWidth = 0.0f;
    float underWidth = 0.0f;
    float hairsPerArea = 0.0f;
    uint coats = 3;
    uint textured = 0;
    uint adapts = 0;
    float seconds = 0.0f;
    float tolerance = 0.3f;
    uint sides = 0;
    uint pad = 0;
};
static_assert(sizeof(FrameData) == 64 + 16 + 16 + 48 + 16 + 16 + 16 + 16);

// Where each buffer and texture is bound: the numbers in shaders/*.
namespace binding {
enum Uniform : unsigned { frame = 0, fur = 1, shells = 2, shellMap = 3 };
enum Storage : unsigned {
    skinVertices = 0,
    furVertices = 1,
    triangles = 2,
    sourceTriangles = 3,
    corners = 4,
    materials = 5,
    mask = 6,
    roots = 7,
    keys = 8,
    shellVertices = 8,  // never with keys
    runs = 9,
    bends = 9,  // never with runs
    counters = 10,
    restVertices = 10,  // never with counters
    lines = 11,
    seen = 11,          // never with lines
    shellCorners = 11,  // never with seen
    groups = 12,
    fins = 12,  // never with groups
    segmentOf = 13,
    strips = 14,
    edges = 14,  // never with strips
    rodTable = 15
};
enum Texture : unsigned {
    baseColors = 0,
    skinDepth = 1,
    peeled = 2,  // one at a time, as the next ones
    found = 2,
    hairColor = 2,
    finDepth = 2,
    shellRows = 3,
    cornerRows = 4,
    foundIndices = 5,
    shellTile = 6,
    skinFound = 7,
    skinIndices = 8,
    shellSkinDepth = 9,
    hairDepth = 10,
    shellPicture = 12
};
}  // namespace binding

}  // namespace pelage
