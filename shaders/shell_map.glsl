// shell_map.glsl -- fur that is cut from one picture, which lies on the skin in patches,
// whatever uvs it has.
//
// Space is divided into cells with wavy walls. The skin in a cell shows the picture as projected
// along one of the axes of space: by a chance that axisShares gives, so that there is no seam
// where the skin turns from one axis to another. No place shows a mix of two projections, which
// would even out what is bright and what is dark: each layer covers as much as in the picture
// wherever the skin faces. Of a photograph each cell shows another part, away from its edges,
// which do not match, with its lower edge to where hair is combed.

layout(std140, binding = 3) uniform ShellMapBlock {
    vec4 mapTones;     // of a photograph: low and high luminance of region 0, then of region 1
    float mapSide;     // m, the shorter side of the picture
    uint mapPhoto;     // 1: colors, else ranks and ids
    uint mapLayers;
    uint mapPad0;
    float mapCoverage; // of the skin, of heights: at the root,
    float mapTaper;    // and how far hairs thin out towards the tip
    float mapGap;      // between two layers, of what fills the coat
};
layout(binding = 12) uniform sampler2D shellMap;

const float kWave = 0.12;         // of the walls, in cells
const float kPhotoCells = 2.2;    // on the shorter side of a photograph: turned cells fit into it
const float kCellReach = 1.7537;  // side of the square that holds them, sqrt(2) (1 + 2 kWave)

vec2 mapSize() { return vec2(textureSize(shellMap, 0)); }

// A place in the picture, and by how much the level is another one in its cell: from afar cells
// change to coarser levels one after the other.
struct MapPlace {
    vec2 at;
    float level;
};

// Of a place on the skin whose unit normal is n.
MapPlace mapPlace(vec3 root, vec3 n, vec3 combed) {
    vec3 cells = root * (kPhotoCells / mapSide);
    vec3 cell = floor(cells + kWave * waves(cells));
    ivec3 at = ivec3(cell);
    uint chance = pcg(uint(at.x) * 73856093u ^ pcg(uint(at.y) * 19349663u ^ pcg(uint(at.z))));
    vec3 shares = axisShares(n);
    float turn = rand01(chance);
    uint axis = turn < shares.x ? 0u : (turn < shares.x + shares.y ? 1u : 2u);
    vec2 size = mapSize();
    vec2 sides = size / min(size.x, size.y);
    float other = rand01(chance + 3u) - 0.5;
    if (mapPhoto == 0u) return MapPlace(alongAxis(root, axis).xy / (mapSide * sides), other);

    // Where nothing is combed hair hangs.
    vec3 along = combed - 0.02 * vec3(0.0, 1.0, 0.0);
    along -= dot(along, n) * n;
    vec2 down = alongAxis(along, axis).xy;
    down = dot(down, down) > 1e-12 ? normalize(down) : vec2(0.0, -1.0);
    vec2 right = vec2(-down.y, down.x) * (alongAxis(n, axis).z < 0.0 ? -1.0 : 1.0);
    vec2 inCell = alongAxis(cells - cell - 0.5, axis).xy;
    vec2 part = vec2(rand01(chance + 1u), rand01(chance + 2u)) - 0.5;
    vec2 room = kPhotoCells * sides - kCellReach;
    vec2 turned = vec2(dot(inCell, right), dot(inCell, down)) + part * room;
    return MapPlace(0.5 + turned / (kPhotoCells * sides), other);
}

// Level of the picture whose texels are as large as pixels; < 0 where all are larger.
float mapLevel(float pixelsPerMetre) {
    vec2 size = mapSize();
    return log2(min(size.x, size.y) / (mapSide * pixelsPerMetre));
}

// The texel in whose bounds a place is. Means of several would even out what is bright and dark.
vec4 mapTexel(MapPlace place, float level) {
    float coarsest = float(textureQueryLevels(shellMap) - 1);
    float whole = clamp(floor(level + place.level + 0.5), 0.0, coarsest);
    ivec2 size = textureSize(shellMap, int(whole));
    return texelFetch(shellMap, min(ivec2(fract(place.at) * vec2(size)), size - 1), int(whole));
}

// With round outlines where texels are larger than pixels.
vec4 mapSmooth(MapPlace place, float level, vec4 texel) {
    return level < 0.0 ? textureLod(shellMap, place.at, 0.0) : texel;
}

// Luminance from which on a photograph has hair so far in from the tips, 1 = on the skin: light
// that enters fur dies away exponentially (Ukaji and others, "Acquiring Shell Textures from a
// Single Image for Realistic Fur Rendering").
float mapThreshold(vec2 tones, float depth) {
    return tones.y * pow(tones.x / max(tones.y, 1e-20), depth);
}

// From display-encoded to linear. Not by the texture: what drivers make of it may be off by so much
// of a step of 8 bits that all texels of one tone change the layer.
vec3 mapLight(vec3 color) {
    return mix(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92,
               lessThanEqual(color, vec3(0.04045)));
}

struct MapCut {
    bool there;
    vec3 color;  // of a photograph
    uint id;     // of the hair, of other pictures
};

// Layer k at a place of the picture where this share of the hairs grows.
MapCut mapCut(MapPlace place, float level, uint k, float grown) {
    vec4 texel = mapTexel(place, level);
    vec4 even = mapSmooth(place, level, texel);
    float depth = float(k) / float(mapLayers);
    MapCut cut;
    cut.id = pcg(uint(65535.0 * texel.g + 0.5));
    if (mapPhoto == 0u) {
        // A share s of the picture is higher than 1 - sqrt(s).
        cut.there = even.r >= 1.0 - sqrt(mapCoverage) * (1.0 - mapTaper * (1.0 - depth));
        cut.color = vec3(1.0);
        if (grown < 1.0) cut.there = cut.there && rand01(cut.id) < grown;
        return cut;
    }
    cut.color = mapLight(even.rgb);
    vec2 tones = mapTones.xy;
    if (texel.a < 0.75) tones = mapTones.zw;
    float light = dot(cut.color, vec3(2613072.0, 8788810.0, 887015.0) / 12288897.0);
    bool reached = k == mapLayers || light >= mapThreshold(tones, depth);
    // Where not all grows the highest hairs are left, each as a whole.
    bool stands = grown >= 1.0 || light >= mapThreshold(tones, grown);
    cut.there = texel.a > 0.25 && reached && stands && grown > 0.0;
    return cut;
}
