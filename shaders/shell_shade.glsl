// shell_shade.glsl -- the look of a hair that a shell shows at a place on the skin.

struct Hit {
    float way;     // m along the ray; 1e30 = none
    float t;
    uint id;
    vec3 root;     // m, on the skin at rest
    bool over;
};

#ifdef SHADOWS
#include "shell_shadow.glsl"
#else
float keyPast(Hit hit, Ground g) { return 1.0; }
#endif

// What the light here makes of a hair of this color, under a coat of optical depth `depth`, where
// the key light is so many times as strong as on average.
vec3 litHair(Hit hit, Coat coat, vec3 base, float depth, float key, Ground g) {
    vec3 n = g.normal;
    uint id = pcg(hit.id);
    Strand s;
    s.weightless = hit.over ? g.overA : g.underA;
    s.end = hit.over ? g.overB : g.underB;
    s.binormal = safeUnit(hit.over ? g.overAcross : g.underAcross, anyTangent(n));
    float twist = twistOf(coat, id);
    s.cosTwist = cos(twist);
    s.sinTwist = sin(twist);
    s.normal = n;
    s.tone = toneOf(coat, id);
    s.style = coat.style;
    s.clump = 0.0;
    s.curl = 0.0;
    s.frizz = 0.0;
    s.droop = kDroopPaper;
    Light light = frame.light;  // as seen from the skin at rest
    light.toKey = safeUnit(g.toKey, n);
    light.key *= key;
    light.sky = skyLight(frame.light, vec3(0.0, g.skyward, 0.0));
    light.ground = light.sky;
    if (coat.style == kStyleRibbon || coat.style == kStyleTube)
        return roundRadiance(s, coat, light, base, hit.t, g.eye, depth);
    return fiberRadiance(s, coat, light, base, hit.t, g.eye, depth);
}

vec3 radianceOf(Hit hit, Ground g) {
    Coat coat = fur.under;
    if (hit.over) coat = fur.over;
    vec3 base = g.tint * mix(vec3(1.0), g.bare, fur.skinColor);
    float depth = depthInCoat(fur, frame.hairsPerArea * g.density, g.furLength, frame.overWidth,
                              frame.underWidth, hit.over ? 0u : 1u, hit.t);
    return litHair(hit, coat, base, depth, keyPast(hit, g), g);
}
