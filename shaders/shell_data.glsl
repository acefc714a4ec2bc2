// shell_data.glsl -- what the passes that draw fur in shells share.

// One per vertex of the skin: the mean hair of both coats, t(1-t) a + t^2 b from its root, over a
// skin that bends as it does there (shell_curves.comp). What is along `up` is height over the skin,
// the rest is way on the skin.
struct ShellVertex {
    vec3 overA;   // m, world, as underA and both B
    float top;    // m, greatest height of the higher coat
    vec3 overB;
    float topAt;  // t of the hair there
    vec3 underA;
    uint highest;  // 0 over, 1 under: the higher coat
    vec3 underB;
    uint pad0;
    vec3 outer;   // world, the place there
    uint pad1;
    vec3 up;      // unit, normal of the skin below that place
    uint pad2;
};

struct ShellCoat {    // of one coat
    float period;     // m, side of the tile of roots
    float width;      // m, of a hair at its root
    float taper;
    float stray;      // [0,1] how far hairs lean apart
};

layout(std140, binding = 2) uniform ShellBlock {
    ShellCoat shellOver;
    ShellCoat shellUnder;
    uint shellLayers;     // that are asked for; 0 = as many as it needs
    float leastWidth;     // pixels; where hairs would be narrower there are fewer and wider ones
    uint shellLayer;      // of a single layer: its number
    uint shellCoats;      // bit 0: draw the overcoat, bit 1: the undercoat
};
