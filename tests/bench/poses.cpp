// poses.cpp -- what a frame of an animation costs beside one at rest.
//
// pelage_poses FILE [CLIP]: 100 frames of the clip at 900x900, one sample each, all hairs that the
// distance leaves; medians. `rest` is the frame of a skin that does not move while the camera does,
// `posed` a whole frame in another pose, and `core` the part of it in which the skin is posed.
#include <cstdio>
#include <exception>
#include <vector>

#include "app/render/frames.h"
#include "app/render/headless.h"
#include "core/pose.h"
#include "core/rig.h"
#include "milliseconds.h"

namespace pelage {
namespace {

using bench::milliseconds;

constexpr int kFrames = 100;

void run(const char* file, const char* clip) {
    const Document document = openDocument(readSource(file));
    const Skin& skin = *document.skin;
    Pose pose;
    pose.clip = clipNamed(skin, clip);
    const float seconds = skin.source->rig->clips[static_cast<std::size_t>(pose.clip)].seconds;
    const HeadlessContext context;
    Renderer renderer;
    View view;
    view.camera =
        framed(skin.center(), 1.2f * skin.radius, glm::radians(35.0f), glm::radians(12.0f), 1.0f);
    renderer.draw(document, view);
    std::vector<double> rest, posed, core;
    for (int i = 0; i < kFrames; ++i) {
        view.camera.yaw += 1e-5f;  // so that the picture begins anew
        rest.push_back(milliseconds([&] { renderer.draw(document, view); }));
    }
    for (int i = 0; i < kFrames; ++i) {
        pose.seconds = seconds * static_cast<float>(i) / kFrames;
        core.push_back(milliseconds([&] { view.posed = posedSkin(document.skin, pose); }));
        posed.push_back(core.back() + milliseconds([&] { renderer.draw(document, view); }));
    }
    std::printf("%s, clip %s: %zu triangles, %u hairs\n", file, clip, skin.triangles.size(),
                document.fur.hairs);
    std::printf("rest %.1f ms, posed %.1f ms (%.2f times), of which core %.2f ms\n", median(rest),
                median(posed), median(posed) / median(rest), median(core));
}

}  // namespace
}  // namespace pelage

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "pelage_poses FILE [CLIP]\n");
        return 2;
    }
    try {
        pelage::run(argv[1], argc > 2 ? argv[2] : "1");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pelage_poses: %s\n", error.what());
        return 1;
    }
}
