// tuft.h -- the hair of a cluster as a whole: how long it is, which way it leans, how far it
// reaches.
#pragma once

#include "chunked.h"
#include "scatter.h"
#include "types.h"

namespace pelage {

// Directions around an axis.
struct Cone {
    vec3 axis{0.0f, 1.0f, 0.0f};        // unit
    float cosine = -1.0f, sine = 0.0f;  // of half its angle; this one holds all directions

    static Cone of(vec3 axis, float halfAngle);
    // The greatest dot product of its directions with a unit vector.
    float along(vec3 direction) const;
};

// The hair of a cluster as it is painted and combed.
struct Tuft {
    Cone normals{};         // of the skin at its roots
    Cone leaving{};         // directions in which its hairs leave the skin
    Cone tips{};            // directions in which their tips may lie from their roots
    float shortest = 0.0f;  // length that a unit leaving direction keeps at least under the pull
    float longest = 0.0f;   // m, world, as painted; 0 = bald
    float densest = 0.0f;   // [0,1], of the painted density; 0 = bald
};
Tuft tuftOf(const Cluster& cluster, const Skin& skin, const Chunked<FurVertex>& painted,
            const Fur& fur);

// True if the tufts of both furs are the same.
bool combsAlike(const Fur& a, const Fur& b);

// What the chooser knows of both coats, as far as they are drawn.
struct Pelt {
    uint coats = 0;                         // bit 0: there is an overcoat, bit 1: an undercoat
    float meanWidth = 0.0f, widest = 0.0f;  // m, at the root
    float length = 0.0f;                    // greatest, in painted lengths
    float aside = 0.0f;       // how far curls and frizz take hair from its spine, in the same
    float clumpReach = 0.0f;  // m, how far it gets at least where it gathers to other clusters'
    float load = 0.0f;        // of the softer coat: pull on hair that leaves along the normal
    float bend = 0.0f;        // |end - weightless| of the softer coat at most
    vec3 pull{0.0f};          // unit, where it pulls; zero where wind may turn it

    float reach() const { return length + aside; }  // from the root, in painted lengths
};
// `coats` are asked for; widths as in a frame; `longest` (m) of all painted lengths.
Pelt peltOf(const Fur& fur, uint coats, float overWidth, float underWidth, double area,
            float longest);

// How far hairs of a tuft may get from their roots along a unit vector, m.
float reachAlong(const Tuft& tuft, const Pelt& pelt, vec3 direction);

}  // namespace pelage
