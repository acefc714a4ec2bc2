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

// Below 2^125, so that 1/x is no denormal, which GPUs may take for 0. A test of the bits, because
// GLSL compilers may assume that no value is NaN and turn comparisons around.
bool finite1(float x) { return (floatBitsToUint(x) & 0x7fffffffu) < 0x7e000000u; }

bool finite3(vec3 v) { return finite1(v.x) && finite1(v.y) && finite1(v.z); }

// v as a unit vector; `fallback` where v has no direction: zero, tiny, infinite or NaN.
vec3 safeUnit(vec3 v, vec3 fallback) {
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

// Weights of the three corners from Root.bary; they add up to 1 and none is negative.
vec3 baryWeights(uint bary) {
    float a = float(bary & 65535u) * (1.0f / 65535.0f);
    float b = float(bary >> 16u) * (1.0f / 65535.0f);
    return vec3(a, b, max(0.0f, 1.0f - a - b));
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

bool isOvercoat(uint id, float share) { return rand01(id + kDrawCoat) < share; }

// The direction in which a hair leaves the skin: between the normal and the painted direction,
// displaced at the tip by a random vector. Unit, never below the skin plane.
vec3 weightlessDirection(vec3 n, vec3 painted, Coat coat, uint id) {
    vec3 w = safeUnit((1.0f - coat.directionWeight) * n + coat.directionWeight * painted, n);
    if (coat.endRandomness > 0.0f)
        w = safeUnit(w + coat.endRandomness * randomInBall(id), n);
    float c = dot(w, n);
    return c < 0.0f ? safeUnit(w - (2.0f * c) * n, n) : w;
}

// A hair that starts at `root` on a skin with unit normal n. `painted` in the world; spineLength
// is the length of this hair along the curve. Gravity is that of the paper, section 3.5:
// floppiness times the cosine of the hair's angle to the normal, taken off along "up"; a small pull
// towards the combed side decides where a hair falls that stands upright.
Strand bendStrand(vec3 root, vec3 n, vec3 painted, float spineLength, Coat coat, uint id,
                  vec3 gravityDirection, float gravity) {
    vec3 w = weightlessDirection(n, painted, coat, id);
    float c = max(0.0f, dot(w, n));
    float floppiness = min(max(1.0f - coat.stiffness, 0.02f), 1.0f);
    float load = floppiness * min(max(gravity, 0.0f), 1.0f) * c;

    vec3 across = finite3(painted) ? painted - dot(painted, n) * n : vec3(0.0f, 0.0f, 0.0f);
    vec3 tangent = dot(across, across) > 1e-6f ? safeUnit(across, anyTangent(n)) : anyTangent(n);
    vec3 end = safeUnit(w + load * gravityDirection + (0.02f * load) * tangent, tangent);
    float m = max(0.0f, 1.0f - dot(w, end));

    Strand s;
    s.origin = root;
    s.spineLength = spineLength;
    s.weightless = w;
    s.end = end;
    s.scale = spineLength / arcOfUnitCurve(m);
    vec3 bend = cross(end, w);
    s.binormal = dot(bend, bend) > 1e-12f ? safeUnit(bend, anyTangent(w))
                                          : safeUnit(cross(tangent, w), anyTangent(w));
    float twist = 3.1415927f * coat.normalRandomness * (2.0f * rand01(id + kDrawTwist) - 1.0f);
    s.cosTwist = cos(twist);
    s.sinTwist = sin(twist);
    s.normal = n;
    s.tone = 1.0f + coat.colorNoise * (2.0f * rand01(id + kDrawTone) - 1.0f);
    s.width = 0.0f;
    s.coat = 0u;
    s.keep = 0.0f;
    s.pad0 = 0.0f;
    return s;
}

// A length that a hair may have; 0 for none, also for NaN.
float sanitizedLength(float asked) { return asked > 1e-12f && asked <= 1e6f ? asked : 0.0f; }

// The hair that grows from a root on a triangle with these corners. Corners, painted values and
// gravity in the world; autoWidth (m) is used where the coat leaves its width at 0.
Strand growStrand(Root root, SkinVertex a, SkinVertex b, SkinVertex c, FurVertex fa, FurVertex fb,
                  FurVertex fc, Fur fur, float autoWidth) {
    vec3 k = baryWeights(root.bary);
    vec3 position = k.x * a.position + k.y * b.position + k.z * c.position;
    vec3 faceNormal = safeUnit(cross(b.position - a.position, c.position - a.position),
                               vec3(0.0f, 1.0f, 0.0f));
    vec3 sum = k.x * a.normal + k.y * b.normal + k.z * c.normal;
    vec3 n = dot(sum, sum) > 1e-6f ? safeUnit(sum, faceNormal) : faceNormal;
    vec3 painted = k.x * fa.direction + k.y * fb.direction + k.z * fc.direction;
    float painted01 = k.x * fa.density + k.y * fb.density + k.z * fc.density;
    float asked = k.x * fa.furLength + k.y * fb.furLength + k.z * fc.furLength;

    bool over = isOvercoat(root.id, fur.share);
    Coat coat = fur.under;
    if (over) coat = fur.over;
    float own = sanitizedLength(sanitizedLength(asked) * coat.relativeLength);
    Strand s = bendStrand(position, n, painted, own, coat, root.id, fur.gravityDirection,
                          fur.gravity);
    s.width = coat.width > 0.0f ? coat.width : autoWidth;
    s.coat = over ? 0u : 1u;
    s.keep = painted01 > 0.0f ? min(painted01, 1.0f) : 0.0f;
    return s;
}

// Weights of the weightless direction and of the end in the point at t: point(t) = origin +
// scale * (x * weightless + y * end). Linear in the two, so that they may be transformed once for
// all points of a hair.
vec2 strandWeights(float t) { return vec2(t * (1.0f - t), t * t); }

// Point of the hair at t in [0,1], root to tip; world.
vec3 strandPoint(Strand s, float t) {
    vec2 k = strandWeights(t);
    return s.origin + s.scale * (k.x * s.weightless + k.y * s.end);
}

// Unit direction of the hair at t, towards the tip. The curve's derivative is never shorter than
// 0.7, so there is nothing to guard.
vec3 strandTangent(Strand s, float t) {
    vec3 d = (1.0f - 2.0f * t) * s.weightless + (2.0f * t) * s.end;
    return d * (1.0f / sqrt(dot(d, d)));
}

// The paper's shading normal where the hair runs along the unit `tangent`: perpendicular to it in
// the plane in which the hair bends, on the convex side, then turned about the hair by its twist.
vec3 strandNormal(Strand s, vec3 tangent) {
    vec3 upright = safeUnit(cross(s.binormal, tangent), s.normal);
    return s.cosTwist * upright + s.sinTwist * cross(tangent, upright);
}

// Diameter at t, m. taper is the share lost at the tip.
float strandWidth(Strand s, float taper, float t) { return s.width * (1.0f - taper * t); }
