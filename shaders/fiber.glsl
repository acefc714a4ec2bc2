// fiber.glsl -- the look of a hair: how much light it sends to the eye. Nothing else knows it.
// Same dialect as strand.glsl.

// Integral of the width of a hair of root width 1 from t to the tip.
float widthAbove(float taper, float t) { return (1.0f - t) * (1.0f - 0.5f * taper * (1.0f + t)); }

// Optical depth, looking straight down, of the coat above a point at height t of a hair: the
// width of all hairs above it per unit of area. hairsPerArea counts both coats at the painted
// density; furLength is the painted length, widths are those at the root.
float depthInCoat(Fur fur, float hairsPerArea, float furLength, float overWidth, float underWidth,
                  uint coat, float t) {
    float overLength = furLength * fur.over.relativeLength;
    float underLength = furLength * fur.under.relativeLength;
    float height = t * (coat == 0u ? overLength : underLength);
    float overT = height < overLength ? height / overLength : 1.0f;
    float underT = height < underLength ? height / underLength : 1.0f;
    return hairsPerArea *
           (fur.share * overLength * overWidth * widthAbove(fur.over.taper, overT) +
            (1.0f - fur.share) * underLength * underWidth * widthAbove(fur.under.taper, underT));
}

// Length of the component of l across the unit vector t. Exact also where they are parallel, where
// sqrt(1 - dot^2) is NaN for one pair in five.
float sineBetween(vec3 t, vec3 l) {
    vec3 c = cross(t, l);
    return sqrt(dot(c, c));
}

// Share of the light that multiple scattering lets through where straight rays are stopped: the
// optical depth counts only by this factor.
const float kStraightShare = 0.45f;

// Light that a coat lets through to optical depth `depth` from direction l over a skin of normal n.
float keyThroughCoat(float depth, vec3 n, vec3 tangent, vec3 l) {
    float slant = sineBetween(tangent, l) / max(dot(n, l), 0.05f);
    return exp(-kStraightShare * depth * min(slant, 20.0f));
}

// The same from all sides: fit to the integral over the hemisphere, within 0.008.
float skyThroughCoat(float depth) {
    float d = kStraightShare * depth;
    return 1.0f / (1.0f + 1.35f * d + 0.34f * d * d);
}

// Light from sky and ground on a surface that faces n.
vec3 skyLight(Light light, vec3 n) {
    return mix(light.ground, light.sky, 0.5f + 0.5f * n.y);
}

struct Reaching {  // what light arrives at a place in or under the coat
    float key;     // strength of the key light
    vec3 sky;      // radiance from all sides
};

struct FiberLight {  // what is the same around a hair, whatever normal it is shaded by
    vec3 ambient;    // radiance
    float sine;      // of the angle between hair and light
    vec3 diffuse;    // radiance where fully lit
    vec3 specular;   // radiance where the normal faces halfway
    vec3 halfway;    // unit, between light and eye
};

// What this light does at t of a hair that runs along the unit `tangent` there; base is the color
// of the skin at the root.
FiberLight fiberLitBy(Strand s, Coat coat, vec3 toKey, Reaching light, vec3 base, float t,
                      vec3 tangent, vec3 toEye) {
    float sinL = sineBetween(tangent, toKey);
    float sinV = sineBetween(tangent, toEye);
    float cosL = dot(tangent, toKey);
    float cosV = dot(tangent, toEye);

    vec3 color = s.tone * base * mix(coat.rootColor, coat.tipColor, t);
    FiberLight f;
    f.ambient = color * coat.ambient * light.sky;
    f.sine = sinL;
    f.diffuse = light.key * color * coat.diffuse;
    f.specular =
        light.key * pow(max(0.0f, sinL * sinV - cosL * cosV), coat.shininess) * coat.specular;
    f.halfway = safeUnit(toKey + toEye, toEye);
    return f;
}

// The same where `depth`, the optical depth of the coat above (depthInCoat), says how much of the
// light arrives.
FiberLight fiberLight(Strand s, Coat coat, Light light, vec3 base, float t, vec3 tangent,
                      vec3 toEye, float depth) {
    // The body stands between the key light and hairs on its far side.
    float lit = min(max(2.5f * dot(s.normal, light.toKey) + 0.5f, 0.0f), 1.0f);
    Reaching reaching;
    reaching.key = light.key * lit * keyThroughCoat(depth, s.normal, tangent, light.toKey);
    reaching.sky = skyThroughCoat(depth) * skyLight(light, s.normal);
    return fiberLitBy(s, coat, light.toKey, reaching, base, t, tangent, toEye);
}

// Radiance towards the eye of a hair, or of a side of it, that faces light and halfway so far: the
// cosines with its normal, 0 where it faces away. Kajiya and Kay, "Rendering fur with three
// dimensional textures", 1989, for diffuse and specular; half of the diffuse term and the strength of
// the highlight use the shading normal of Van Gelder and Wilhelms 1997, 3.7, so that each hair
// catches the light differently.
vec3 radianceFacing(FiberLight f, float key, float halfway) {
    return f.ambient + (0.5f * (f.sine + key)) * f.diffuse + halfway * f.specular;
}

// The same of what is shaded by this unit normal.
vec3 radianceOf(FiberLight f, vec3 shading, vec3 toKey) {
    return radianceFacing(f, max(0.0f, dot(shading, toKey)), max(0.0f, dot(shading, f.halfway)));
}

// The unit normal by which a side of a hair is shaded that faces `side`, unit and across the hair.
// Of a ribbon it is turned about the hair by its twist.
vec3 sideNormal(Strand s, vec3 tangent, vec3 side) {
    if (s.style == kStyleTube) return side;
    if (s.style == kStyleRibbon) return s.cosTwist * side + s.sinTwist * cross(tangent, side);
    return strandNormal(s, tangent);
}

// Mean of max(0, normal . l) over the width of a round hair whose middle is shaded by the unit normal
// `middle`: half the integral of max(0, cos(x - a)) cos(x) from one edge to the other.
float meanFacing(vec3 tangent, vec3 middle, vec3 l) {
    float across = sineBetween(tangent, l);
    float c = clamp(dot(middle, l) / max(across, 1e-6f), -1.0f, 1.0f);
    float s = sqrt(1.0f - c * c);
    return 0.25f * across * ((3.1415927f - angleOf(c, s)) * c + s);
}

// Radiance towards toEye (unit) at t of a thin line, under a coat of optical depth `depth`.
vec3 fiberRadiance(Strand s, Coat coat, Light light, vec3 base, float t, vec3 toEye, float depth) {
    vec3 tangent = strandTangent(s, t);
    FiberLight f = fiberLight(s, coat, light, base, t, tangent, toEye, depth);
    return radianceOf(f, strandNormal(s, tangent), light.toKey);
}

// The same of a ribbon or tube too narrow to tell its sides apart: the mean over its width.
vec3 roundRadiance(Strand s, Coat coat, Light light, vec3 base, float t, vec3 toEye, float depth) {
    vec3 tangent = strandTangent(s, t);
    FiberLight f = fiberLight(s, coat, light, base, t, tangent, toEye, depth);
    vec3 side = safeUnit(toEye - dot(toEye, tangent) * tangent, s.binormal);
    vec3 middle = sideNormal(s, tangent, side);
    return radianceFacing(f, meanFacing(tangent, middle, light.toKey),
                          meanFacing(tangent, middle, f.halfway));
}

// Color of the skin between the hairs, under a coat of this optical depth. Where the coat is dense
// the short hairs that nobody draws cover it: it takes the color of the undercoat's roots.
vec3 skinColor(Coat under, vec3 base, float depth) {
    float covered = 1.0f - exp(-depth);
    return base * mix(vec3(1.0f, 1.0f, 1.0f), under.rootColor, covered);
}

// Radiance of the skin between the hairs, under the entire coat.
vec3 skinRadiance(Light light, Coat under, vec3 base, vec3 n, float depth) {
    float lit = max(0.0f, dot(n, light.toKey));
    // As if hairs lean: straight light along upright hairs would reach the skin unhindered.
    float slant = max(sineBetween(n, light.toKey) / max(lit, 0.05f), 0.7f);
    float key = light.key * lit * exp(-kStraightShare * depth * slant);
    return skinColor(under, base, depth) *
           (skyThroughCoat(depth) * skyLight(light, n) + vec3(key, key, key));
}
