// shell_map_march.glsl -- the ray behind a pixel goes down through the layers of a picture until it
// meets hair, and up again where it misses the skin. Included by shell.frag.

layout(binding = 9) uniform sampler2D skinDepth;  // from before fur was drawn

Hit mapMarch(Ray ray, vec3 place, Hair hair, bool over, Ground g, vec3 ahead, out MapCut cut) {
    float level = mapLevel(pixelsPerMetreAt(g.outer));
    float peak = peakOf(hair);
    Hit hit;
    hit.way = 1e30;
    hit.over = over;
    uint last = wayTo(ray, 0.0, false).there ? mapLayers : 2u * mapLayers - 1u;
    for (uint i = 1u; i <= last; ++i) {
        uint k = i <= mapLayers ? i : 2u * mapLayers - i;
        float t = mapGap * (1.0 - float(k) / float(mapLayers));
        Way at = wayTo(ray, min(heightAt(hair, t), ray.top), i > mapLayers);
        if (hit.way <= at.way && t <= peak) break;
        vec3 root = rootAt(ray, place, hair, Stray(0.0, 0.0), g.normal, ahead, at.way, t);
        vec3 n = normalize(g.normal + ray.bend * (root - place));
        MapCut one = mapCut(mapPlace(root, n, g.combed), level, k, g.density);
        if (!one.there || !at.there || at.way >= hit.way) continue;
        cut = one;
        hit.way = at.way;
        hit.t = t;
        hit.id = one.id;
        hit.root = root;
    }
    return hit;
}

// Depth in the window of what is so far along the view from where the fur begins.
float depthAt(Ground g, float way) {
    return windowDepth(g.outer - way * toEye(g.outer));
}

// What ends on the skin, and what the ball hides a little behind it, is seen in front of it.
float depthBefore(float skin, Ground g, Ray ray, float way) {
    float slack = 0.25 * g.top / max(ray.cosine, 0.25);
    float depth = depthAt(g, way);
    return depth >= skin && depthAt(g, way - slack) < skin ? skin - 1e-6 : depth;
}

// `back` is how far behind the beginning of the ray the surface lies that was found.
void showMap(Ray ray, vec3 place, vec3 ahead, float back, Ground g) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool over = (shellCoats & 1u) != 0u;
    Curve mean = Curve(over ? g.overA : g.underA, over ? g.overB : g.underB);
    Hair hair = hairOf(mean, 0.0, g.normal, over ? g.bendOver : g.bendUnder);
    MapCut cut;
    Hit hit = mapMarch(ray, place, hair, over, g, ahead, cut);
    float skin = texelFetch(skinDepth, pixel, 0).r;
    depth = hit.way < 1e29 ? depthBefore(skin, g, ray, hit.way - back) : 1.0;
    if (depth < skin) {
        colorAtRoot(g, hit);
        color = vec4(mapRadiance(cut, hit, g), 1.0);
    } else {  // skin that is seen all the same is asked for what lies on it
        color = vec4(texelFetch(skinFound, pixel, 0).x != 0u ? 0.0 : 0.5);
    }
}
