// shell_hair.glsl -- hairs that stand in a tile of roots which repeats over the skin, whatever uvs
// it has; what shells cut.
//
// A place on the skin is projected along an axis of space onto the tile, one axis for each hair: it
// belongs to an axis by the chance `axisShares` gives at its root, and exists there by another that
// undoes the slant of the skin, so that hairs are as many on a square metre everywhere, without a
// seam and without mixing.

const uint kTileHairs = 1024u;  // in the finest level; each coarser one has the first half of them
const uint kTileSide = 256u;    // texels of the finest level, and half as many after every second
const uint kTileLevels = 9u;
// Hairs on the tile for each that is needed on a skin across the axis: the greatest axisShares(n) / |n|.
const float kTileExcess = 1.45;

// The two nearest roots of each texel, level after level.
layout(binding = 6) uniform usamplerBuffer shellTile;

// Texels of a level, and those of the levels before it.
uvec2 tileLevel(uint level) {
    uint side = kTileSide >> (level / 2u);
    uint pair = kTileSide * kTileSide * 4u / 3u - side * side * 4u / 3u;
    return uvec2(side, 2u * pair + (level % 2u) * side * side);
}

// How much of the hair at a place of unit normal n belongs to each axis.
vec3 axisShares(vec3 n) {
    vec3 p = n * n;
    p *= p;
    p *= p;
    p *= p;
    return p * (1.0 / (p.x + p.y + p.z));
}

// A vector without its component along an axis, the axes always in cyclic order; that component is z.
vec3 alongAxis(vec3 v, uint axis) {
    return axis == 0u ? v.yzx : (axis == 1u ? v.zxy : v);
}

// Smooth waves through space of amplitude 1 and period 1, one for each direction, each across it.
vec3 waves(vec3 p) {
    vec3 x = p.yzx + 0.37 * p.zxy;
    x = 2.0 * (x - floor(x + 0.5));
    return 4.0 * x * (1.0 - abs(x));
}

struct TileRoot {
    vec2 place;   // in tiles
    uint number;
};

TileRoot unpackRoot(uint bits) {
    return TileRoot(vec2(float(bits & 2047u) + 0.5, float(bits >> 11u & 2047u) + 0.5) / 2048.0,
                    bits >> 22u);
}

struct Level {    // of detail
    float share;  // of the hairs that is drawn
    float fade;   // rank at which they have faded out
    uint tile;    // level of the tile that has them all
    uvec2 texels;
};

// Of hairs so many pixels wide.
Level levelFor(float pixels) {
    Level level;
    level.share = clamp(pixels / max(leastWidth, 1e-6), 1.0 / 256.0, 1.0);
    level.fade = min(1.0, 1.2 * level.share);
    level.tile = min(uint(max(0.0, -log2(level.fade))), kTileLevels - 1u);
    level.texels = tileLevel(level.tile);
    return level;
}

// Of a hair at this level of detail, in its full width.
float widthShare(Level level, uint number) {
    return fadedWidth((float(number) + 0.5) / float(kTileHairs), level.share, level.fade);
}

// The axes that have hair at a place: `first`, the one across which the skin lies most, then `step`
// further in cyclic order, so many of them. (A loop over fewer, because software runs what follows
// an if in any case.)
struct Axes {
    uint first, step, count;
    vec3 chance;  // of a root to bear a hair, by axis
    vec3 normal;
};

Axes axesOf(vec3 n, float density) {
    const float kLeastShare = 0.02;
    vec3 shares = axisShares(n);
    vec3 size = abs(n);
    Axes axes;
    axes.first = size.x > size.y ? (size.x > size.z ? 0u : 2u) : (size.y > size.z ? 1u : 2u);
    vec3 ordered = alongAxis(shares, axes.first);  // the first one is z
    axes.step = ordered.x < kLeastShare ? 2u : 1u;
    axes.count = 1u + uint(ordered.x >= kLeastShare) + uint(ordered.y >= kLeastShare);
    axes.chance = shares * density / (kTileExcess * max(size, vec3(0.1)));
    axes.normal = n;
    return axes;
}

struct Slab {       // of a coat between two heights of its hair, as the ray sees it
    vec3 from, to;  // the roots of hair that ends of the ray would touch, world
    vec2 t;         // shares of the highest hair's length there
    float spread;   // of the hairs' heights, shell_data.glsl
    float stretch;  // square of that of the hair's width across the ray on the skin
};

struct TileHit {
    float along;   // share of the way through the slab; 2 = none
    float t;       // of the hair
    float across;  // from the middle of the hair, in half widths
    uint id;       // scattered by who draws it
    float met;     // hairs that stand beside the way through the slab
};

// How many times as high as a hair the highest one is: hairs are as high on average as the mean hair,
// by the sum of two draws.
float heightRatio(float spread, float draw) {
    float x = fract(311.3 * draw) + fract(5.7 * draw) - 1.0;
    return (1.0 + spread) / (1.0 + spread * x);
}

// The first hair of one axis that the ray meets in a slab.
TileHit tileHit(Slab slab, uint axis, uint coatNumber, ShellCoat coat, Level level, Axes axes) {
    TileHit hit = TileHit(2.0, 0.0, 0.0, 0u, 0.0);
    vec3 m = alongAxis(axes.normal, axis);
    vec2 tilt = m.xy / m.z;
    vec2 from = alongAxis(slab.from, axis).xy;
    vec2 way = alongAxis(slab.to, axis).xy - from;
    // Each side of each axis and each coat has its own part of the tile.
    uint stream = 4u * axis + 2u * coatNumber + (m.z < 0.0 ? 1u : 0u);
    vec2 tile = (from + 0.5 * way) / coat.period + float(stream) * vec2(0.7548777, 0.5698403);
    uint side = level.texels.x;
    uvec2 texel = uvec2(ivec2(floor(tile * float(side)))) & (side - 1u);
    uvec2 roots = texelFetch(shellTile, int(level.texels.y + texel.y * side + texel.x)).xy;
    float wayTilt = dot(way, tilt);
    float perSquare = 1.0 / max(dot(way, way) + wayTilt * wayTilt, 1e-20);
    float chance = alongAxis(axes.chance, axis).z;
    vec2 inCell = vec2(0.0);
    for (uint k = 0u; k < 2u; ++k) {
        uint bits = k == 0u ? roots.x : roots.y;
        TileRoot root = unpackRoot(bits);
        vec2 apart = root.place - tile;
        vec2 cell = floor(0.5 - apart);
        vec2 offset = (apart + cell) * coat.period + 0.5 * way;  // from where the slab begins
        float offsetTilt = dot(offset, tilt);
        float beside = (dot(offset, way) + offsetTilt * wayTilt) * perSquare;
        float along = clamp(beside, 0.0, 1.0);
        vec2 rest = offset - along * way;
        float restTilt = dot(rest, tilt);
        // Any cheap draw will do that tells the roots of neighboring tiles apart.
        float draw = fract(0.6180340 * float(root.number) + dot(cell, vec2(0.7548777, 0.5698403)));
        float t = mix(slab.t.x, slab.t.y, along) * heightRatio(slab.spread, draw);
        float radius = 0.5 * coat.width * widthShare(level, root.number) * (1.0 - coat.taper * t);
        float square = radius * radius * slab.stretch;
        float distance2 = dot(rest, rest) + restTilt * restTilt;
        bool meets = t <= 1.0 && distance2 < square && fract(1021.7 * draw) < chance;
        if (meets && beside == along) hit.met += 1.0;
        if (meets && along < hit.along) {
            hit.along = along;
            hit.t = t;
            hit.id = bits;
            inCell = cell;
            hit.across = sign(way.x * rest.y - way.y * rest.x) * sqrt(distance2 / square);
        }
    }
    hit.id ^= uint(int(inCell.x)) * 73856093u ^ uint(int(inCell.y)) * 19349663u ^
              stream * 83492791u;
    return hit;
}
