// file_bench.cpp -- load and export, per million triangles.
//
// Measured: reading a groomed .glb from the page cache, building the skin, writing it again into
// memory. `s_per_Mtriangle` is comparable over sizes. Left out: the disk.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include <unistd.h>

#include "bench_animal.h"
#include "core/gltf_out.h"

namespace pelage::bench {
namespace {

benchmark::Counter perMillion(double triangles) {
    return {triangles * 1e-6,
            benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

// A .glb of the animal that is gone after the benchmark.
class AnimalFile {
public:
    explicit AnimalFile(std::size_t triangles)
        : path_((std::filesystem::temp_directory_path() /
                 ("pelage-bench-" + std::to_string(getpid()) + ".glb"))
                    .string()) {
        writeGroomedGlb(animal(triangles).document, path_);
    }
    ~AnimalFile() { std::remove(path_.c_str()); }
    AnimalFile(const AnimalFile&) = delete;
    AnimalFile& operator=(const AnimalFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

void BM_MakeAnimal(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(makeAnimal(static_cast<std::size_t>(state.range(0))));
    state.counters["s_per_Mtriangle"] = perMillion(static_cast<double>(state.range(0)));
}
BENCHMARK(BM_MakeAnimal)
    ->Arg(100000)
    ->Arg(1000000)
    ->ArgName("triangles")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_Read(benchmark::State& state) {
    const AnimalFile file(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(readSource(file.path()));
    state.counters["s_per_Mtriangle"] =
        perMillion(animal(static_cast<std::size_t>(state.range(0))).triangles());
}
BENCHMARK(BM_Read)
    ->Arg(100000)
    ->Arg(1000000)
    ->ArgName("triangles")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_Open(benchmark::State& state) {
    const AnimalFile file(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(openDocument(readSource(file.path())));
    state.counters["s_per_Mtriangle"] =
        perMillion(animal(static_cast<std::size_t>(state.range(0))).triangles());
}
BENCHMARK(BM_Open)
    ->Arg(100000)
    ->Arg(1000000)
    ->ArgName("triangles")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_Export(benchmark::State& state) {
    const Animal& on = animal(static_cast<std::size_t>(state.range(0)));
    std::size_t bytes = 0;
    for (auto _ : state) bytes = groomedGlb(on.document).size();
    state.counters["s_per_Mtriangle"] = perMillion(on.triangles());
    state.counters["MB"] = 1e-6 * static_cast<double>(bytes);
}
BENCHMARK(BM_Export)
    ->Arg(100000)
    ->Arg(1000000)
    ->ArgName("triangles")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace pelage::bench
