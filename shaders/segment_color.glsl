// segment_color.glsl -- the colors that tell body segments apart, in the view and in lists.
//
// Compiled twice: as GLSL and as C++ (app/segment_arrow.cpp).

// Linear RGB. Hues a golden angle apart: those of neighbours in the list are far from each other.
vec3 segmentColor(uint segment) {
    if (segment == 0xffffffffu) return vec3(0.3f);  // none
    float hue = fract(0.618034f * float(segment) + 0.07f);
    vec3 pure = clamp(abs(fract(vec3(hue) + vec3(1.0f, 2.0f / 3.0f, 1.0f / 3.0f)) * 6.0f - 3.0f) -
                          vec3(1.0f), 0.0f, 1.0f);
    // After 8, 13 or 21 the hue is nearly the same again; the brightness is not.
    return mix(vec3(1.0f), pure, 0.8f) * (0.9f - 0.15f * float(segment * 3u % 5u));
}
