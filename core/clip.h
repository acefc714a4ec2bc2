// clip.h -- an animation as values over time: which node it moves, and how it goes between keys.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "types.h"

namespace pelage {

enum class Interpolation { step, linear, cubic };
enum class ClipPath { translation, rotation, scale, weights };

// One property of one node over time.
struct Track {
    std::size_t node = 0;
    ClipPath path = ClipPath::translation;
    Interpolation interpolation = Interpolation::linear;
    std::size_t width = 0;        // numbers of a value: 3, 4, or one per morph target
    std::vector<float> times{};   // s, rising; at least one
    std::vector<float> values{};  // `width` for each time; cubic: in-tangent, value, out-tangent
};

struct Clip {
    std::string name;
    float seconds = 0.0f;  // the last time of any track
    std::vector<Track> tracks{};
};

// The value of a track at a time, before the first key that of the first, after the last that of
// the last (glTF 2.0, appendix C). Rotations (x, y, z, w) go the short way around; they are unit as
// far as the keys are. Exactly the value of a key at its time, and between two equal keys.
std::vector<float> valueAt(const Track& track, float seconds);

}  // namespace pelage
