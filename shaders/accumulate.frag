// accumulate.frag -- adds one sample to the sum (blending does the adding).
layout(binding = 0) uniform sampler2D sampleColor;
out vec4 color;

void main() { color = vec4(texelFetch(sampleColor, ivec2(gl_FragCoord.xy), 0).rgb, 1.0); }
