// shell_map.glsl -- fur that is cut from one picture, which lies on the skin in patches, whatever uvs
// it has.
//
// Space is divided into cells with wavy walls. The skin in a cell shows the picture as projected along
// one of the axes of space: by a chance that axisShares gives, so that there is no seam where the skin
// turns from one axis to another. No place shows a mix of two projections, which would even out what
// is bright and what is dark: each layer covers as much as in the picture wherever the skin faces. Of
// a photograph each cell shows another part, away from its edges, which do not match, with its lower
// edge to where hair is combed.

layout(std140, binding = 3) uniform ShellMapBlock {
    vec4 mapTones;     // of a photograph: low and high luminance of region 0, then of region 1
    float mapSide;     // m, the shorter side of the picture
    float mapGap;      // of the hair's length that the layers fill
    uint mapLayers;
    uint mapCoat;      // 0 over, 1 under
    uint mapPhoto;     // 1: colors, else heights and ids
    uint mapRegions;   // of color
    uint mapPad0;
    uint mapPad1;
};
layout(binding = 2) uniform sampler2D shellMap;

in vec3 combed;

const float kWave = 0.12;         // of the walls, in cells
const float kPhotoCells = 2.2;    // on the shorter side of a photograph: turned cells fit into it
const float kCellReach = 1.7537;  // side of the square that holds them, sqrt(2) (1 + 2 kWave)

vec2 mapSize() { return vec2(textureSize(shellMap, 0)); }

// Where a place on the skin, whose unit normal is n there, is in the picture.
vec2 mapPlace(vec3 root, vec3 n) {
    vec3 cells = root * (kPhotoCells / mapSide);
    vec3 cell = floor(cells + kWave * waves(cells));
    ivec3 at = ivec3(cell);
    uint chance = pcg(uint(at.x) * 73856093u ^ pcg(uint(at.y) * 19349663u ^ pcg(uint(at.z))));
    vec3 shares = axisShares(n);
    float turn = rand01(chance);
    uint axis = turn < shares.x ? 0u : (turn < shares.x + shares.y ? 1u : 2u);
    vec2 size = mapSize();
    vec2 sides = size / min(size.x, size.y);
    if (mapPhoto == 0u) return alongAxis(root, axis).xy / (mapSide * sides);

    // Where nothing is combed hair hangs.
    vec3 along = combed - 0.02 * vec3(0.0, 1.0, 0.0);
    along -= dot(along, n) * n;
    vec2 down = alongAxis(along, axis).xy;
    down = dot(down, down) > 1e-12 ? normalize(down) : vec2(0.0, -1.0);
    vec2 right = vec2(-down.y, down.x) * (alongAxis(n, axis).z < 0.0 ? -1.0 : 1.0);
    vec2 inCell = alongAxis(cells - cell - 0.5, axis).xy;
    vec2 part = vec2(rand01(chance + 1u), rand01(chance + 2u)) - 0.5;
    vec2 room = kPhotoCells * sides - kCellReach;
    return 0.5 + (vec2(dot(inCell, right), dot(inCell, down)) + part * room) / (kPhotoCells * sides);
}

// Level of the picture whose texels are as large as pixels.
float mapLevel(float pixelsPerMetre) {
    vec2 size = mapSize();
    return max(0.0, log2(min(size.x, size.y) / (mapSide * pixelsPerMetre)));
}

// The texel in whose bounds a place is.
vec4 mapTexel(vec2 at, float level) {
    int whole = int(level + 0.5);
    ivec2 size = textureSize(shellMap, whole);
    return texelFetch(shellMap, min(ivec2(fract(at) * vec2(size)), size - 1), whole);
}

uint mapId(vec2 at, float level) { return uint(65535.0 * mapTexel(at, level).g + 0.5); }

// Luminance from which on a photograph has hair so far in from the tips, 1 = on the skin: light that
// enters fur dies away exponentially (Ukaji and others, "Acquiring Shell Textures from a Single Image
// for Realistic Fur Rendering").
float mapThreshold(vec2 tones, float depth) {
    return tones.y * pow(tones.x / max(tones.y, 1e-20), depth);
}

struct MapCut {
    bool there;
    vec3 color;  // of a photograph
};

// Layer k of the picture at a place where this share of the hairs grows.
MapCut mapCut(vec2 at, float level, uint k, float grown) {
    vec4 texel = textureLod(shellMap, at, level);
    float depth = float(k) / float(mapLayers);
    MapCut cut;
    if (mapPhoto == 0u) {
        cut.there = texel.r >= max(1.0 - depth, 1e-3);
        if (grown < 1.0) cut.there = cut.there && rand01(pcg(mapId(at, level))) < grown;
        cut.color = vec3(1.0);
        return cut;
    }
    vec2 tones = mapTones.xy;
    float alpha = texel.a;
    if (mapRegions > 1u) {
        alpha = mapTexel(at, level).a;
        if (alpha < 0.75) tones = mapTones.zw;
        alpha = alpha > 0.25 ? 1.0 : 0.0;
    }
    float light = dot(texel.rgb, vec3(2613072.0, 8788810.0, 887015.0) / 12288897.0);
    bool reached = k == mapLayers || light >= mapThreshold(tones, depth);
    // Where not all grows the highest hairs are left, each as a whole.
    bool stands = grown >= 1.0 || light >= mapThreshold(tones, grown);
    cut.there = alpha >= 0.5 && reached && stands && grown > 0.0;
    cut.color = texel.rgb;
    return cut;
}

// t of the hair in layer k.
float mapLayerAt(uint k) { return mapGap * (1.0 - float(k) / float(mapLayers)); }

// The light from a place of the picture in layer k. A photograph has the shade in its fur already.
vec3 mapRadiance(MapCut cut, vec2 at, float level, uint k, vec3 n, vec3 eye) {
    Hit hit;
    hit.way = 0.0;
    hit.t = mapLayerAt(k);
    hit.across = 0.0;
    hit.over = mapCoat == 0u;
    if (mapPhoto == 0u) {
        hit.id = pcg(mapId(at, level));
        return radianceOf(hit, n, eye);
    }
    hit.id = 0u;
    Coat coat = fur.under;
    if (hit.over) coat = fur.over;
    // White in the light of the studio shows the photograph about as it is.
    coat.ambient = vec3(0.45);
    coat.diffuse = vec3(0.6);
    coat.specular = vec3(0.0);
    coat.rootColor = coat.tipColor = vec3(1.0);
    coat.colorNoise = coat.normalRandomness = 0.0;
    return litHair(hit, coat, tint * cut.color, 0.0, n, eye);
}
