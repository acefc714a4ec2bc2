// shell_shade.glsl -- what a place on the skin knows of its fur (shell.vert), and the look of a hair
// that a shell shows there.

in vec3 outer;
in vec3 place;
in vec3 normal;
in vec3 toward;
in vec3 toKey;
in vec3 overA;
in vec3 overB;
in vec3 underA;
in vec3 underB;
in vec3 overAcross;
in vec3 underAcross;
in float top;
in float bend;
in float skyward;
in float density;
in float furLength;
in vec3 tint;
in vec3 bare;
in vec2 uv;
#ifdef TEXTURED
layout(location = 1) uniform float layer;  // of the base-color textures
#endif

struct Hit {
    float way;     // m along the ray; 1e30 = none
    float t;
    float across;  // from the middle of the hair, in half widths
    uint id;
    bool over;
};

// What the light here makes of a hair of this color, under a coat of optical depth `depth`.
vec3 litHair(Hit hit, Coat coat, vec3 base, float depth, vec3 n, vec3 eye) {
    Strand s;
    s.weightless = hit.over ? overA : underA;
    s.end = hit.over ? overB : underB;
    s.binormal = safeUnit(hit.over ? overAcross : underAcross, anyTangent(n));
    float twist = 3.1415927 * within(coat.normalRandomness, 0.0, 1.0) *
                  (2.0 * rand01(hit.id + kDrawTwist) - 1.0);
    s.cosTwist = cos(twist);
    s.sinTwist = sin(twist);
    s.normal = n;
    s.tone = 1.0 + within(coat.colorNoise, 0.0, 1.0) * (2.0 * rand01(hit.id + kDrawTone) - 1.0);
    s.style = coat.style;
    s.clump = 0.0;
    s.curl = 0.0;
    s.frizz = 0.0;
    s.droop = kDroopPaper;
    Light light = frame.light;  // as seen from the skin at rest
    light.toKey = safeUnit(toKey, n);
    light.sky = skyLight(frame.light, vec3(0.0, skyward, 0.0));
    light.ground = light.sky;
    if (coat.style == kStyleRibbon || coat.style == kStyleTube)
        return roundRadiance(s, coat, light, base, hit.t, eye, depth);
    return fiberRadiance(s, coat, light, base, hit.t, eye, depth);
}

vec3 radianceOf(Hit hit, vec3 n, vec3 eye) {
    Coat coat = fur.under;
    if (hit.over) coat = fur.over;
    vec3 skin = bare;
#ifdef TEXTURED
    skin *= textureLod(baseColors, vec3(uv, layer), 0.0).rgb;
#endif
    vec3 base = tint * mix(vec3(1.0), skin, fur.skinColor);
    float depth = depthInCoat(fur, frame.hairsPerArea * density, furLength, frame.overWidth,
                              frame.underWidth, hit.over ? 0u : 1u, hit.t);
    return litHair(hit, coat, base, depth, n, eye);
}

// Pixels that a metre is wide there.
float pixelsPerMetreAt(vec3 place) {
    return frame.perspective > 0.0
               ? frame.pixelsPerMetre / max(dot(place - frame.eye, frame.forward), 1e-6)
               : frame.pixelsPerMetre;
}
