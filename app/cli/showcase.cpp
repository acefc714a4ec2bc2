// showcase.cpp -- what `pelage` does where there is no display: pictures and a groomed .glb.
#include <cstdio>
#include <filesystem>

#include "app/cli/cli.h"
#include "app/cli/input.h"
#include "app/cli/picture.h"
#include "app/cli/print.h"
#include "app/render/framing.h"
#include "core/animal.h"
#include "core/gltf_out.h"

namespace pelage {
namespace {

constexpr const char* kFolder = "pelage-out";
constexpr ivec2 kSize{1200, 900};

struct Angle {
    const char* name;
    float yaw, pitch;  // degrees
    float zoom;        // share of the framed distance
};

constexpr Angle kAngles[] = {
    {"front", 0, 8, 1},
    {"side", 90, 8, 1},
    {"three-quarter", 35, 15, 1},
    {"close-up", 60, 25, 0.25f},
};

Camera cameraFor(const Document& document, const Angle& angle) {
    const Camera camera =
        framedCamera(document, glm::radians(angle.yaw), glm::radians(angle.pitch), kSize);
    return zoomed(document, camera, angle.zoom);
}

}  // namespace

void runShowcase(const std::string& file, bool json) {
    const Document document =
        file.empty() ? groomedAnimal(kAnimalTriangles) : openDocument(readSource(file));
    const HeadlessContext context;
    Renderer renderer;
    std::filesystem::create_directories(kFolder);
    OrderedJson written = OrderedJson::array();
    for (const Angle& angle : kAngles) {
        View view;
        view.size = kSize;
        view.samples = 16;
        view.camera = cameraFor(document, angle);
        drawFinished(renderer, document, view);
        const std::string path = std::string(kFolder) + "/" + angle.name + ".png";
        writePicture(path, renderer, kSize);
        written.push_back(path);
    }
    const std::string glb = std::string(kFolder) + "/" + stemOf(file) + "-groomed.glb";
    writeGroomedGlb(document, glb);
    written.push_back(glb);
    if (json) {
        printJson({{"display", false}, {"written", written}, {"device", renderer.device()}});
        return;
    }
    std::string text = "There is no display, so the editor cannot open. Written instead:\n";
    for (const auto& path : written) text += "  " + path.get<std::string>() + "\n";
    print(text);
}

}  // namespace pelage
