// dolly.cpp -- whether a camera that moves away sees the coats change from strands to shells.
//
// pelage_dolly TRIANGLES HAIRS SIZE SAMPLES NEAR FAR DETAIL: 120 frames of the animal of so many
// triangles and hairs, in square pictures of so many pixels, from NEAR to FAR times the distance
// that frames it, in a detail as of pelage render. For each frame how much of the coats is in
// shells, its time, and how much the picture changed since the frame before: the sum of the
// differences in linear light, in sizes of the animal.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "app/render/frames.h"
#include "app/render/framing.h"
#include "app/render/headless.h"
#include "core/animal.h"
#include "core/pixels.h"

namespace pelage {
namespace {

constexpr int kFrames = 120;

double differenceOf(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            sum += static_cast<double>(std::abs(a.pixels[i][c] - b.pixels[i][c])) / 3.0;
    return sum;
}

void travel(char** argv) {
    Document document = groomedAnimal(static_cast<std::size_t>(std::atol(argv[1])));
    document.fur.hairs = static_cast<uint>(std::atol(argv[2]));
    View view;
    view.size = ivec2(std::atoi(argv[3]));
    view.samples = std::atoi(argv[4]);
    view.shells = Shells::swept;
    view.over = view.under = DrawnAs::automatic;
    view.transparent = true;
    view.detail = detailFromText(argv[7]);
    view.camera = framedCamera(document, 0.61f, 0.21f, view.size);
    const double near = std::atof(argv[5]), far = std::atof(argv[6]);
    const auto framed = static_cast<double>(view.camera.distance);
    const HeadlessContext context;
    Renderer renderer;
    Image before;
    std::vector<double> changes, switching;
    vec2 sharesBefore(0.0f);
    for (int i = 0; i < kFrames; ++i) {
        const double away = near * std::pow(far / near, i / (kFrames - 1.0));
        view.camera.distance = static_cast<float>(framed * away);
        const FrameStats stats = drawFinished(renderer, document, view);
        const Image image = linearImage({view.size, renderer.pixels()});
        // Of the animal, whose size on screen falls.
        double change = 0.0;
        if (i > 0) {
            change = differenceOf(image, before) * away * away /
                     static_cast<double>(view.size.x * view.size.y);
            changes.push_back(change);
            if (stats.inShells != sharesBefore) switching.push_back(change);
        }
        std::printf("%3d %6.2f  over %.3f under %.3f  %7.1f ms  change %.5f\n", i, away,
                    static_cast<double>(stats.inShells.x), static_cast<double>(stats.inShells.y),
                    1e3 * stats.seconds, change);
        before = image;
        sharesBefore = stats.inShells;
    }
    std::ranges::nth_element(changes, changes.begin() + kFrames / 2);
    const double median = changes[kFrames / 2];
    const double most = switching.empty() ? 0.0 : *std::ranges::max_element(switching);
    std::printf("median change %.5f, greatest at the switch %.5f: %.2f times\n", median, most,
                most / median);
}

}  // namespace
}  // namespace pelage

int main(int argc, char** argv) {
    if (argc != 8) {
        std::fprintf(stderr, "pelage_dolly TRIANGLES HAIRS SIZE SAMPLES NEAR FAR DETAIL\n");
        return 2;
    }
    try {
        pelage::travel(argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pelage_dolly: %s\n", error.what());
        return 1;
    }
}
