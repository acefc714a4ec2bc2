// shell_ray.glsl -- the way of the ray behind a pixel through fur, and how hair stands on it.

struct Ray {         // through the fur over a ball
    float top;       // m, height where it begins
    float bend;      // 1/m, curvature of the ball
    float cosine;    // of its angle with the normal
    float sine;
    float far;       // 1 + bend * top
};

// Where the ray is at a height, m along it: on its way down, or up again; where it does not get so
// low, where it is lowest.
struct Way {
    float way;
    bool there;
};
Way wayTo(Ray r, float height, bool up) {
    float drop = (r.top - height) * (2.0 + r.bend * (r.top + height));
    float b = r.cosine * r.far;
    float d = b * b - r.bend * drop;
    float sum = b + sqrt(max(d, 0.0));
    return Way(up || d <= 0.0 ? sum / r.bend : drop / sum, d > 0.0);
}

// How far on the skin the ray has come, m.
float arcOf(Ray r, float way) {
    float u = max(r.far - r.bend * way * r.cosine, 0.25);
    float x = r.bend * way * r.sine / u;
    return way * r.sine / (u * (1.0 + 0.28 * x * x));  // atan(x) = x / (1 + 0.28 x^2)
}

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
vec3 asideAt(Hair h, float t) { return t * ((1.0 - t) * h.a + t * h.b); }

// Where the ray of a pixel enters the fur.
struct Entry {
    Ray ray;
    vec3 below;  // the place on the skin
    vec3 ahead;  // unit, along the skin
    bool there;
};

// Over a skin of unit normal n; `eye` is the unit direction to the eye.
Entry entryOf(vec3 n, vec3 eye) {
    Entry entry;
    entry.ray.top = top;
    entry.ray.cosine = dot(n, eye);
    entry.there = top > 0.0 && entry.ray.cosine > 1e-3;
    vec3 across = entry.ray.cosine * n - eye;
    entry.ray.sine = sqrt(dot(across, across));
    entry.ahead = safeUnit(across, vec3(0.0));
    entry.below = place;
#ifdef SKIN
    // From the skin back to where the fur begins or the eye is, over a plane.
    float back = top / max(entry.ray.cosine, 0.15);
    if (frame.perspective > 0.0) back = min(back, distance(frame.eye, outer));
    entry.ray.top = back * entry.ray.cosine;
    entry.ray.bend = 0.0;
    entry.below -= (back * entry.ray.sine) * entry.ahead;
#else
    // Beyond these the skin folds over itself within the length of a hair.
    entry.ray.bend = clamp(bend, -0.5 / top, 8.0 / top);
#endif
    entry.ray.far = 1.0 + entry.ray.bend * entry.ray.top;
    return entry;
}
