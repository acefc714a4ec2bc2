// shell_seen.frag -- takes out the skin where its fur was looked for already.
layout(r8ui, binding = 0) uniform readonly uimage2D seen;

void main() {
    if (imageLoad(seen, ivec2(gl_FragCoord.xy)).r == 0u) discard;
    gl_FragDepth = 1.0;
}
