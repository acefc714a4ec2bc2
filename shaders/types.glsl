// types.glsl -- the structures the CPU and the GPU agree on.
//
// Compiled twice: as GLSL (std430) and as C++ through core/types.h. Layout rule: a vec3 starts on
// a 16-byte boundary and is followed by a 4-byte value; every struct is a multiple of 16 bytes.
// A test checks each offset against the driver (layout_gltest.cpp).

struct SkinVertex {  // one per welded vertex; world space, rest pose
    vec3 position;   // m
    uint pad0;
    vec3 normal;     // unit, or zero where the faces around it cancel
    uint frame;      // index of the matrix from the file's mesh space to the world
};

struct FurVertex {    // what is painted, one per welded vertex
    vec3 direction;   // where the hair is combed; |direction| in [0,1], 0 = along the normal
    float furLength;  // length of the overcoat hair, [0, 1e6]
    vec3 tint;        // linear RGB in [0,1], multiplies the color of hair; 1 = as the coat has it
    float density;    // share of the hairs that grow, [0,1]
};

struct Root {       // one per hair; nothing else is stored for it
    uint triangle;  // number of the triangle in the source file
    uint bary;      // weights of its first and second corner, unorm16 each, low half first
    uint id;        // random stream of this hair; a hash, because its draws are id, id + 1, ...
    uint guide;     // number of the root whose hair this one gathers to; its own = to none
};

// How hair is drawn: van Gelder and Wilhelms 1997, 3.6 to 3.8, and ribbons.
const uint kStyleLine = 0u;     // straight from root to end, shaded by the skin's normal
const uint kStylePolyline = 1u; // a set number of segments
const uint kStyleRibbon = 2u;   // faces the eye, round in its shading; as many segments as it needs
const uint kStyleCurve = 3u;    // the same curve, one normal and one color for the entire hair
const uint kStyleTube = 4u;     // NURBS surface: a narrow tube with normals of its own
const float kRoundFrom = 1.5f;  // pixels; a narrower ribbon or tube is shaded as a whole

// How hair bends under its weight.
const uint kDroopPaper = 0u;     // by the rule of the paper, 3.5
const uint kDroopElastica = 1u;  // as a heavy elastic rod

// The table of rods (core/elastica.h): nodes of each axis, and texels of each node.
const uint kRodNodes = 64u;
const uint kRodTexels = 4u;       // 3 of the polynomial, then greatest bend and contact
const float kMostLoad = 1000.0f;  // of a rod

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
    uint style;              // kStyle..., how a hair is drawn
    float clump;             // [0,1] how far the tip gathers to the tip of its guide
    float clumpSize;         // [2,1000] hairs that gather to one
    float clumpShape;        // [0.5,4] exponent: how late along the hair it gathers
    float curlRadius;        // [0,0.5] share of the length, at the tip
    float curlTurns;         // [0,20] from root to tip
    float frizz;             // [0,0.5] share of the length, at the tip
    float frizzWaves;        // [1,16] from root to tip
    uint droop;              // kDroop..., how it bends under its weight
    float softness;          // [0,1] of a rod: how much more it sags than stiffness alone lets it
    uint pad0;
    uint pad1;
#ifdef __cplusplus
    bool operator==(const Coat&) const = default;
#endif
};

struct Fur {                // everything about the fur that is not painted
    Coat over;              // guard hair
    Coat under;             // undercoat
    vec3 gravityDirection;  // unit, world space
    float gravity;          // [0,1], 1 = the rule of the paper
    vec3 windDirection;     // unit, world space: where it blows to
    float wind;             // [0,1], 1 pulls as hard as gravity of strength 1
    float share;            // [0,1] share of the hairs that belong to the overcoat
    uint hairs;             // hairs on the entire skin at density 1, [0, 5e6]
    uint seed;              // changes every random choice
    float gusts;            // [0,1] share by which the wind swells and dies
    float gustRate;         // [0,5] Hz
    float gustSize;         // m, from gust to gust
    float skinColor;        // [0,1] how far the color of the skin shows in the hair
    float pad0;
#ifdef __cplusplus
    bool operator==(const Fur&) const = default;
#endif
};

struct Strand {        // one hair, ready to be evaluated; world space
    vec3 origin;       // m, on the skin
    float spineLength; // m along the hair; 0 = no hair here
    vec3 weightless;   // unit, direction in which the hair leaves the skin
    float width;       // m, diameter at the root
    vec3 end;          // unit, direction of the tip as seen from the root; of a rod: across the
                       // weightless direction, to where it bends
    float scale;       // m, makes the curve exactly spineLength long
    vec3 binormal;     // unit, across the plane in which the hair bends
    float cosTwist;    // of the angle by which the shading normal is turned about the hair
    vec3 normal;       // unit, of the skin at the root
    float tone;        // brightness of this hair, about 1
    uint coat;         // 0 over, 1 under
    float keep;        // largest rank at which the hair is drawn: the painted density
    float sinTwist;    // of the same angle
    uint id;           // random stream
    vec3 guideOffset;  // m, from this root to that of the guide
    float clump;       // [0,1] how far the tip gathers to the guide's; 0 = no guide
    vec3 guideWeightless;  // m, weightless and end of the guide times its scale
    float clumpShape;
    vec3 guideEnd;
    float curl;        // m, radius at the tip; 0 = none
    float curlTurns;   // from root to tip
    float frizz;       // m, at the tip; 0 = none
    float frizzWaves;  // from root to tip
    uint style;        // kStyle...
    mat3x4 rod;        // of a rod, polynomial in t (rodWeights in shaders/rod.glsl)
    mat3x4 guideRod;   // that of the guide
    uint droop;        // kDroop...
    float rodBend;     // greatest curvature over t of a rod of scale 1
    uint nearSkin;     // 1 for a rod that may dip below the skin's plane
    uint pad0;
};

struct Light {    // what lights the animal
    vec3 toKey;   // unit, world: towards the key light
    float key;    // its strength
    vec3 sky;     // linear RGB from above
    float pad0;
    vec3 ground;  // linear RGB from below
    float pad1;
};
