// stratified.cpp -- Sobol's sequence in two dimensions, scrambled.
#include "stratified.h"

#include "strand.h"

namespace pelage {
namespace {

uint reversed(uint v) {
    v = (v & 0x55555555u) << 1u | (v >> 1u & 0x55555555u);
    v = (v & 0x33333333u) << 2u | (v >> 2u & 0x33333333u);
    v = (v & 0x0f0f0f0fu) << 4u | (v >> 4u & 0x0f0f0f0fu);
    v = (v & 0x00ff00ffu) << 8u | (v >> 8u & 0x00ff00ffu);
    return v << 16u | v >> 16u;
}

// Owen's scrambling of the bits of v, given in reverse: each bit is turned by a hash of those below
// it. Laine and Karras, "Stratified Sampling for Stochastic Transparency", 2011.
uint scrambled(uint v, uint seed) {
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16u) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return reversed(v);
}

// The second dimension of Sobol's sequence, its bits in reverse.
uint secondReversed(uint index) {
    uint value = 0;
    for (uint column = 1u; index; index >>= 1u, column ^= column << 1u)
        if (index & 1u) value ^= column;
    return value;
}

float unit(uint bits) { return static_cast<float>(bits >> 8u) * (1.0f / 16777216.0f); }

}  // namespace

vec2 stratified(uint index, uint seed) {
    const uint place = scrambled(reversed(index), pcg(seed)) & 0xffffu;
    return {unit(scrambled(place, pcg(seed + 1))),
            unit(scrambled(secondReversed(place), pcg(seed + 2)))};
}

}  // namespace pelage
