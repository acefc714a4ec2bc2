// hair_check.h -- what holds for every hair, however hard its case: the one checker of these tests.
#pragma once

#include <cstddef>
#include <string>

#include "core/document.h"
#include "core/scatter.h"
#include "core/strand.h"

namespace pelage::test {

// How far hair may stray, in shares of its own reach.
constexpr double kLengthBound = 1e-5;  // relative error of the length of a spine
constexpr double kDepthBound = 5e-6;   // below the plane of the root
constexpr double kUnitBound = 1e-5;    // |tangent| - 1

// The worst that was seen, and how much was looked at.
struct Worst {
    std::size_t hairs = 0, clumped = 0;
    double length = 0.0, depth = 0.0, unit = 0.0;
};

// One line on standard output: the margins that are left.
void print(const Worst& worst);

// The length of a hair, m, as that of so many chords; places are taken relative to its root, so
// that nothing is rounded away far from the origin.
double chordLength(Strand s, int chords);

// What is wrong with a hair of a coat, "" if nothing: its points are finite, start at its root,
// stay above the root's plane and within reach; tangents and normals are unit; its spine is as long
// as asked (a curled hair has a spine shorter by what a helix is longer than a straight line).
std::string faultOf(const Strand& hair, const Coat& coat, Worst& worst);

// What is wrong with the fur of a document, "" if nothing: its roots are the same from one and two
// threads, as many as the areas ask, of rising ranks, inside their triangles and gathered to hair
// of their own coat; each hair passes the check above, and its curve is finite and starts at its
// root.
std::string faultOf(const Document& document, Worst& worst);

// What is wrong with places, numbers and ranks of the roots of so many hairs, "" if nothing.
std::string faultOf(const Skin& skin, const Roots& roots, uint hairs);

// Roots with their guides, from so many threads.
Roots rootsOf(const Document& document, int threads);

bool sameRoots(const Roots& a, const Roots& b);

}  // namespace pelage::test
