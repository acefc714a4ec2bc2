// shell_hair.glsl -- hairs that stand in a tile of roots which repeats over the skin, whatever uvs
// it has; what shells cut.
//
// A place on the skin is projected along an axis of space onto the tile, one axis for each hair: it
// belongs to an axis by the chance `axisShares` gives at its root, and exists there by another that
// undoes the slant of the skin, so that hairs are as many on a square metre everywhere, without a
// seam and without mixing.

const uint kTileHairs = 1024u;  // in the finest level; each coarser one has the first quarter
const uint kTileSide = 256u;    // texels of the finest level
const uint kTileLevels = 5u;
// Hairs on the tile for each that is needed on a skin across the axis: the greatest axisShares(n) / |n|.
const float kTileExcess = 1.27;

layout(binding = 2) uniform usampler2D shellTile;  // the two nearest roots of each texel

// How much of the hair at a place of unit normal n belongs to each axis.
vec3 axisShares(vec3 n) {
    vec3 p = n * n;
    p *= p;
    p *= p;
    return p * (1.0 / (p.x + p.y + p.z));
}

// A vector without its component along an axis, the axes always in cyclic order; that component is z.
vec3 alongAxis(vec3 v, uint axis) {
    return axis == 0u ? v.yzx : (axis == 1u ? v.zxy : v);
}

struct TileRoot {
    vec2 place;   // in tiles
    uint number;
};

TileRoot unpackRoot(uint bits) {
    return TileRoot(vec2(float(bits & 2047u) + 0.5, float(bits >> 11u & 2047u) + 0.5) / 2048.0,
                    bits >> 22u);
}

struct Level {     // of detail
    float share;   // of the hairs that is drawn
    float fade;    // rank at which they have faded out
    uint tile;     // level of the tile that has them all
};

// Of hairs so many pixels wide.
Level levelFor(float pixels) {
    Level level;
    level.share = clamp(pixels / max(leastWidth, 1e-6), 1.0 / 256.0, 1.0);
    level.fade = min(1.0, 1.2 * level.share);
    level.tile = min(uint(max(0.0, -0.5 * log2(level.fade))), kTileLevels - 1u);
    return level;
}

struct TileHit {
    bool found;
    float along;   // share of the way through the slab
    float across;  // from the middle of the hair, in half widths
    uint id;
};

struct Slab {       // of a coat between two heights of its hair, as the ray sees it
    vec3 from, to;  // the roots of hair that ends of the ray would touch
    vec2 t;         // shares of the hair's length there
    float stretch;  // of the hair's width across the ray on the skin
};

// The first hair of one axis that the ray meets in a slab. n is the normal at the slab's roots.
TileHit tileHit(Slab slab, uint axis, uint coatNumber, ShellCoat coat, Level level, vec3 n,
                float density) {
    TileHit hit;
    hit.found = false;
    hit.along = 2.0;
    vec3 m = alongAxis(n, axis);
    vec2 tilt = m.xy / m.z;
    vec2 from = alongAxis(slab.from, axis).xy;
    vec2 way = alongAxis(slab.to, axis).xy - from;
    vec2 middle = from + 0.5 * way;
    // Each side of each axis and each coat has its own part of the tile.
    uint stream = 4u * axis + 2u * coatNumber + (m.z < 0.0 ? 1u : 0u);
    vec2 tile = middle / coat.period + vec2(rand01(stream), rand01(stream + 16u));
    ivec2 texel = ivec2(floor(fract(tile) * float(kTileSide >> level.tile)));
    texel = min(texel, ivec2(int(kTileSide >> level.tile) - 1));
    uvec2 roots = texelFetch(shellTile, texel, int(level.tile)).rg;
    float wayTilt = dot(way, tilt);
    float square = dot(way, way) + wayTilt * wayTilt;
    float share = axisShares(n)[axis] / (kTileExcess * abs(m.z)) * density;
    for (uint k = 0u; k < 2u; ++k) {
        TileRoot root = unpackRoot(k == 0u ? roots.x : roots.y);
        vec2 apart = root.place - tile;
        vec2 cell = floor(0.5 - apart);
        vec2 offset = (apart + cell) * coat.period + 0.5 * way;  // from where the slab begins
        float offsetTilt = dot(offset, tilt);
        float along = clamp((dot(offset, way) + offsetTilt * wayTilt) / max(square, 1e-20), 0.0, 1.0);
        vec2 rest = offset - along * way;
        float restTilt = dot(rest, tilt);
        float t = mix(slab.t.x, slab.t.y, along);
        float rank = (float(root.number) + 0.5) / float(kTileHairs);
        float radius = 0.5 * coat.width * fadedWidth(rank, level.share, level.fade) *
                       (1.0 - coat.taper * t) * slab.stretch;
        float distance2 = dot(rest, rest) + restTilt * restTilt;
        uint id = pcg(uint(int(cell.x)) ^ pcg(uint(int(cell.y)) ^ pcg(root.number ^ stream << 16u)));
        if (distance2 < radius * radius && along < hit.along && rand01(id) < share) {
            hit.found = true;
            hit.along = along;
            hit.id = id;
            float side = way.x * rest.y - way.y * rest.x;
            hit.across = sign(side) * sqrt(distance2) / radius;
        }
    }
    return hit;
}
