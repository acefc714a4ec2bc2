// types.glsl -- the structures the CPU and the GPU agree on.
//
// Compiled twice: as GLSL (std430) and as C++ through core/types.h. Layout rule: a vec3 starts on
// a 16-byte boundary and is followed by a 4-byte value; every struct is a multiple of 16 bytes.
// A test checks each offset against the driver (layout_gltest.cpp).

struct SkinVertex {  // one per welded vertex; world space, rest pose
    vec3 position;   // m
    uint segment;    // index of the body segment the vertex belongs to
    vec3 normal;     // unit, or zero where the faces around it cancel
    uint frame;      // index of the matrix from the file's mesh space to the world
};

struct FurVertex {    // what is painted, one per welded vertex
    vec3 direction;   // where the hair is combed; |direction| in [0,1], 0 = along the normal
    float furLength;  // length of the overcoat hair, [0, 1e6]
    float density;    // share of the hairs that grow, [0,1]
    float pad0;
    float pad1;
    float pad2;
};

struct Root {       // one per hair; nothing else is stored for it
    uint triangle;  // number of the triangle in the source file
    uint bary;      // weights of its first and second corner, unorm16 each, low half first
    uint id;        // random stream of this hair; a hash, because its draws are id, id + 1, ...
    float rank;     // [0,1); the hair is drawn while rank < density * level of detail
};

struct Coat {                // one coat of hair; rows of the coat table (core/coat.h)
    vec3 ambient;            // linear RGB, reflectance for light from all sides
    float stiffness;         // [0,1], 1 - floppiness
    vec3 diffuse;            // linear RGB
    float endRandomness;     // [0,1] share of the length by which the tip is displaced
    vec3 specular;           // linear RGB
    float normalRandomness;  // [0,1] share of half a turn of the shading normal
    vec3 rootColor;          // linear RGB, multiplies ambient and diffuse at the root
    float directionWeight;   // [0,1] weight of the painted direction against the normal
    vec3 tipColor;           // linear RGB, the same at the tip
    float shininess;         // [1,256] exponent of the highlight
    float colorNoise;        // [0,1] +- share of brightness from hair to hair
    float width;             // diameter at the root; 0 = chosen from density and length
    float taper;             // [0,1] share of the width that is lost from root to tip
    float relativeLength;    // [0,1] share of the painted length
#ifdef __cplusplus
    bool operator==(const Coat&) const = default;
#endif
};

struct Fur {                // everything about the fur that is not painted
    Coat over;              // guard hair
    Coat under;             // undercoat
    vec3 gravityDirection;  // unit, world space
    float gravity;          // [0,1], 1 = the rule of the paper
    float share;            // [0,1] share of the hairs that belong to the overcoat
    uint hairs;             // hairs on the entire skin at density 1, [0, 5e6]
    uint seed;              // changes every random choice
    uint pad0;
#ifdef __cplusplus
    bool operator==(const Fur&) const = default;
#endif
};

struct Strand {        // one hair, ready to be evaluated; world space
    vec3 origin;       // m, on the skin
    float spineLength; // m along the hair; 0 = no hair here
    vec3 weightless;   // unit, direction in which the hair leaves the skin
    float width;       // m, diameter at the root
    vec3 end;          // unit, direction of the tip as seen from the root
    float scale;       // m, makes the curve exactly spineLength long
    vec3 binormal;     // unit, across the plane in which the hair bends
    float cosTwist;    // of the angle by which the shading normal is turned about the hair
    vec3 normal;       // unit, of the skin at the root
    float tone;        // brightness of this hair, about 1
    uint coat;         // 0 over, 1 under
    float keep;        // largest rank at which the hair is drawn: the painted density
    float sinTwist;    // of the same angle
    float pad0;
};

struct Light {    // what lights the animal
    vec3 toKey;   // unit, world: towards the key light
    float key;    // its strength
    vec3 sky;     // linear RGB from above
    float pad0;
    vec3 ground;  // linear RGB from below
    float pad1;
};
