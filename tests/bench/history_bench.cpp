// history_bench.cpp -- what a step of history costs: the snapshot, its memory, undo and redo.
//
// Measured on the animal after strokes of a radius of 5 % of the model. Left out: the stroke itself
// (dab_bench.cpp) and what the renderer uploads.
#include <benchmark/benchmark.h>

#include "bench_animal.h"
#include "core/brush.h"
#include "core/editor.h"

namespace pelage::bench {
namespace {

// Changes `count` vertices that are neighbours in memory, as a dab does.
void touch(Editor& editor, std::size_t first, std::size_t count, float length) {
    editor.edit([&](Document& document) {
        const std::size_t size = document.groom.fur.size();
        for (std::size_t i = 0; i < count; ++i)
            document.groom.fur.edit((first + i) % size).furLength = length;
    });
}

void BM_Snapshot(benchmark::State& state) {
    const Document& document = animal(static_cast<std::size_t>(state.range(0))).document;
    for (auto _ : state) {
        Document copy = document;
        benchmark::DoNotOptimize(copy);
    }
    state.counters["vertices"] = static_cast<double>(document.groom.fur.size());
}
BENCHMARK(BM_Snapshot)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(2000000)
    ->ArgName("triangles")
    ->Unit(benchmark::kMicrosecond);

// A commit, with all but one of the steps kept by the time it runs.
void BM_Commit(benchmark::State& state) {
    Editor editor(animal(static_cast<std::size_t>(state.range(0))).document);
    std::size_t step = 0;
    std::size_t copied = 0;
    for (auto _ : state) {
        state.PauseTiming();
        ++step;
        const Document before = editor.document();
        touch(editor, 3000 * step, 3000, static_cast<float>(step));
        for (std::size_t c = 0; c < before.groom.fur.chunkCount(); ++c)
            copied += !before.groom.fur.sharesChunk(editor.document().groom.fur, c);
        state.ResumeTiming();
        editor.commit("Step");
    }
    // Chunks of the fur of 3000 vertices, and the pointers of both arrays.
    const double pointers = 2.0 * sizeof(std::shared_ptr<int>) *
                            static_cast<double>(editor.document().groom.fur.chunkCount());
    state.counters["bytes_per_step"] =
        pointers + static_cast<double>(copied * 256 * sizeof(FurVertex)) /
                       static_cast<double>(state.iterations());
}
BENCHMARK(BM_Commit)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(2000000)
    ->ArgName("triangles")
    ->Unit(benchmark::kMicrosecond)
    ->Iterations(400);

void BM_UndoAndRedo(benchmark::State& state) {
    Editor editor(animal(static_cast<std::size_t>(state.range(0))).document);
    for (std::size_t step = 1; step <= Editor::kUndoSteps; ++step) {
        touch(editor, 3000 * step, 3000, static_cast<float>(step));
        editor.commit("Step");
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(editor.undo());
        benchmark::DoNotOptimize(editor.redo());
    }
}
BENCHMARK(BM_UndoAndRedo)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Arg(2000000)
    ->ArgName("triangles")
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace pelage::bench
