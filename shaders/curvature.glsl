// curvature.glsl -- how the skin bends around its vertices: core/curvature.h.

struct Curvature {
    vec4 first;   // xx, xy, xz, yy of a symmetric map
    vec4 second;  // yz, zz
};
layout(std430, binding = 9) readonly buffer Curvatures { Curvature curvatures[]; };

// 1/m, times the square of the length of t: that of the skin's section along the tangent t.
float curvatureAlong(Curvature c, vec3 t) {
    return c.first.x * t.x * t.x + c.first.w * t.y * t.y + c.second.y * t.z * t.z +
           2.0 * (c.first.y * t.x * t.y + c.first.z * t.x * t.z + c.second.x * t.y * t.z);
}
