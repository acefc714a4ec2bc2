// shell_ground.glsl -- what a place on the skin knows of its fur.

layout(std430, binding = 8) readonly buffer ShellVertices { ShellVertex shellVertices[]; };

struct Ground {     // in the space of the skin at rest, unless world is said
    vec3 outer;     // m, world, where the fur begins
    vec3 place;     // m, of the skin below
    vec3 normal;    // unit
    vec3 eye;       // unit, towards it
    vec3 toKey;
    vec3 overA;     // as in ShellVertex
    vec3 overB;
    vec3 underA;
    vec3 underB;
    vec3 overAcross;
    vec3 underAcross;
    float top;
    float bend;     // 1/m, curvature of the skin in the direction of the view
    float skyward;  // how far the skin looks up in the world
    float density;
    float furLength;
    vec3 tint;
    vec3 bare;      // color of the skin
};

// Where fur begins over a vertex, world.
vec3 outerOf(ShellVertex v) {
#ifdef SKIN
    return v.position;
#else
    return v.position + v.top * turnedBack(v.normal, v.turn);
#endif
}

// Between three vertices. Curvature goes with the square of the length of the tangent.
Ground groundOf(ShellVertex a, ShellVertex b, ShellVertex c, vec3 share, vec3 bare) {
#define MIXED(member) (share.x * a.member + share.y * b.member + share.z * c.member)
    Ground g;
    g.outer = share.x * outerOf(a) + share.y * outerOf(b) + share.z * outerOf(c);
    vec4 turn = normalize(share.x * a.turn + share.y * b.turn + share.z * c.turn);
    vec3 eye = toEye(g.outer);
    g.place = MIXED(place);
    g.normal = safeUnit(MIXED(normal), vec3(0.0, 1.0, 0.0));
    g.eye = turned(eye, turn);
    g.toKey = turned(frame.light.toKey, turn);
    g.overA = MIXED(overA);
    g.overB = MIXED(overB);
    g.underA = MIXED(underA);
    g.underB = MIXED(underB);
    g.overAcross = MIXED(overAcross);
    g.underAcross = MIXED(underAcross);
    g.top = MIXED(top);
    vec3 up = turnedBack(g.normal, turn);
    g.skyward = up.y;
    vec3 t = eye - dot(eye, up) * up;
    g.bend = (MIXED(bendXX) * t.x * t.x + MIXED(bendYY) * t.y * t.y + MIXED(bendZZ) * t.z * t.z +
              2.0 * (MIXED(bendXY) * t.x * t.y + MIXED(bendXZ) * t.x * t.z +
                     MIXED(bendYZ) * t.y * t.z)) /
             max(dot(t, t), 1e-12);
    g.density = MIXED(density);
    g.furLength = MIXED(furLength);
    g.tint = MIXED(tint);
    g.bare = bare;
    return g;
#undef MIXED
}
