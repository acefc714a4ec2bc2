// accumulate.frag -- adds one sample to the sum (blending does the adding).
layout(binding = 0) uniform sampler2D sampleColor;
layout(location = 0) uniform vec2 pixel;  // 1 / pixels of the picture; a sample may have fewer
out vec4 color;

void main() { color = textureLod(sampleColor, gl_FragCoord.xy * pixel, 0.0); }
