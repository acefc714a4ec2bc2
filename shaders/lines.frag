// lines.frag -- overlay lines, faint where the skin stands before them.
layout(binding = 1) uniform sampler2D skinDepth;
in vec4 lineColor;
out vec4 color;

void main() {
    float before = texelFetch(skinDepth, ivec2(gl_FragCoord.xy), 0).r;
    color = vec4(lineColor.rgb, lineColor.a * (gl_FragCoord.z <= before + 2e-4 ? 1.0 : 0.15));
}
