// dab_bench.cpp -- what a dab costs against the size of the mesh.
//
// Measured: one Stroke::dab with a radius of 5 % of the model: radius query, coverage, tool, and
// the copies of chunks. Strokes of 24 dabs along the flank, a radius / 8 apart. Left out:
// making the stroke (reported as `press_ms`), picking (BM_Pick), drawing.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "bench_animal.h"
#include "core/brush.h"
#include "flank.h"

namespace pelage::bench {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values, double share = 0.5) {
    if (values.empty()) return 0.0;
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

void BM_Dab(benchmark::State& state) {
    const Animal& on = animal(static_cast<std::size_t>(state.range(0)));
    Brush brush;
    brush.tool = static_cast<Tool>(state.range(1));
    brush.radius = 0.05f * on.document.skin->size();
    if (brush.tool == Tool::cut) brush.mode = Mode::set;  // to 0: every hair is longer
    brush.color = {0.8f, 0.4f, 0.2f};
    const std::vector<SkinHit> path = flank(on.query, brush.radius / 8.0f);
    if (path.empty()) return state.SkipWithError("no ray met the flank");
    std::vector<uint> found;
    on.query.within(path[path.size() / 2].position, brush.radius, found);

    std::vector<double> dabs, presses;
    std::vector<Stroke> stroke;  // none or one
    Groom groom = on.document.groom;
    std::size_t next = path.size();
    for (auto _ : state) {
        if (next >= path.size()) {
            groom = on.document.groom;
            const auto start = Clock::now();
            stroke.clear();
            stroke.emplace_back(on.query, groom, brush);
            presses.push_back(secondsSince(start));
            next = 0;
        }
        const auto start = Clock::now();
        stroke[0].dab(groom, path[next].position, path[next].normal);
        dabs.push_back(secondsSince(start));
        state.SetIterationTime(dabs.back());
        ++next;
    }
    state.SetLabel(toolInfo(brush.tool).name);
    state.counters["triangles"] = on.triangles();
    state.counters["footprint"] = static_cast<double>(found.size());
    state.counters["median_ms"] = 1e3 * median(dabs);
    state.counters["p95_ms"] = 1e3 * median(dabs, 0.95);
    state.counters["press_ms"] = 1e3 * median(presses);
}
BENCHMARK(BM_Dab)
    ->ArgsProduct({{10000, 100000, 1000000, 2000000},
                   benchmark::CreateDenseRange(0, static_cast<int>(kToolCount) - 1, 1)})
    ->ArgNames({"triangles", "tool"})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

// The footprint grows, the mesh does not.
void BM_DabOfRadius(benchmark::State& state) {
    const Animal& on = animal(1000000);
    Brush brush;
    brush.tool = Tool::length;
    brush.radius = static_cast<float>(state.range(0)) * 0.01f * on.document.skin->size();
    const std::vector<SkinHit> path = flank(on.query, 0.0f);
    if (path.empty()) return state.SkipWithError("no ray met the flank");
    std::vector<uint> found;
    on.query.within(path[0].position, brush.radius, found);
    for (auto _ : state) {
        Groom groom = on.document.groom;
        Stroke stroke(on.query, groom, brush);
        const auto start = Clock::now();
        stroke.dab(groom, path[0].position, path[0].normal);
        state.SetIterationTime(secondsSince(start));
    }
    state.counters["footprint"] = static_cast<double>(found.size());
}
BENCHMARK(BM_DabOfRadius)
    ->Arg(1)
    ->Arg(2)
    ->Arg(5)
    ->Arg(10)
    ->ArgName("percent")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

void BM_Pick(benchmark::State& state) {
    const Animal& on = animal(static_cast<std::size_t>(state.range(0)));
    const vec3 from =
        on.document.skin->center() + vec3(2.0f, 1.0f, 0.5f) * on.document.skin->size();
    float angle = 0.0f;
    for (auto _ : state) {
        angle += 0.1f;
        const vec3 aim =
            on.document.skin->center() + 0.1f * vec3(0.0f, std::cos(angle), std::sin(angle));
        benchmark::DoNotOptimize(on.query.cast(from, aim - from));
    }
}
BENCHMARK(BM_Pick)->Arg(10000)->Arg(100000)->Arg(1000000)->ArgName("triangles");

void BM_BuildQuery(benchmark::State& state) {
    const Animal& on = animal(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(SkinQuery(on.document.skin));
    state.counters["s_per_Mtriangle"] =
        benchmark::Counter(on.triangles() * 1e-6, benchmark::Counter::kIsIterationInvariantRate |
                                                      benchmark::Counter::kInvert);
}
BENCHMARK(BM_BuildQuery)
    ->Arg(100000)
    ->Arg(1000000)
    ->ArgName("triangles")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace pelage::bench
