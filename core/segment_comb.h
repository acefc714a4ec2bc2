// segment_comb.h -- combing along the body: a segment's axis laid onto its skin, and one smooth
// field from head to tail.
//
// The hair of an animal lies along the segments of its body (van Gelder and Wilhelms, "An
// Interactive Fur Modeling Technique", 1997, section 3.4), whose axes run from the head to the
// tail; a weight mixes that direction with the one there was.
//
// The field over the whole body is the vector field x that is least in
//     sum over vertices of A |x - t|^2  +  L^2 integral of |grad x|^2,
// where t is the axis of the vertex's segment laid onto its tangent plane, A the area around the
// vertex and L a length on the surface, 3 % of the size of the skin: over about L on both sides of
// a border one axis passes into the next, and beyond it each segment keeps its own. A potential
// whose gradient is the comb direction was the other choice; it cannot follow axes that do not
// add up to a gradient (a foot that turns forward below a leg), and has no scale of its own. In
// two dimensions the second term does not change with the scale of the mesh, so each edge weighs
// the same, tan(30 degrees) as in equilateral triangles: coarse or graded meshes need no other
// weights, and needle triangles have none that are negative or infinite. One-rings carry it, so
// that a tail that hangs beside a leg does not feel it. The minimum is found from coarse to fine:
// whole one-rings are gathered until L is as short as an edge, and each finer level starts at what
// the coarser found (Bornemann and Deuflhard, "The cascadic multigrid method for elliptic
// problems", 1996) and takes a fixed number of Jacobi sweeps. Time and memory grow with the mesh
// alone, and the result is the same bit for bit with any number of threads.
#pragma once

#include <vector>

#include "groom.h"

namespace pelage {

// The part of a vector along the tangent plane, made as long as 1; where less than 0.4 of a unit
// vector lies along it (it points away from the skin or into it, and no direction is right) it
// fades to zero. `comb` at most as long as 1, of a finite length; without a normal all of it counts
// as tangential.
vec3 laidOnSkin(vec3 comb, vec3 normal);

// From the end nearer the head to the other, unit, world; zero for a segment without length.
vec3 axisOf(const Segment& segment);

// Mixes the axis, laid onto the tangent plane of each vertex of the segment, into the direction by
// `weight`, [0,1]: 0 leaves it, 1 replaces it. The mask holds it back; length, density and tint
// stay. `axis` in the world, of any length but zero.
void combSegment(const Skin& skin, Groom& groom, uint segment, vec3 axis, float weight);

// The smooth field at each vertex: world, on the tangent plane, at most as long as 1, and shorter
// where hair parts (at the nose) or meets. Zero on pieces of the mesh that no axis reaches. Throws
// std::runtime_error where the groom has no segment with an axis.
std::vector<vec3> headToTail(const Skin& skin, const Groom& groom);

// Mixes that field into the direction of every vertex, as combSegment does. Vertices that no axis
// reaches keep theirs.
void combHeadToTail(const Skin& skin, Groom& groom, float weight);

}  // namespace pelage
