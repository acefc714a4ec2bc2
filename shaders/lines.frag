// lines.frag -- overlay lines, faint where the skin stands before them.
layout(binding = 1) uniform sampler2D skinDepth;
in vec4 lineColor;
layout(location = 1) uniform vec2 pixel;  // 1 / pixels of the picture
out vec4 color;

void main() {
    float before = textureLod(skinDepth, gl_FragCoord.xy * pixel, 0.0).r;
    color = vec4(lineColor.rgb, lineColor.a * (gl_FragCoord.z <= before + 2e-4 ? 1.0 : 0.15));
}
