// shell_data.h -- what shaders/shell_data.glsl and shell_curves.comp read and write, as C++.
#pragma once

#include "core/curvature.h"

namespace pelage {

struct ShellVertex {
    vec3 position;
    float top;
    vec3 normal;
    float density;
    vec3 overA;
    float furLength;
    vec3 overB;
    float bendXX;
    vec3 underA;
    float bendXY;
    vec3 underB;
    float bendXZ;
    vec3 overAcross;
    float bendYY;
    vec3 underAcross;
    float bendYZ;
    vec3 place;
    float bendZZ;
    vec3 tint;
    float combed;
    vec4 turn;
};

struct ShellCorner {
    vec3 outer;
    float top;
    vec3 position;
    uint pad0;
    vec3 normal;
    uint pad1;
};

struct Bend {
    vec3 normal;
    float pad0;
    Curvature curvature;
};

struct RestVertex {
    vec3 position{0.0f};
    uint pad0 = 0;
    vec4 turn{0.0f, 0.0f, 0.0f, 1.0f};
};

// The uniform block.
struct ShellCoat {
    float period = 1.0f, width = 0.0f, taper = 0.0f, stray = 0.0f;
};
struct ShellData {
    ShellCoat over, under;
    uint layers = 0;
    float leastWidth = 1.0f;
    uint coats = 3;
    uint pad0 = 0;
};
static_assert(sizeof(ShellData) == 48 && sizeof(Bend) == 48);

}  // namespace pelage
