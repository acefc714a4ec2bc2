// costs.cpp -- how what the artist waits for grows with its size, and the line through it.
//
//     pelage_costs [FOLDER]    prints a table; writes costs.csv and costs.svg to the folder
//
// Frames of the built-in animal (128,000 triangles, every hair, one sample) against hairs and
// against pixels; dabs of a brush against the vertices under it, on a million triangles; opening a
// groomed .glb against triangles. Each is fitted by a fixed time and a slope, so that the relative
// misses are least; a miss is what the line is off by where it fits worst.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include "app/render/frames.h"
#include "app/render/headless.h"
#include "bench_animal.h"
#include "core/brush.h"
#include "core/document.h"
#include "core/files.h"
#include "core/gltf_out.h"
#include "core/plot.h"
#include "core/text.h"
#include "flank.h"
#include "milliseconds.h"

namespace pelage::bench {
namespace {

struct Point {
    double size, ms;
};

struct Growth {
    std::string what, unit;
    std::vector<Point> points;
};

struct Line {
    double fixed = 0.0, slope = 0.0;  // ms, ms a unit
    double at(double size) const { return fixed + slope * size; }
};

// By least squares of the relative misses; through the origin where the fixed time would be
// negative.
Line fitted(const std::vector<Point>& points) {
    double one = 0.0, x = 0.0, xx = 0.0, y = 0.0, xy = 0.0;
    for (const Point& p : points) {
        const double weight = 1.0 / (p.ms * p.ms);
        one += weight;
        x += weight * p.size;
        xx += weight * p.size * p.size;
        y += weight * p.ms;
        xy += weight * p.size * p.ms;
    }
    const double slope = (one * xy - x * y) / (one * xx - x * x), fixed = (y - slope * x) / one;
    return fixed > 0.0 ? Line{fixed, slope} : Line{0.0, xy / xx};
}

double worstMiss(const std::vector<Point>& points, const Line& line) {
    double worst = 0.0;
    for (const Point& p : points) worst = std::max(worst, std::abs(line.at(p.size) / p.ms - 1.0));
    return worst;
}

View wholeView(const Document& document, int side) {
    View view;
    view.size = ivec2(side);
    view.camera = framed(document.skin->center(), 1.2f * document.skin->radius, glm::radians(35.0f),
                         glm::radians(12.0f), 1.0f);
    view.detail.rule = Detail::Rule::all;
    return view;
}

Growth framesByHairs(Renderer& renderer) {
    Growth growth{"frame of 900x900", "hairs", {}};
    Document document = animal(126000).document;
    for (const uint hairs : {31'250u, 62'500u, 125'000u, 250'000u, 500'000u, 1'000'000u}) {
        document.fur.hairs = hairs;
        growth.points.push_back(
            {static_cast<double>(hairs),
             median(timeFrames(renderer, document, wholeView(document, 900), 7))});
    }
    return growth;
}

Growth framesByPixels(Renderer& renderer) {
    Growth growth{"frame of 100,000 hairs", "pixels", {}};
    Document document = animal(126000).document;
    document.fur.hairs = 100'000;
    for (const int side : {225, 450, 900, 1350, 1800, 2400})
        growth.points.push_back(
            {static_cast<double>(side) * side,
             median(timeFrames(renderer, document, wholeView(document, side), 7))});
    return growth;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// The mean, since a dab in some measures distances along the skin anew.
Growth dabsByFootprint() {
    Growth growth{"dab on 1,000,000 triangles", "vertices under the brush", {}};
    const Animal& on = animal(1'000'000);
    for (const float percent : {0.5f, 1.0f, 2.0f, 4.0f, 6.0f, 8.0f}) {
        Brush brush;
        brush.tool = Tool::length;
        brush.radius = 0.01f * percent * on.document.skin->size();
        const std::vector<SkinHit> path = flank(on.query, brush.radius / 8.0f);
        Groom groom = on.document.groom;
        Stroke stroke(on.query, groom, brush);
        std::vector<double> times, found;
        std::vector<uint> under;
        for (const SkinHit& hit : path) {
            on.query.within(hit.position, brush.radius, under);
            found.push_back(static_cast<double>(under.size()));
            times.push_back(milliseconds([&] { stroke.dab(groom, hit.position, hit.normal); }));
        }
        growth.points.push_back({mean(found), mean(times)});
    }
    return growth;
}

Growth loadsByTriangles() {
    Growth growth{"opening a groomed .glb", "triangles", {}};
    const std::string path = "/tmp/pelage-costs-" + std::to_string(getpid()) + ".glb";
    for (const std::size_t triangles : {16'000u, 64'000u, 256'000u, 1'000'000u}) {
        const Animal& on = animal(triangles);
        writeGroomedGlb(on.document, path);
        std::vector<double> times;
        for (int i = 0; i < 3; ++i)
            times.push_back(milliseconds([&] { openDocument(readSource(path)); }));
        growth.points.push_back({on.triangles(), median(times)});
        std::remove(path.c_str());
    }
    return growth;
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

Plot plotOf(const Growth& growth) {
    const Line line = fitted(growth.points);
    Plot plot{
        growth.what + ": " + number(line.fixed) + " ms + " + number(1e6 * line.slope) + " ns each",
        growth.unit, "ms"};
    plot.series = {{"measured", {}}, {"fixed time and slope", {}}};
    for (const Point& p : growth.points) {
        plot.series[0].points.push_back({p.size, p.ms, "", false});
        plot.series[1].points.push_back({p.size, line.at(p.size), "", false});
    }
    return plot;
}

void run(const char* folder) {
    const HeadlessContext context;
    Renderer renderer;
    std::vector<Growth> all = {framesByHairs(renderer), framesByPixels(renderer),
                               loadsByTriangles(), dabsByFootprint()};
    std::string csv = "what,unit,size,ms,fixed ms,ns each,worst miss\n";
    std::vector<Plot> plots;
    for (const Growth& growth : all) {
        const Line line = fitted(growth.points);
        const double miss = worstMiss(growth.points, line);
        std::printf(
            "%-27s %8.2f ms + %8.1f ns for each of %-25s within %.0f %%:", growth.what.c_str(),
            line.fixed, 1e6 * line.slope, growth.unit.c_str(), 100.0 * miss);
        for (const Point& p : growth.points) {
            std::printf(" %.0f %.2f", p.size, p.ms);
            csv += csvField(growth.what) + "," + csvField(growth.unit) + "," + number(p.size) +
                   "," + number(p.ms) + "," + number(line.fixed) + "," + number(1e6 * line.slope) +
                   "," + number(miss) + "\n";
        }
        std::printf("\n");
        plots.push_back(plotOf(growth));
    }
    if (!folder) return;
    const auto write = [&](const std::string& name, const std::string& text) {
        writeFileAtomically(folder + ("/" + name), std::as_bytes(std::span(text)));
    };
    write("costs.csv", csv);
    write("costs.svg", svgOf(plots, renderer.device()));
}

}  // namespace
}  // namespace pelage::bench

int main(int argc, char** argv) {
    try {
        pelage::bench::run(argc > 1 ? argv[1] : nullptr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pelage_costs: %s\n", error.what());
        return 1;
    }
    return 0;
}
