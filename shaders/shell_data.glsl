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

struct Curve {  // of a hair from its root, m: t(1-t) a + t^2 b
    vec3 a, b;
};

// By which share of the mean hair's height single hairs are lower or higher at most, as their ends
// lie in a ball of this share of their length.
float spreadOf(Curve mean, vec3 n, float endRandomness) {
    const float kMost = 0.6;
    float z = dot(mean.b, n);
    return min(endRandomness * length(mean.b - z * n) / max(abs(z), 1e-20), kMost);
}

// The highest of the hairs.
Curve highest(Curve mean, float spread) {
    return Curve((1.0 + spread) * mean.a, (1.0 + spread) * mean.b);
}

// Where a point over a flat skin is over one that bends away below it, 1/m: so far along the skin
// and so high over it.
vec3 overBent(vec3 p, vec3 n, float bend) {
    float z = dot(p, n);
    vec3 along = p - z * n;
    float square = dot(along, along);
    float u = 1.0 + bend * z;
    float x = bend * bend * square / (u * u);
    float height = (z * (1.0 + u) + bend * square) / (sqrt(u * u + bend * bend * square) + 1.0);
    return along / (u * (1.0 + 0.28 * x)) + height * n;  // atan(x) = x / (1 + 0.28 x^2)
}

// The same of a hair, through its middle and its tip: straight hair leaves a skin that bends away.
// Where the skin folds over itself within the hair's length that is no longer so.
Curve overBent(Curve hair, vec3 n, float bend) {
    float most = 1.0 / max(length(hair.b), 1e-20);
    bend = clamp(bend, -0.5 * most, 8.0 * most);
    vec3 tip = overBent(hair.b, n, bend);
    return Curve(4.0 * overBent(0.25 * (hair.a + hair.b), n, bend) - tip, tip);
}

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
