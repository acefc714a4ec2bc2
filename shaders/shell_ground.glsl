// shell_ground.glsl -- what a place on the skin knows of its fur.

// Read as textures: software is far slower at storage buffers.
layout(binding = 3) uniform samplerBuffer shellVertices;  // the rows of a ShellVertex

ShellVertex shellVertex(uint number) {
    int i = 11 * int(number);
    vec4 row[11];
    for (int k = 0; k < 11; ++k) row[k] = texelFetch(shellVertices, i + k);
    return ShellVertex(row[0].xyz, row[0].w, row[1].xyz, row[1].w, row[2].xyz, row[2].w, row[3].xyz,
                       row[3].w, row[4].xyz, row[4].w, row[5].xyz, row[5].w, row[6].xyz, row[6].w,
                       row[7].xyz, row[7].w, row[8].xyz, row[8].w, row[9].xyz, row[9].w, row[10]);
}

struct Ground {     // in the space of the skin at rest, unless world is said
    vec3 outer;     // m, world, where the fur begins
    vec3 position;  // m, world, of the skin below
    vec3 place;     // m, the same
    vec4 turn;      // as in ShellVertex
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
    float bendAcross;  // and across it
    float bendOver;    // where the overcoat's hair goes
    float bendUnder;
    float bendToKey;   // and towards the key light
    float skyward;  // how far the skin looks up in the world
    float density;
    float furLength;
    vec3 tint;
    vec3 bare;      // color of the skin
    vec3 combed;    // [0,1] long
};

// Where fur begins over a vertex, world.
vec3 outerOf(ShellVertex v) {
#ifdef SKIN
    return v.position;
#else
    return v.position + v.top * turnedBack(v.normal, v.turn);
#endif
}

// Of the skin in the world along a vector at rest.
float bendAlong(mat3 bends, vec3 v, Ground g) {
    vec3 t = turnedBack(safeUnit(v - dot(v, g.normal) * g.normal, vec3(0.0)), g.turn);
    return dot(t, bends * t);
}

// Between three vertices.
Ground groundOf(ShellVertex a, ShellVertex b, ShellVertex c, vec3 share, vec3 bare) {
#define MIXED(member) (share.x * a.member + share.y * b.member + share.z * c.member)
    Ground g;
    g.outer = share.x * outerOf(a) + share.y * outerOf(b) + share.z * outerOf(c);
    g.position = MIXED(position);
    g.turn = normalize(share.x * a.turn + share.y * b.turn + share.z * c.turn);
    vec3 eye = toEye(g.outer);
    g.place = MIXED(place);
    g.normal = safeUnit(MIXED(normal), vec3(0.0, 1.0, 0.0));
    g.eye = turned(eye, g.turn);
    g.toKey = turned(frame.light.toKey, g.turn);
    g.overA = MIXED(overA);
    g.overB = MIXED(overB);
    g.underA = MIXED(underA);
    g.underB = MIXED(underB);
    g.overAcross = MIXED(overAcross);
    g.underAcross = MIXED(underAcross);
    g.top = MIXED(top);
    vec3 up = turnedBack(g.normal, g.turn);
    g.skyward = up.y;
    vec3 t = safeUnit(eye - dot(eye, up) * up, anyTangent(up));
    vec3 side = cross(up, t);
    vec3 mixedBends = vec3(MIXED(bendXY), MIXED(bendXZ), MIXED(bendYZ));
    mat3 bends = mat3(MIXED(bendXX), mixedBends.xy, mixedBends.x, MIXED(bendYY), mixedBends.z,
                      mixedBends.yz, MIXED(bendZZ));
    g.bend = dot(t, bends * t);
    g.bendAcross = dot(side, bends * side);
    g.bendOver = bendAlong(bends, g.overB, g);
    g.bendUnder = bendAlong(bends, g.underB, g);
    vec3 key = frame.light.toKey;
    vec3 toKey = safeUnit(key - dot(key, up) * up, t);
    g.bendToKey = dot(toKey, bends * toKey);
    g.density = MIXED(density);
    g.furLength = MIXED(furLength);
    g.tint = MIXED(tint);
    g.bare = bare;
    g.combed = share.x * unpackedDirection(a.combed) + share.y * unpackedDirection(b.combed) +
               share.z * unpackedDirection(c.combed);
    return g;
#undef MIXED
}
