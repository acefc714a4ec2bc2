// elastica.h -- the heavy elastic rod: how a long soft hair hangs, solved exactly, and as a table.
//
// An inextensible rod of length 1 is clamped at s = 0 and bends under its own weight. Its angle
// from "up" is theta(s), with theta'' = -load (1 - s) sin theta, theta(0) = that of the root,
// theta'(1) = 0. load = density * gravity * section * length^3 / (Young's modulus * second moment
// of area). Of its equilibria the one is meant into which the rod hangs down: theta rises from the
// root to at most pi.
#pragma once

#include <vector>

#include "types.h"

namespace pelage {

// Sine and cosine of an angle up to some thousand, the same bits on every machine.
struct Turn {
    double sine, cosine;
};
Turn turnOf(double angle);

// The rod at s = i / steps.
struct Rod {
    std::vector<double> angle;      // from up, rad
    std::vector<double> curvature;  // d angle / ds
    std::vector<glm::dvec2> place;  // of a rod of length 1: level, and up
    std::vector<glm::dvec2> tangent;
};

// root in (0, pi], load in [0, 1e4], steps >= 8. Numerov's method, solved by Newton's from hanging
// straight down. The same bits on every machine.
Rod hangingRod(double root, double load, int steps);

// The rod's place at s, [0,1], between its nodes by cubic polynomials.
glm::dvec2 placeOn(const Rod& rod, double s);

// The table that shaders/rod.glsl reads: kRodTexels of each of kRodNodes * kRodNodes nodes.
// Made when first asked for (a tenth of a second), so that fur without rods pays nothing. Always
// the same: the compiler may ask once for many hairs.
[[gnu::const]] const vec4* rodTable();

}  // namespace pelage
