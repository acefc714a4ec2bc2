// shell_data.glsl -- what the passes that draw fur in shells share.

// One per vertex of the skin: the mean hair of both coats, t(1-t) a + t^2 b from its root.
struct ShellVertex {
    vec3 overA;  // m, world, as underA and both B
    float top;   // m, how high they get over the skin
    vec3 overB;
    uint pad0;
    vec3 underA;
    uint pad1;
    vec3 underB;
    uint pad2;
    vec3 overAcross;  // unit, across the plane in which the hair bends
    uint pad3;
    vec3 underAcross;
    uint pad4;
};

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
