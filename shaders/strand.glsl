// strand.glsl -- the shape of one hair. The only place that knows it.
//
// Compiled twice: by the GL driver (live view) and by the C++ compiler through core/strand.cpp
// (export, picking, tests). The dialect that both understand: no swizzles, no out-parameters, no
// globals but const, `f` on every float literal, structs returned by value.
//
// The model is that of Van Gelder and Wilhelms, "An Interactive Fur Modeling Technique", 1997
// (sections 3.2 to 3.7), made total: every input, also NaN, gives a finite hair that is rooted on
// the skin and does not pass below its plane.

// Hash. Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020.
uint pcg(uint v) {
    uint s = v * 747796405u + 2891336453u;
    uint w = ((s >> ((s >> 28u) + 4u)) ^ s) * 277803737u;
    return (w >> 22u) ^ w;
}

// Uniform in [0,1), 24 bits, so exact in a float.
float rand01(uint v) { return float(pcg(v) >> 8u) * (1.0f / 16777216.0f); }

// The random stream of hair k of a triangle. Its draws are rand01(id + n), n from the list below.
uint hairId(uint triangle, uint k, uint seed) { return pcg(triangle ^ pcg(k ^ pcg(seed))); }

const uint kDrawPlace = 0u;    // and 1: barycentric weights
const uint kDrawCoat = 2u;     // overcoat or undercoat
const uint kDrawBall = 3u;     // 3, 4 and 5, 8 and 9: displacement of the tip
const uint kDrawTwist = 6u;    // turn of the shading normal
const uint kDrawTone = 7u;     // brightness
const uint kDrawCurl = 10u;    // where the curl begins
const uint kDrawFrizz = 16u;   // 16 to 33 and 40 to 57: knots of the frizz

// Below 2^125, so that 1/x is no denormal, which GPUs may take for 0. A test of the bits, because
// GLSL compilers may assume that no value is NaN and turn comparisons around.
bool finite1(float x) { return (floatBitsToUint(x) & 0x7fffffffu) < 0x7e000000u; }

bool finite3(vec3 v) { return finite1(v.x) && finite1(v.y) && finite1(v.z); }

// x inside a range; its least value where x is infinite or NaN.
float within(float x, float least, float greatest) {
    return finite1(x) ? min(max(x, least), greatest) : least;
}

// v as a unit vector; `fallback` where v has no direction: zero, tiny, infinite or NaN.
vec3 safeUnit(vec3 v, vec3 fallback) {
    float square = dot(v, v);
    // Between 2^-66 and 2^62 nothing under- or overflows; NaN is not among the bits in between.
    if (floatBitsToUint(square) - 0x1e800000u < 0x40000000u) return v * (1.0f / sqrt(square));
    if (!finite3(v)) return fallback;
    float a = max(abs(v.x), max(abs(v.y), abs(v.z)));
    if (!(a > 1e-30f)) return fallback;
    vec3 u = vec3(v.x / a, v.y / a, v.z / a);
    return u * (1.0f / sqrt(dot(u, u)));
}

// A unit tangent for any unit normal. Duff et al., "Building an Orthonormal Basis, Revisited",
// JCGT 2017.
vec3 anyTangent(vec3 n) {
    float s = n.z < 0.0f ? -1.0f : 1.0f;
    float a = -1.0f / (s + n.z);
    return vec3(1.0f + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}

// Weights of the three corners from Root.bary; they add up to 1 and none is negative. Precise, as all
// that decides whether there is a hair: the same on every GPU, fused operations or not.
vec3 baryWeights(uint bary) {
    precise float a = float(bary & 65535u) * (1.0f / 65535.0f);
    precise float b = float(bary >> 16u) * (1.0f / 65535.0f);
    precise float c = 1.0f - a - b;
    return vec3(a, b, max(0.0f, c));
}

// Uniform in the unit ball. The largest of three uniform numbers is distributed like the radius.
vec3 randomInBall(uint id) {
    float z = 2.0f * rand01(id + kDrawBall) - 1.0f;
    float turn = 6.2831853f * rand01(id + kDrawBall + 1u);
    float ring = sqrt(max(0.0f, 1.0f - z * z));
    float radius = max(rand01(id + kDrawBall + 2u), max(rand01(id + 8u), rand01(id + 9u)));
    return radius * vec3(ring * cos(turn), ring * sin(turn), z);
}

// Arc length of the curve t(1-t) w + t^2 E for unit w and E, as a function of m = 1 - w.E in
// [0, 1.02]. The closed form has two logarithms that cancel near m = 0; this polynomial
// interpolates it at Chebyshev nodes and is within 3e-6 of it.
float arcOfUnitCurve(float m) {
    float s = 0.032314113f;
    s = s * m - 0.14891651f;
    s = s * m + 0.29764438f;
    s = s * m - 0.35361641f;
    s = s * m + 0.30093773f;
    s = s * m - 0.25921231f;
    s = s * m + 0.33300405f;
    return s * m + 1.0000026f;
}

// By how much a helix around a straight hair is longer than the hair: its radius grows from 0 at
// the root to `radius` (share of the length) at the tip, in so many turns.
float arcOfHelix(float radius, float turns) {
    float a = 1.0f + radius * radius;
    float b = 39.478418f * turns * turns * radius * radius;
    if (b < 1e-4f) return sqrt(a) * (1.0f + b / (6.0f * a));
    float x = sqrt(b / a);
    return 0.5f * sqrt(a + b) + 0.5f * a / sqrt(b) * log(x + sqrt(1.0f + x * x));
}

// Rank of hair i of a cluster, in [0,1); the hair is drawn while rank < density * level of detail.
// Ranks are evenly spaced, step = 1 / hairs of the cluster, from a random phase in [0,1).
float rankOf(uint i, float phase, float step) {
    return min((float(i) + phase) * step, 0.99999994f);
}

// Share of its full width that a hair has where the share `lod` of the hairs is drawn: 1/lod up to a
// rank, then falling to 0 at rank `fade`, in [lod, 2 lod]. The sum of all widths stays that of the
// full coat. Cook et al., "Stochastic Simplification of Aggregate Detail", 2007.
float fadedWidth(float rank, float lod, float fade) {
    float full = 2.0f * lod - fade;
    float share = rank <= full ? 1.0f
                               : clamp((fade - rank) / max(fade - full, 1e-9f), 0.0f, 1.0f);
    return share / lod;
}

bool isOvercoat(uint id, float share) { return rand01(id + kDrawCoat) < share; }

// Angle by which the shading normal of a hair is turned about it.
float twistOf(Coat coat, uint id) {
    return 3.1415927f * within(coat.normalRandomness, 0.0f, 1.0f) *
           (2.0f * rand01(id + kDrawTwist) - 1.0f);
}

// How much lighter or darker than its coat a hair is.
float toneOf(Coat coat, uint id) {
    return 1.0f + within(coat.colorNoise, 0.0f, 1.0f) * (2.0f * rand01(id + kDrawTone) - 1.0f);
}

// The direction along the skin of unit normal n in which the hair is combed; any where it is not.
vec3 combedTangent(vec3 painted, vec3 n) {
    vec3 tangent = painted - dot(painted, n) * n;
    // Shorter than this it is what rounding left, which may point into the skin.
    float least = 1e-6f * max(1.0f, dot(painted, painted));
    if (!finite3(tangent) || !(dot(tangent, tangent) > least)) tangent = anyTangent(n);
    return safeUnit(tangent, n);
}

#include "rod.glsl"

// The direction in which a hair leaves the skin: between the normal and the painted direction,
// displaced at the tip by a random vector. Unit, never below the skin plane.
vec3 weightlessDirection(vec3 n, vec3 painted, Coat coat, uint id) {
    vec3 w = safeUnit((1.0f - coat.directionWeight) * n + coat.directionWeight * painted, n);
    if (coat.endRandomness > 0.0f)
        w = safeUnit(w + coat.endRandomness * randomInBall(id), n);
    float c = dot(w, n);
    return c < 0.0f ? safeUnit(w - (2.0f * c) * n, n) : w;
}

// Smooth noise in [-1,1] through space: random values on a grid of whole numbers, mixed.
float spaceNoise(vec3 p) {
    vec3 cell = floor(p);
    vec3 f = p - cell;
    vec3 u = f * f * (3.0f - 2.0f * f);
    float sum = 0.0f;
    for (uint i = 0u; i < 8u; ++i) {
        vec3 corner = vec3(float(i & 1u), float(i >> 1u & 1u), float(i >> 2u));
        vec3 weight = 1.0f - abs(corner - u);
        vec3 at = cell + corner;
        uint hash = pcg(uint(int(at.x)) ^ pcg(uint(int(at.y)) ^ pcg(uint(int(at.z)))));
        sum += weight.x * weight.y * weight.z * (2.0f * rand01(hash) - 1.0f);
    }
    return sum;
}

// What pulls at hair: gravity and wind together, at most as hard as gravity of strength 1. Gusts
// are noise that travels with the wind.
vec3 pullAt(Fur fur, vec3 place, float seconds) {
    vec3 pull = min(max(fur.gravity, 0.0f), 1.0f) * fur.gravityDirection;
    if (fur.wind > 0.0f) {
        float strength = min(fur.wind, 1.0f);
        if (fur.gusts > 0.0f) {
            vec3 p = place * (1.0f / max(fur.gustSize, 1e-6f)) -
                     (fur.gustRate * seconds) * fur.windDirection;
            if (dot(p, p) < 1e12f)
                strength = strength * (1.0f + min(fur.gusts, 1.0f) * spaceNoise(p));
        }
        pull = pull + strength * fur.windDirection;
    }
    float size = dot(pull, pull);
    return size > 1.0f ? pull * (1.0f / sqrt(size)) : pull;
}

// A hair that starts at `root` on a skin with unit normal n. `painted` in the world; spineLength
// is the length of this hair along the curve. Gravity is that of the paper, section 3.5:
// floppiness times the cosine of the hair's angle to the normal, taken off along "up"; a small pull
// towards the combed side decides where a hair falls that stands upright. Wind adds to gravity:
// `pull` is the sum of both, of length [0,1]; a hair is never pulled below the skin's plane.
Strand bendStrand(vec3 root, vec3 n, vec3 painted, float spineLength, Coat coat, uint id,
                  vec3 pull) {
    vec3 w = weightlessDirection(n, painted, coat, id);
    float c = max(0.0f, dot(w, n));
    float strength = sqrt(dot(pull, pull));

    Strand s;
    s.origin = root;
    s.spineLength = spineLength;
    s.weightless = w;
    float twist = twistOf(coat, id);
    s.cosTwist = cos(twist);
    s.sinTwist = sin(twist);
    s.normal = n;
    s.tone = toneOf(coat, id);
    s.width = 0.0f;
    s.coat = 0u;
    s.keep = 0.0f;
    s.id = id;
    s.style = coat.style;
    s.guideOffset = vec3(0.0f, 0.0f, 0.0f);
    s.guideWeightless = s.guideOffset;
    s.guideEnd = s.guideOffset;
    s.clump = 0.0f;
    s.clumpShape = within(coat.clumpShape, 0.5f, 4.0f);
    s.curl = 0.0f;
    s.curlTurns = within(coat.curlTurns, 0.0f, 20.0f);
    s.frizz = within(coat.frizz, 0.0f, 0.5f) * spineLength;
    s.frizzWaves = within(coat.frizzWaves, 1.0f, 16.0f);
    s.rod = mat3x4(0.0f);
    s.guideRod = s.rod;
    s.droop = kDroopPaper;
    s.rodBend = 0.0f;
    s.nearSkin = 0u;
    if (isRodCoat(coat)) {
        s = bendRod(s, rodLoad(coat, c, strength), pull, painted);
    } else {
        float load = within(1.0f - coat.stiffness, 0.02f, 1.0f) * c;
        vec3 tangent = combedTangent(painted, n);
        s.end = safeUnit(w + load * (pull + (0.02f * strength) * tangent), tangent);
        if (coat.style == kStyleLine) s.weightless = s.end;
        s.scale = spineLength / arcOfUnitCurve(max(0.0f, 1.0f - dot(s.weightless, s.end)));
        vec3 bend = cross(s.end, s.weightless);
        s.binormal = safeUnit(dot(bend, bend) > 1e-12f ? bend : cross(tangent, s.weightless),
                              anyTangent(s.weightless));
    }
    if (coat.curlRadius > 0.0f) {
        float radius = within(coat.curlRadius, 0.0f, 0.5f);
        float longer = arcOfHelix(radius, s.curlTurns);
        s.scale = s.scale / longer;
        s.curl = radius * spineLength / longer;
    }
    return s;
}

// The hair gathered to its guide: at the tip by the coat's share, towards the root less.
Strand gatherStrand(Strand s, Strand guide, Coat coat) {
    if (!(guide.spineLength > 0.0f)) return s;
    s.clump = within(coat.clump, 0.0f, 1.0f);
    s.guideOffset = guide.origin - s.origin;
    s.guideWeightless = guide.scale * guide.weightless;
    s.guideEnd = guide.scale * guide.end;
    s.guideRod = guide.rod;
    return s;
}

// A length that a hair may have; 0 for none, also for NaN.
float sanitizedLength(float asked) { return asked > 1e-12f && asked <= 1e6f ? asked : 0.0f; }

// Length of the hair of a root, m, 0 for none, where the corners of its triangle hold these
// lengths.
float lengthAt(Root root, float a, float b, float c, Fur fur) {
    vec3 k = baryWeights(root.bary);
    float relative = isOvercoat(root.id, fur.share) ? fur.over.relativeLength
                                                    : fur.under.relativeLength;
    precise float painted = k.x * a + k.y * b + k.z * c;
    return sanitizedLength(sanitizedLength(painted) * relative);
}

// Largest rank at which the hair of a root is drawn: the painted density there, in [0,1].
float keepAt(Root root, float a, float b, float c) {
    vec3 k = baryWeights(root.bary);
    precise float painted = k.x * a + k.y * b + k.z * c;
    return painted > 0.0f ? min(painted, 1.0f) : 0.0f;
}

// The hair that grows from a root on a triangle with these corners, not yet gathered to its guide.
// Corners, painted values and gravity in the world; autoWidth (m) is used where the coat leaves its
// width at 0; the wind blows as it does after so many seconds.
Strand growStrand(Root root, SkinVertex a, SkinVertex b, SkinVertex c, FurVertex fa, FurVertex fb,
                  FurVertex fc, Fur fur, float autoWidth, float seconds) {
    vec3 k = baryWeights(root.bary);
    vec3 position = k.x * a.position + k.y * b.position + k.z * c.position;
    vec3 n = k.x * a.normal + k.y * b.normal + k.z * c.normal;
    if (!(dot(n, n) > 1e-6f)) n = cross(b.position - a.position, c.position - a.position);
    n = safeUnit(n, vec3(0.0f, 1.0f, 0.0f));
    vec3 painted = k.x * fa.direction + k.y * fb.direction + k.z * fc.direction;

    bool over = isOvercoat(root.id, fur.share);
    Coat coat = fur.under;
    if (over) coat = fur.over;
    float own = lengthAt(root, fa.furLength, fb.furLength, fc.furLength, fur);
    Strand s = bendStrand(position, n, painted, own, coat, root.id, pullAt(fur, position, seconds));
    float width = within(coat.width, 0.0f, 10.0f);
    s.width = width > 0.0f ? width : autoWidth;
    s.coat = over ? 0u : 1u;
    s.keep = keepAt(root, fa.density, fb.density, fc.density);
    return s;
}

// Weights of the weightless direction and of the end in the point of the spine at t:
// origin + scale * (x * weightless + y * end). Linear in the two, so that they may be transformed
// once for all points of a hair.
vec2 strandWeights(Strand s, float t) {
    if (isRod(s)) return rodWeights(s.rod, t);
    return vec2(t * (1.0f - t), t * t);
}

// The same in the spine of the guide.
vec2 guideWeights(Strand s, float t) {
    if (isRod(s)) return rodWeights(s.guideRod, t);
    return vec2(t * (1.0f - t), t * t);
}

// True where hair of the coat may be more than its spine.
bool isShapedCoat(Coat coat) {
    return coat.clump > 0.0f || coat.curlRadius > 0.0f || coat.frizz > 0.0f;
}

// True where the hair is more than its spine: gathered, curled or frizzy.
bool isShaped(Strand s) { return s.clump > 0.0f || s.curl > 0.0f || s.frizz > 0.0f; }

// Unit direction of the spine at t, towards the tip. The curve's derivative is never shorter than
// 0.7 scale, that of a rod than 0.1, so there is nothing to guard.
vec3 spineTangent(Strand s, float t) {
    if (isRod(s)) {
        vec2 k = rodSlope(s.rod, t);
        return (k.x * s.weightless + k.y * s.end) * (1.0f / sqrt(dot(k, k)));
    }
    vec3 d = (1.0f - 2.0f * t) * s.weightless + (2.0f * t) * s.end;
    return d * (1.0f / sqrt(dot(d, d)));
}

// Smooth noise in [-1,1] along a hair, of a random value at every whole number.
float frizzNoise(uint stream, float x) {
    float knot = floor(x);
    float f = x - knot;
    uint k = uint(knot);
    return mix(2.0f * rand01(stream + k) - 1.0f, 2.0f * rand01(stream + k + 1u) - 1.0f,
               f * f * (3.0f - 2.0f * f));
}

// The point at t from the root: the spine, then clump, curl and frizz in this order, all of them 0
// at the root, and what dips below the skin's plane lifted onto it.
vec3 shapedOffset(Strand s, float t) {
    vec2 k = strandWeights(s, t);
    vec3 p = s.scale * (k.x * s.weightless + k.y * s.end);
    if (s.clump > 0.0f) {
        vec2 g = guideWeights(s, t);
        vec3 guide = s.guideOffset + g.x * s.guideWeightless + g.y * s.guideEnd;
        p = mix(p, guide, s.clump * pow(t, s.clumpShape));
    }
    if (s.curl > 0.0f || s.frizz > 0.0f) {
        vec3 n = cross(s.binormal, spineTangent(s, t));
        float turn = 6.2831853f * (s.curlTurns * t + rand01(s.id + kDrawCurl));
        float x = s.curl * cos(turn);
        float y = s.curl * sin(turn);
        if (s.frizz > 0.0f) {
            x += s.frizz * frizzNoise(s.id + kDrawFrizz, s.frizzWaves * t);
            y += s.frizz * frizzNoise(s.id + kDrawFrizz + 24u, s.frizzWaves * t);
        }
        p = p + t * (x * n + y * s.binormal);
    }
    return p - min(0.0f, dot(p, s.normal)) * s.normal;
}

// Point of the spine at t in [0,1], root to tip; world. What of a rod that lies nearly flat dips
// below the skin's plane, up to a hundredth of its length, is lifted onto it.
vec3 spinePoint(Strand s, float t) {
    vec2 k = strandWeights(s, t);
    vec3 p = s.scale * (k.x * s.weightless + k.y * s.end);
    if (s.nearSkin != 0u) {
        float above = k.x * dot(s.weightless, s.normal) + k.y * dot(s.end, s.normal);
        p = p - (s.scale * min(0.0f, above)) * s.normal;
    }
    return s.origin + p;
}

// Point of the hair at t; world.
vec3 strandPoint(Strand s, float t) {
    if (isShaped(s)) return s.origin + shapedOffset(s, t);
    return spinePoint(s, t);
}

// Unit direction of the hair at t, towards the tip.
vec3 strandTangent(Strand s, float t) {
    vec3 along = spineTangent(s, t);
    if (!isShaped(s)) return along;
    return safeUnit(shapedOffset(s, min(t + 0.01f, 1.0f)) - shapedOffset(s, max(t - 0.01f, 0.0f)),
                    along);
}

// Corner k of a tube's ring at t: a unit vector from the hair's axis, in the plane across the unit
// `tangent`; where the first one is differs from hair to hair. As a NURBS surface the tube is the spine's Bezier curve swept by this ring.
vec3 tubeNormal(Strand s, vec3 tangent, uint k, uint sides) {
    vec3 n = safeUnit(cross(s.binormal, tangent), s.normal);
    float turn = 6.2831853f * (float(k) / float(sides) + rand01(s.id + kDrawTwist));
    return cos(turn) * n + sin(turn) * cross(tangent, n);
}

// Radius of the corners of a ring of so many sides, in radii of the round hair: a polygon is seen
// as wide on average as the circle of its perimeter.
float tubeScale(uint sides) {
    float x = 3.1415927f / float(sides);
    return x / sin(x);
}

// Sides that keep a ring of a hair so many pixels wide within a quarter of a pixel of round.
uint sidesFor(float pixels) {
    if (!(pixels > 1.0f)) return 3u;
    return pixels > 6.0f ? 8u : (pixels > 3.0f ? 6u : 4u);
}

// The paper's shading normal where the hair runs along the unit `tangent`. Polylines and ribbons:
// perpendicular to it in the plane in which the hair bends, on the convex side, then turned about
// the hair by its twist. Lines and curves: that of the skin.
vec3 strandNormal(Strand s, vec3 tangent) {
    if (s.style == kStyleLine || s.style == kStyleCurve) return s.normal;
    vec3 upright = safeUnit(cross(s.binormal, tangent), s.normal);
    return s.cosTwist * upright + s.sinTwist * cross(tangent, upright);
}

// Diameter at t, m. taper is the share lost at the tip.
float strandWidth(Strand s, float taper, float t) { return s.width * (1.0f - taper * t); }

// How far the chords of a spine drawn with so many segments stray from it at most, m: N chords of a
// parabola miss it by |second derivative| / (8 N^2).
float chordError(Strand s, float segments) {
    if (isRod(s)) return s.scale * s.rodBend / (8.0f * segments * segments);
    vec3 bend = s.end - s.weightless;
    return s.scale * sqrt(dot(bend, bend)) / (4.0f * segments * segments);
}

// Segments that keep the chord of a hair within `tolerance` (m), in [1,32]: as chordError, and at
// least six for each turn of a curl and two for each wave of frizz.
uint segmentsFor(Strand s, float tolerance) {
    float asked = sqrt(chordError(s, 1.0f) / max(tolerance, 1e-30f));
    if (s.clump > 0.0f) asked = max(asked, 6.0f);
    if (s.curl > tolerance) asked = max(asked, 8.0f * s.curlTurns);
    if (s.frizz > tolerance) asked = max(asked, 2.0f * s.frizzWaves);
    return uint(min(max(ceil(asked), 1.0f), 32.0f));
}
