// shell_curve.glsl -- the mean hair that shells cut, and how single hairs stray from it.

// The highest hair of a coat over a skin of unit normal n.
struct Hair {
    vec3 a, b;     // m, along the skin: t(1-t) a + t^2 b
    float za;      // m, over the skin
    float zb;
    float spread;  // of the hairs' heights, shell_data.glsl
};

// Of this mean hair over a skin that bends so much, 1/m, where it goes.
Hair hairOf(Curve mean, float spread, vec3 n, float bend) {
    Curve c = overBent(highest(mean, spread), n, bend);
    Hair h;
    h.za = dot(c.a, n);
    h.zb = dot(c.b, n);
    h.a = c.a - h.za * n;
    h.b = c.b - h.zb * n;
    h.spread = spread;
    return h;
}

// t where it is highest: before its tip where it hangs.
float peakOf(Hair h) { return h.za > 2.0 * h.zb ? 0.5 * h.za / (h.za - h.zb) : 1.0; }

float heightAt(Hair h, float t) { return max(0.0, t * ((1.0 - t) * h.za + t * h.zb)); }
vec3 asideAt(Hair h, float t) { return t * ((1.0 - t) * h.a + t * h.b); }

// Where on its way up a hair is at a height; at the tip where it does not get so high.
float tAtHeight(Hair h, float height) {
    float d = h.za * h.za + 4.0 * (h.zb - h.za) * height;
    return d >= 0.0 ? clamp(2.0 * height / max(h.za + sqrt(d), 1e-20), 0.0, 1.0) : 1.0;
}

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

// How much wider than itself a ray sees a hair that leans by `lean` while the ray goes on by `step`
// and both rise by `rise`, m: it is cut into an ellipse. Its square.
float stretchOf(vec3 n, float rise, vec3 lean, vec3 step) {
    float slant = dot(n, cross(lean, step));
    return 1.0 + min(slant * slant / max(rise * rise * dot(step, step), 1e-20), 15.0);
}

// From root to root of the tile, m.
float spacingOf(ShellCoat coat, Level level) {
    return coat.period * exp2(0.5 * float(level.tile)) / sqrt(float(kTileHairs));
}
