// frames.cpp -- whole pictures from the renderer, and how long a frame takes.
#include "app/render/frames.h"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace pelage {

FrameStats drawFinished(Renderer& renderer, const Document& document, const View& view) {
    FrameStats stats = renderer.draw(document, view);
    while (!stats.finished) stats = renderer.draw(document, view);
    return stats;
}

std::vector<double> timeFrames(Renderer& renderer, const Document& document, View view,
                               int repeat) {
    view.samples = 1;
    const float yaw = view.camera.yaw;
    std::vector<double> times;
    for (int i = 0; i <= repeat; ++i) {
        // A camera that moves by less than a pixel makes the picture begin anew.
        view.camera.yaw = yaw + 1e-5f * static_cast<float>(i + 1);
        const auto start = std::chrono::steady_clock::now();
        renderer.draw(document, view);
        const std::chrono::duration<double, std::milli> time =
            std::chrono::steady_clock::now() - start;
        if (i > 0) times.push_back(time.count());
    }
    return times;
}

double median(std::vector<double> values) {
    assert(!values.empty());
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace pelage
