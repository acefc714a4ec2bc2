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

double timeFrame(Renderer& renderer, const Document& document, View view, int turn) {
    view.samples = 1;
    // A camera that moves by less than a pixel makes the picture begin anew.
    view.camera.yaw += 1e-5f * static_cast<float>(turn + 1);
    const auto start = std::chrono::steady_clock::now();
    renderer.draw(document, view);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    return time.count();
}

std::vector<double> timeFrames(Renderer& renderer, const Document& document, const View& view,
                               int repeat) {
    std::vector<double> times;
    for (int i = 0; i <= repeat; ++i) {
        const double ms = timeFrame(renderer, document, view, i);
        if (i > 0) times.push_back(ms);
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
