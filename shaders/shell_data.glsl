// shell_data.glsl -- what the passes that draw fur in shells share.

// One per vertex of the skin: the mean hair of both coats, t(1-t) a + t^2 b from its root, and what
// else a ray through them asks of the skin. As the skin is at rest, where hair stays in its place
// however the skin moves, unless world is said.
struct ShellVertex {
    vec3 position;   // m, world
    float top;       // m, how high its hair gets over the skin
    vec3 normal;
    float density;   // [0,1]
    vec3 overA;      // m, as underA and both B
    float furLength;
    vec3 overB;
    float bendXX;    // 1/m, world: core/curvature.h
    vec3 underA;
    float bendXY;
    vec3 underB;
    float bendXZ;
    vec3 overAcross; // unit, across the plane in which the hair bends
    float bendYY;
    vec3 underAcross;
    float bendYZ;
    vec3 place;      // m
    float bendZZ;
    vec3 tint;
    float combed;    // packedDirection of where it is combed
    vec4 turn;       // unit quaternion: from the world to the skin at rest
};

// One per vertex of the skin, for drawing; world.
struct ShellCorner {
    vec3 outer;     // where its fur begins
    float top;
    vec3 position;
    uint pad0;
    vec3 normal;
    uint pad1;
};

// By a unit quaternion.
vec3 turned(vec3 v, vec4 q) {
    vec3 c = 2.0 * cross(q.xyz, v);
    return v + q.w * c + cross(q.xyz, c);
}
vec3 turnedBack(vec3 v, vec4 q) { return turned(v, vec4(-q.xyz, q.w)); }

// A vector of components in [-1,1] to a 127th as a whole number, which a float holds exactly.
float packedDirection(vec3 v) { return float(packSnorm4x8(vec4(v, 0.0))); }
vec3 unpackedDirection(float code) { return unpackSnorm4x8(uint(code)).xyz; }

struct ShellCoat {    // of one coat
    float period;     // m, side of the tile of roots
    float width;      // m, of a hair at its root
    float taper;
    float stray;      // share of the painted length by which tips stray from the mean hair's
};

layout(std140, binding = 2) uniform ShellBlock {
    ShellCoat shellOver;
    ShellCoat shellUnder;
    uint shellLayers;     // that are asked for; 0 = as many as it needs
    float leastWidth;     // pixels; where hairs would be narrower there are fewer and wider ones
    uint shellCoats;      // bit 0: draw the overcoat, bit 1: the undercoat
    uint shellPad0;
};
