// regions.h -- regions and a segmented skin for tests.
#pragma once

#include "canvas.h"
#include "core/region.h"
#include "test_skins.h"

namespace pelage::test {

inline Region regionOf(Where where, float falloff = 0.0f) {
    Region region;
    region.where = where;
    region.falloff = falloff;
    return region;
}

inline Region sphere(vec3 center, float radius, float falloff = 0.0f) {
    Region region = regionOf(Where::sphere, falloff);
    region.center = center;
    region.radius = radius;
    return region;
}

inline std::vector<float> weights(const Canvas& canvas, const Region& region) {
    return regionWeights(canvas.query, canvas.groom, region);
}

inline RegionEdit edit(Channel channel, RegionAct act, float value) {
    RegionEdit change;
    change.channel = channel;
    change.act = act;
    change.value = value;
    return change;
}

// The two halves of a ball as segments "head" (x < 0) and "left ear".
inline Source segmentedBall() {
    Source source = ball(4);
    source.segments = {{"head", {}, {}}, {"left ear", {}, {}}};
    for (const vec3 p : source.positions) source.segmentOf.push_back(p.x < 0.0f ? 0u : 1u);
    return source;
}

// What the picture of a camera at (0, 0, 5) that looks at the ball shows. Width 2 x height.
inline mat4 viewFromFront() {
    mat4 m(0.0f);
    m[0][0] = 1.0f;  // x / 2 at tan = 1/2
    m[1][1] = 2.0f;
    m[2][2] = -1.0f;
    m[2][3] = -1.0f;
    m[3][2] = 4.0f;
    m[3][3] = 5.0f;
    return m;
}

}  // namespace pelage::test
