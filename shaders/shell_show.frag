// shell_show.frag -- what was marched, into the picture; marks the pixels that were.
layout(binding = 2) uniform sampler2D colors;  // of shell.frag
layout(binding = 10) uniform sampler2D depths;
layout(r8ui, binding = 0) uniform writeonly uimage2D seen;  // 1 where fur was looked for
out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    color = texelFetch(colors, pixel, 0);
    gl_FragDepth = texelFetch(depths, pixel, 0).r;
    if (color.a > 0.0) imageStore(seen, pixel, uvec4(1u));
    if (color.a < 1.0) discard;
}
