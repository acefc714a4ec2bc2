// gltf_fuzz.cpp -- no bytes, read as a glTF file and played, may crash, hang or take memory without
// bound.
#include <algorithm>
#include <cmath>

#include "core/gltf_in.h"
#include "core/pose.h"
#include "core/rig.h"
#include "fuzz.h"

namespace pelage::fuzz {
namespace {

bool finite(vec3 v) { return glm::dot(v, v) < INFINITY; }

// Every vertex of any pose is somewhere.
void play(Source source) {
    if (!source.rig) return;
    const auto rest = makeSkin(std::move(source));
    const std::vector<Clip>& clips = rest->source->rig->clips;
    for (std::size_t c = 0; c < std::min<std::size_t>(clips.size(), 4); ++c) {
        for (const float share : {0.0f, 0.4f, 1.0f}) {
            const auto skin = posedSkin(rest, {static_cast<int>(c), share * clips[c].seconds, {}});
            for (const SkinVertex& v : skin->vertices)
                check(finite(v.position) && finite(v.normal));
        }
    }
}

}  // namespace
}  // namespace pelage::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pelage::fuzz::readMesh(
        [](auto... arguments) { pelage::fuzz::play(pelage::readGltf(arguments...)); }, data, size);
}
