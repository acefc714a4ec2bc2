// shell.frag -- fur in a single pass: the ray behind a pixel goes through the layers of both coats
// until it meets a hair.
//
// A layer is the surface that the points at t of all hairs make, z(t) over the skin. Between two
// layers the ray is tested against the hairs' whole cross-sections (with PLAIN only at the layers):
// seen along its hairs, a slab is a short way on the skin, and what it touches are the roots within a
// hair's radius of that way.
//
// The skin is taken as a ball whose curvature is that of the skin in the direction of the ray, so that
// a ray at the silhouette leaves the fur again. Only the hair's place is wrong where the skin bends
// another way: never the depth of the skin, which hides what lies behind it.
#include "frame.glsl"
#include "strand.glsl"
#include "fiber.glsl"
#include "shell_data.glsl"
#include "shell_ground.glsl"
#include "shell_hair.glsl"
#include "shell_curve.glsl"
#include "shell_shade.glsl"

layout(binding = 4) uniform usamplerBuffer cornerRows;  // a Corner each
layout(binding = 5) uniform usamplerBuffer indices;     // of corners, by triangle of what was found
layout(binding = 2) uniform usampler2D found;  // shell_over.frag
layout(binding = 7) uniform usampler2D skinFound;  // the same of the skin, with SKIN
layout(binding = 8) uniform usamplerBuffer skinIndices;
layout(early_fragment_tests) in;
layout(location = 0) out vec4 color;   // alpha 1 = hair, 0.5 = none
layout(location = 1) out float depth;  // in the window

const uint kMostSteps = 256u;
#ifdef PLAIN
const float kInSlab = 0.5;  // where a layer lies in its slab
#else
const float kInSlab = 0.0;
#endif
// Of the way from root to root that a slab is long at most: two roots of a texel are then enough.
const float kLongestSlab = 1.0;

struct Ray {         // through the fur over a ball
    float top;       // m, height where it begins
    float bend;      // 1/m, curvature of the ball
    float bendAcross;  // of the skin across the ray
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

// How a ray goes through the layers: so that its way through each of them is about the same, of a
// ray that turns before it meets the skin too.
struct Course {
    float lowest;  // t there
    float bow;     // 0 where its height falls evenly, 1 where it turns in the end
};

Course courseOf(Ray ray, Hair hair, Way at, Way skin) {
    Course course = Course(0.0, 0.0);
#ifndef PLAIN
    float tip = heightAt(hair, 1.0);
    float closest = ray.far * ray.sine;  // to the middle of the ball, in radii
    float low = 0.0;
    if (!skin.there) {
        low = clamp((closest - 1.0) / ray.bend, 0.0, tip);
        course.lowest = tAtHeight(hair, low);
    }
    float sine = min(closest / (1.0 + ray.bend * tip), 1.0);
    float fall = (skin.way - at.way) * sqrt(1.0 - sine * sine);
    course.bow = clamp(fall / max(tip - low, 1e-20) - 1.0, 0.0, 1.0);
#endif
    return course;
}

// x from 1 at the tips to 0 where the ray is lowest.
float tOf(Course course, float x) {
    return mix(course.lowest, 1.0, x * (1.0 - course.bow + course.bow * x));
}

// The place on the skin whose hair the ray touches with its point at t.
vec3 rootAt(Ray ray, vec3 place, Hair hair, Stray stray, vec3 n, vec3 ahead, float way, float t) {
    vec3 root = arcOf(ray, way) * ahead - asideAt(hair, t);
    vec3 lean = waves(stray.perMetre * (place + root));
    root -= (t * stray.reach) * (lean - dot(lean, n) * n);
    return place + root - (0.5 * ray.bend * dot(root, root)) * n;
}

// Slabs that a coat needs where the way on the skin is so many times that from root to root.
float stepsFor(Ray ray, ShellCoat coat, float highest, float spacings) {
    float asked = float(shellLayers) * min(1.0, highest / ray.top);
#ifdef PLAIN
    // A hair that is cut into discs q of their diameter apart keeps 1 - q^2 / 6 of its depth.
    const float kApart = 0.5;
    if (shellLayers == 0u) asked = spacings * coat.period / (32.0 * kApart * coat.width);
#else
    asked = max(asked, max(spacings / kLongestSlab, 4.0));
#endif
    return asked;
}

Hit march(Ray ray, vec3 place, Hair hair, ShellCoat coat, uint coatNumber, Ground g, vec3 ahead,
          float pixels, Hit hit) {
    vec3 n = g.normal;
    float peak = peakOf(hair);  // what is beyond comes in no order
    float highest = heightAt(hair, peak);
    Level level = levelFor(pixels);
    Stray stray = strayOf(coat, g.furLength);
    Way at = wayTo(ray, min(heightAt(hair, 1.0), ray.top), false);
    Way skin = wayTo(ray, 0.0, false);
    Slab slab;
    slab.to = rootAt(ray, place, hair, stray, n, ahead, at.way, 1.0);
    slab.t.y = 1.0;
    slab.spread = hair.spread;
    vec3 end = rootAt(ray, place, hair, stray, n, ahead, skin.way, 0.0);
    // The normal where the roots are, about.
    Axes axes = axesOf(normalize(n + ray.bend * (0.5 * (slab.to + end) - place)), g.density);

    float spacing = spacingOf(coat, level);
    float asked = stepsFor(ray, coat, highest, distance(slab.to, end) / spacing);
    uint steps = uint(clamp(ceil(asked), 1.0, float(kMostSteps)));
    uint last = skin.there ? steps : 2u * steps;  // or out of the fur again
    if (!(highest > 0.0)) last = 0u;
    float dt = 1.0 / float(steps);
    Course course = courseOf(ray, hair, at, skin);
    vec3 aside = asideAt(hair, 1.0);
    float height = heightAt(hair, 1.0);
    for (uint i = 1u; i <= last; ++i) {
        Way before = at;
        vec3 asideBefore = aside;
        float heightBefore = height;
        slab.from = slab.to;
        slab.t.x = slab.t.y;
        slab.t.y = tOf(course, abs(1.0 - (float(i) - kInSlab) * dt));
        aside = asideAt(hair, slab.t.y);
        height = heightAt(hair, slab.t.y);
        at = wayTo(ray, min(height, ray.top), i > steps);
        slab.to = rootAt(ray, place, hair, stray, n, ahead, at.way, slab.t.y);
#ifdef PLAIN
        slab.from = slab.to;
        slab.t.x = slab.t.y;
        before = at;
        slab.stretch = 1.0;
#else
        slab.stretch = stretchOf(n, height - heightBefore, aside - asideBefore,
                                 slab.to - slab.from);
#endif
        // Over a ball hairs stand further apart than their roots.
        float spread = 1.0 + 0.5 * ray.bendAcross * (height + heightBefore);
        slab.stretch /= spread * spread;
        bool crossed = before.there || at.there;
        for (uint k = 0u, axis = axes.first; k < axes.count; ++k) {
            TileHit one = tileHit(slab, axis, coatNumber, coat, level, axes);
            float way = mix(before.way, at.way, one.along);
            if (one.along <= 1.0 && way < hit.way && crossed) {
                hit.way = way;
                hit.t = one.t;
                hit.id = one.id;
                hit.root = mix(slab.from, slab.to, one.along);
                hit.over = coatNumber == 0u;
            }
            axis += axes.step;
            axis -= axis > 2u ? 3u : 0u;
        }
        if (hit.way <= at.way && slab.t.x <= peak) break;
    }
    return hit;
}

// Shares of a triangle's corners at a pixel, from where they are in clip space.
vec3 sharesAt(vec2 pixel, vec3 a, vec3 b, vec3 c) {
    vec4 p = frame.viewProjection * vec4(a, 1.0);
    vec4 q = frame.viewProjection * vec4(b, 1.0);
    vec4 r = frame.viewProjection * vec4(c, 1.0);
    vec3 at = vec3(2.0 * pixel / vec2(frame.size) - 1.0, 1.0);
    vec3 share = vec3(dot(at, cross(q.xyw, r.xyw)), dot(at, cross(r.xyw, p.xyw)),
                      dot(at, cross(p.xyw, q.xyw)));
    if (share.x + share.y + share.z < 0.0) share = -share;
    share = max(share, 0.0);
    float sum = share.x + share.y + share.z;
    return sum > 0.0 ? share / sum : vec3(1.0 / 3.0);
}

struct Face {  // a triangle of the source
    Corner p, q, r;
    uint material;
};

Corner cornerOf(uint number) {
    uvec4 row = texelFetch(cornerRows, int(number));
    return Corner(uintBitsToFloat(row.xy), row.z, row.w);
}

// As shell_over.frag found it.
Face faceOf(usamplerBuffer surface, uvec2 number) {
    int corner = 3 * int(number.x - 1u);
    return Face(cornerOf(texelFetch(surface, corner).r),
                cornerOf(texelFetch(surface, corner + 1).r),
                cornerOf(texelFetch(surface, corner + 2).r), number.y);
}

vec3 bareColor(Face f, vec3 share) {
    vec2 uv = share.x * f.p.uv + share.y * f.q.uv + share.z * f.r.uv;
    return materialColor(f.material, uv) * (share.x * unpackUnorm4x8(f.p.color).rgb +
                                            share.y * unpackUnorm4x8(f.q.color).rgb +
                                            share.z * unpackUnorm4x8(f.r.color).rgb);
}

Ground groundBelow(Face f) {
    ShellVertex a = shellVertex(f.p.skinVertex);
    ShellVertex b = shellVertex(f.q.skinVertex);
    ShellVertex c = shellVertex(f.r.skinVertex);
    vec3 share = sharesAt(gl_FragCoord.xy, outerOf(a), outerOf(b), outerOf(c));
    return groundOf(a, b, c, share, bareColor(f, share));
}

// Hair has the color of its root, which is read where the root is seen in the picture; where it is
// not, that of the skin below the pixel.
void colorAtRoot(inout Ground g, Hit hit) {
    vec3 root = g.position + turnedBack(hit.root - g.place, g.turn);
    vec4 clip = frame.viewProjection * vec4(root, 1.0);
    ivec2 pixel = ivec2((0.5 + 0.5 * clip.xy / clip.w) * vec2(frame.size));
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, frame.size))) return;
    uvec2 number = texelFetch(skinFound, pixel, 0).xy;
    if (number.x == 0u) return;
    Face f = faceOf(skinIndices, number);
    ShellVertex a = shellVertex(f.p.skinVertex);
    ShellVertex b = shellVertex(f.q.skinVertex);
    ShellVertex c = shellVertex(f.r.skinVertex);
    vec3 share = sharesAt(vec2(pixel) + 0.5, a.position, b.position, c.position);
    vec3 away = share.x * a.position + share.y * b.position + share.z * c.position - root;
    if (!(dot(away, away) < 0.25 * g.top * g.top)) return;
    g.tint = share.x * a.tint + share.y * b.tint + share.z * c.tint;
    g.bare = bareColor(f, share);
}

// Where the skin's normal has turned by so much the hair has turned with it.
void lightAtRoot(inout Ground g, vec3 turn) {
    vec3 n = safeUnit(g.normal + turn, g.normal);
    turn = n - g.normal;
    g.overA += dot(g.overA, g.normal) * turn - dot(g.overA, turn) * n;
    g.overB += dot(g.overB, g.normal) * turn - dot(g.overB, turn) * n;
    g.underA += dot(g.underA, g.normal) * turn - dot(g.underA, turn) * n;
    g.underB += dot(g.underB, g.normal) * turn - dot(g.underB, turn) * n;
    g.normal = n;
}
#ifdef MAP
#include "shell_map.glsl"
#include "shell_map_shade.glsl"
#include "shell_map_march.glsl"
#endif

void main() {
    Ground g = groundBelow(faceOf(indices, texelFetch(found, ivec2(gl_FragCoord.xy), 0).xy));
    Ray ray;
    ray.top = g.top;
    ray.cosine = dot(g.normal, g.eye);
    vec3 across = ray.cosine * g.normal - g.eye;
    ray.sine = sqrt(dot(across, across));
    vec3 ahead = safeUnit(across, vec3(0.0));
    vec3 below = g.place;
    float back = 0.0;  // m, from the surface to where the ray begins
#ifdef SKIN
    // From the skin back to where the fur begins or the eye is, over a plane.
    back = g.top / max(ray.cosine, 0.15);
    if (frame.perspective > 0.0) back = min(back, distance(frame.eye, g.outer));
    ray.top = back * ray.cosine;
    ray.bend = ray.bendAcross = 0.0;
    below -= (back * ray.sine) * ahead;
#else
    // Beyond these the skin folds over itself within the length of a hair.
    ray.bend = clamp(g.bend, -0.5 / g.top, 8.0 / g.top);
    ray.bendAcross = clamp(g.bendAcross, -0.5 / g.top, 8.0 / g.top);
#endif
    ray.far = 1.0 + ray.bend * ray.top;

#ifdef MAP
    showMap(ray, below, ahead, back, g);
#else
    float pixelsPerMetre = pixelsPerMetreAt(g.outer);
    Hit hit;
    hit.way = 1e30;
    for (uint c = 0u; c < 2u; ++c) {
        if ((shellCoats >> c & 1u) == 0u) continue;
        Curve mean = Curve(g.underA, g.underB);
        if (c == 0u) mean = Curve(g.overA, g.overB);
        float randomness = c == 0u ? fur.over.endRandomness : fur.under.endRandomness;
        Hair hair = hairOf(mean, spreadOf(mean, g.normal, randomness), g.normal,
                           c == 0u ? g.bendOver : g.bendUnder);
        ShellCoat coat = shellUnder;
        if (c == 0u) coat = shellOver;
        hit = march(ray, below, hair, coat, c, g, ahead, coat.width * pixelsPerMetre, hit);
    }
    bool hits = hit.way < 1e29;
    if (hits) {
        colorAtRoot(g, hit);
        vec3 way = hit.root - below;
        way -= dot(way, g.normal) * g.normal;
        vec3 aside = way - dot(way, ahead) * ahead;
        lightAtRoot(g, ray.bend * (way - aside) + ray.bendAcross * aside);
    }
    color = hits ? vec4(radianceOf(hit, g), 1.0) : vec4(0.5);
    depth = hits ? windowDepth(g.outer + (back - hit.way) * toEye(g.outer)) : 1.0;
#endif
}
