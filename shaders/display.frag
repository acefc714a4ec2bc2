// display.frag -- the mean of the samples, from linear light to sRGB, alpha straight.
layout(binding = 0) uniform sampler2D sum;
layout(location = 0) uniform float weight;  // 1 / number of samples
layout(location = 1) uniform vec2 pixel;  // 1 / pixels of the picture; a sample may have fewer
out vec4 color;

// IEC 61966-2-1.
vec3 encodeSrgb(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c,
               lessThanEqual(c, vec3(0.0031308)));
}

void main() {
    vec4 mean = weight * textureLod(sum, gl_FragCoord.xy * pixel, 0.0);
    color = vec4(encodeSrgb(mean.rgb / max(mean.a, 1e-6)), mean.a);
}
