// hair_bench.cpp -- hairs per second on the CPU: where they are rooted, and their curves.
//
// Measured on the animal of 100,000 triangles, on all cores: scatterRoots, and growCurves with 8
// segments, as an export does. Left out: reading the mesh and writing the curves. `s_per_hair` is
// time on the wall; `bytes_per_hair` is what is stored.
#include <benchmark/benchmark.h>

#include "bench_animal.h"
#include "core/coat.h"
#include "core/elastica.h"
#include "core/scatter.h"
#include "core/strand.h"
#include "core/strands_out.h"

namespace pelage::bench {
namespace {

benchmark::Counter perHair(std::size_t hairs) {
    return {static_cast<double>(hairs),
            benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

void BM_Scatter(benchmark::State& state) {
    const Animal& on = animal(100000);
    Roots roots;
    for (auto _ : state)
        roots = scatterRoots(*on.document.skin, static_cast<uint>(state.range(0)), 1);
    state.counters["s_per_hair"] = perHair(roots.roots.size());
    state.counters["bytes_per_hair"] =
        static_cast<double>(roots.roots.size() * sizeof(Root) +
                            roots.clusters.size() * sizeof(Cluster)) /
        static_cast<double>(roots.roots.size());
}
BENCHMARK(BM_Scatter)
    ->Arg(90000)
    ->Arg(500000)
    ->ArgName("hairs")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// One hair on one core: where it hangs, without its points.
void BM_BendStrand(benchmark::State& state) {
    Coat coat = defaultFur().over;
    coat.droop = static_cast<uint>(state.range(0));
    benchmark::DoNotOptimize(rodTable());  // made here, not in the first hair
    std::vector<vec3> directions;
    for (uint i = 0; i < 1024; ++i) directions.push_back(randomInBall(16u * i));
    uint i = 0;
    for (auto _ : state) {
        const vec3 n = safeUnit(directions[i & 1023u], vec3(0, 1, 0));
        Strand s =
            bendStrand(vec3(0), n, directions[(i + 1) & 1023u], 0.04f, coat, i, vec3(0, -1, 0));
        benchmark::DoNotOptimize(s);
        ++i;
    }
}
BENCHMARK(BM_BendStrand)->Arg(kDroopPaper)->Arg(kDroopElastica)->ArgName("rods");

void BM_GrowCurves(benchmark::State& state) {
    Document document = animal(100000).document;
    document.fur.over.droop = document.fur.under.droop = static_cast<uint>(state.range(1));
    const Roots roots = scatterRoots(*document.skin, static_cast<uint>(state.range(0)), 1);
    std::size_t hairs = growCurves(document, roots, 8).rootWidth.size();  // makes the table of rods
    for (auto _ : state) hairs = growCurves(document, roots, 8).rootWidth.size();
    state.counters["hairs"] = static_cast<double>(hairs);
    state.counters["s_per_hair"] = perHair(hairs);
}
BENCHMARK(BM_GrowCurves)
    ->ArgsProduct({{90000, 500000}, {kDroopPaper, kDroopElastica}})
    ->ArgNames({"hairs", "rods"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace pelage::bench
