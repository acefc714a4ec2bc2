// shell_data.glsl -- what the passes that draw fur in shells share.

struct ShellVertex {  // one per vertex of the skin: the mean hair of both coats (shell_curves.comp)
    vec3 overA;        // m, world, as underA and both B
    float overHeight;  // m, greatest over the skin
    vec3 overB;
    float underHeight;
    vec3 underA;
    uint pad0;
    vec3 underB;
    uint pad1;
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
