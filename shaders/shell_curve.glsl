// shell_curve.glsl -- the mean hair of a coat over a place on the skin, and how single hairs stray.

// Mean hair of a coat over a skin of unit normal n.
struct Hair {
    vec3 a, b;   // m, along the skin: t(1-t) a + t^2 b
    float za;    // m, over the skin
    float zb;
};

Hair hairOf(vec3 a, vec3 b, vec3 n) {
    Hair h;
    h.za = dot(a, n);
    h.zb = dot(b, n);
    h.a = a - h.za * n;
    h.b = b - h.zb * n;
    return h;
}

float heightAt(Hair h, float t) { return max(0.0, t * ((1.0 - t) * h.za + t * h.zb)); }
// t where it is highest: hair that hangs, before its tip.
float peakOf(Hair h) { return h.za > 2.0 * h.zb ? 0.5 * h.za / (h.za - h.zb) : 1.0; }
vec3 asideAt(Hair h, float t) { return t * ((1.0 - t) * h.a + t * h.b); }

// How hairs lean apart: together with their neighbors, so that none has to be looked for.
struct Stray {
    float reach;      // m, at the tip
    float perMetre;   // waves
};

// Waves of ten hairs; as far as a random end takes a hair on average, but never so far that hairs
// would fold over each other.
Stray strayOf(ShellCoat coat, float furLength) {
    const float kMeanOfBall = 0.4472136;  // root mean square of each coordinate, 1 / sqrt(5)
    const float kMeanOfWave = 0.7302967;  // of a parabola's waves, sqrt(8 / 15)
    float wave = 10.0 * coat.period / sqrt(float(kTileHairs));
    return Stray(min(coat.stray * furLength * (kMeanOfBall / kMeanOfWave), 0.1 * wave), 1.0 / wave);
}

// From root to root, m, of the hairs that this level of detail draws.
float spacingOf(ShellCoat coat, Level level) {
    return coat.period * exp2(0.5 * float(level.tile)) / sqrt(float(kTileHairs));
}
