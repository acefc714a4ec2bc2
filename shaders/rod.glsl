// rod.glsl -- a hair as a heavy elastic rod: its curve from the table of core/elastica.h.
//
// Part of strand.glsl, in its dialect. The hair is clamped at the root and bends under its own
// weight. Its curve is a polynomial of degree 6 in t whose coefficients the table holds over the
// angle between root and "up" and over the load; so points and tangents come from the same numbers,
// and as a NURBS the hair is a single Bezier curve.

const float kUprightBelow = 0.52359878f;  // rad from up; below it the load fades to 0 at upright
const float kContactMargin = 0.001f;      // rad that the tip stays above the skin
const float kNearSkin = 0.1f;  // lengths; where the tip is higher, no point of the hair is near

#ifndef __cplusplus
#ifdef RODS
layout(std430, binding = 15) readonly buffer RodTable { vec4 rodTable[]; };
vec4 rodTexel(uint i) { return rodTable[i]; }
const bool kRods = true;
#else  // a program that draws none
vec4 rodTexel(uint i) { return vec4(0.0); }
const bool kRods = false;
#endif
#endif

bool isRodCoat(Coat coat) { return kRods && coat.droop == kDroopElastica; }

bool isRod(Strand s) { return kRods && s.droop == kDroopElastica; }

// Angle of (x, y) from the x axis for y >= 0: [0, pi], within 3e-7. Abramowitz and Stegun,
// "Handbook of Mathematical Functions", 1964, 4.4.49. (Drivers round atan each in its own way.)
float angleOf(float x, float y) {
    float a = abs(x);
    float q = min(a, y) / max(max(a, y), 1e-30f);
    float z = q * q;
    float zz = z * z;  // in pairs, which do not wait for each other
    float high = (0.1065626393f - 0.0752896400f * z) + (0.0429096138f - 0.0161657367f * z) * zz +
                 0.0028662257f * (zz * zz);
    float p = (-0.3333314528f + 0.1999355085f * z) + (-0.1420889944f + high * z) * zz;
    p = q + q * z * p;
    if (y > a) p = 1.5707963f - p;
    return x < 0.0f ? 3.1415927f - p : p;
}

// Cube root of x in [0,1]: a third of the exponent, then twice Halley's method.
float cubeRoot(float x) {
    x = max(x, 1e-24f);
    float r = uintBitsToFloat(floatBitsToUint(x) / 3u + 709921077u);
    for (uint i = 0u; i < 2u; ++i) {
        float cube = r * r * r;
        r = r * (cube + 2.0f * x) / (2.0f * cube + x);
    }
    return r;
}

// Places in the table, [0,1] each: of a root at this angle from up, and of a load.
float rodColumn(float angle) {
    float r = cubeRoot(angle * 0.31830989f);
    return min(r * r, 1.0f);
}
float rodRow(float load) { return load / (load + 10.0f) * ((kMostLoad + 10.0f) / kMostLoad); }

struct RodPlace {  // between four nodes of the table
    uint low;      // first texel of the least of them
    vec4 shares;   // of that one, the next load, the next angle, both
};

RodPlace rodPlace(float column, float row) {
    float x = column * float(kRodNodes - 1u);
    float y = row * float(kRodNodes - 1u);
    uint i = min(uint(x), kRodNodes - 2u);
    uint j = min(uint(y), kRodNodes - 2u);
    RodPlace at;
    at.low = kRodTexels * (i * kRodNodes + j);
    x -= float(i);
    y -= float(j);
    at.shares = vec4((1.0f - x) * (1.0f - y), (1.0f - x) * y, x * (1.0f - y), x * y);
    return at;
}

vec4 rodValue(RodPlace at, uint k) {
    uint low = at.low + k;
    uint high = low + kRodTexels * kRodNodes;
    return at.shares.x * rodTexel(low) + at.shares.y * rodTexel(low + kRodTexels) +
           at.shares.z * rodTexel(high) + at.shares.w * rodTexel(high + kRodTexels);
}

mat3x4 rodCurveAt(RodPlace at) {
    return mat3x4(rodValue(at, 0u), rodValue(at, 1u), rodValue(at, 2u));
}

mat3x4 rodCurve(float column, float row) { return rodCurveAt(rodPlace(column, row)); }

// The share of its load that bends hair at this angle from up.
float rodFade(float angle) {
    float x = min(angle / kUprightBelow, 1.0f);
    return x * x * (3.0f - 2.0f * x);
}

// The load of the rod that hangs like hair of the paper's rule under the load g = floppiness *
// pull * cosine, [0,1]: the best fit over all directions, up to 11.4.
float rodLoadLike(float g) {
    float cube = g * g * g;
    return 7.82f * g + cube * cube * (1.43f + 2.15f * g);
}

// The load of a coat's hair where its cosine to the skin's normal is c and it is pulled with this
// strength, [0,1]. A soft hair is pulled whichever way it lies on the skin, as in nature.
float rodLoad(Coat coat, float c, float strength) {
    float softness = within(coat.softness, 0.0f, 1.0f);
    float floppiness = within(1.0f - coat.stiffness, 0.02f, 1.0f);
    float softer = 1.0f + 3.443f * softness;
    return min(rodLoadLike(floppiness * within(strength, 0.0f, 1.0f) * mix(c, 1.0f, softness)) *
                   (softer * softer * softer), kMostLoad);
}

// Weights of the two directions of its plane in the point at t of a rod: along the root, across.
vec2 rodWeights(mat3x4 rod, float t) {
    float square = t * t;
    vec4 k = rod * vec3(t, t * square, t * square * square);
    return vec2(k.x + t * k.z, k.y + t * k.w);
}

// Their derivative by t.
vec2 rodSlope(mat3x4 rod, float t) {
    float square = t * t;
    vec4 odd = rod * vec3(1.0f, 3.0f * square, 5.0f * square * square);
    vec4 even = rod * vec3(2.0f * t, 4.0f * t * square, 6.0f * t * square * square);
    return vec2(odd.x + even.z, odd.y + even.w);
}

// Gauss's rule with 12 points.
const float kGaussPlace[12] = {0.43738330f, 0.31608425f, 0.20634102f, 0.11504866f,
                               0.56261670f, 0.68391575f, 0.79365898f, 0.88495134f,
                               0.04794137f, 0.00921968f, 0.99078032f, 0.95205863f};
const float kGaussWeight[12] = {0.12457352f, 0.11674627f, 0.10158371f, 0.08003916f,
                                0.12457352f, 0.11674627f, 0.10158371f, 0.08003916f,
                                0.05346966f, 0.02358767f, 0.02358767f, 0.05346966f};

// Length of the curve, the integral of its derivative's: within 1e-5. A loop over plain numbers, of
// which the CPU takes four at once.
float rodLength(mat3x4 rod) {
    vec4 a = rod[0];
    vec4 b = rod[1];
    vec4 c = rod[2];
    float x0 = a.x, x1 = 2.0f * a.z, x2 = 3.0f * b.x, x3 = 4.0f * b.z, x4 = 5.0f * c.x;
    float y0 = a.y, y1 = 2.0f * a.w, y2 = 3.0f * b.y, y3 = 4.0f * b.w, y4 = 5.0f * c.y;
    float x5 = 6.0f * c.z, y5 = 6.0f * c.w;
    float part[12];
    for (int i = 0; i < 12; ++i) {
        float t = kGaussPlace[i];
        float x = ((((x5 * t + x4) * t + x3) * t + x2) * t + x1) * t + x0;
        float y = ((((y5 * t + y4) * t + y3) * t + y2) * t + y1) * t + y0;
        part[i] = kGaussWeight[i] * sqrt(x * x + y * y);
    }
    float sum = 0.0f;
    for (int i = 0; i < 12; ++i) sum += part[i];
    return sum;
}

// The load, as a row of the table, at which the tip of the hair s, whose root is at this angle from
// up, reaches the skin.
float rodContact(Strand s, float angle, float column) {
    // From the root's direction down to the skin, in the plane of the hair.
    float clear = angleOf(-dot(s.end, s.normal), dot(s.weightless, s.normal)) - kContactMargin;
    float share = clamp(clear / max(3.1415927f - angle, 1e-6f), 0.0f, 1.0f);
    return rodValue(rodPlace(column, share), 3u).y;
}

// The hair s, that leaves the skin along its weightless direction, as a rod under this load, where
// `pull` pulls and `painted` is where it is combed. Of all equilibria the one into which it hangs;
// hair that stands nearly upright is stiffer than nature, so that no jump is seen where it could
// fall to either side; and a load that would push the tip through the skin is lessened.
Strand bendRod(Strand s, float load, vec3 pull, vec3 painted) {
    vec3 up = safeUnit(-pull, s.normal);
    float along = dot(s.weightless, up);
    vec3 level = along * s.weightless - up;  // across the root, downwards
    float across = sqrt(dot(level, level));
    if (across > 1e-6f) {
        s.end = level * (1.0f / across);
    } else {
        vec3 fallback = combedTangent(painted, s.normal);
        s.end = safeUnit(fallback - dot(fallback, s.weightless) * s.weightless,
                         anyTangent(s.weightless));
    }
    float angle = angleOf(along, across);
    float column = rodColumn(angle);
    float row = rodRow(load * rodFade(angle));
    RodPlace at = rodPlace(column, row);
    s.rod = rodCurveAt(at);
    vec2 tip = rodWeights(s.rod, 1.0f);
    if (tip.x * dot(s.weightless, s.normal) + tip.y * dot(s.end, s.normal) < kNearSkin) {
        s.nearSkin = 1u;
        at = rodPlace(column, min(row, rodContact(s, angle, column)));
        s.rod = rodCurveAt(at);
    }
    if (s.style == kStyleLine) {
        tip = rodWeights(s.rod, 1.0f);
        vec3 straight = safeUnit(tip.x * s.weightless + tip.y * s.end, s.weightless);
        s.end = safeUnit(s.end - dot(s.end, straight) * straight, anyTangent(straight));
        s.weightless = straight;
        s.rod = mat3x4(0.0f);
        s.rod[0].x = 1.0f;
    }
    s.droop = kDroopElastica;
    s.rodBend = s.style == kStyleLine ? 0.0f : rodValue(at, 3u).x;
    s.scale = s.spineLength / rodLength(s.rod);
    s.binormal = cross(s.end, s.weightless);
    return s;
}
