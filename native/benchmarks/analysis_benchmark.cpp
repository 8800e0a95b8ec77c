// SPDX-License-Identifier: GPL-3.0-or-later
// What a designer waits for after moving a point. One thread, a half hull of 140 points.
#include <benchmark/benchmark.h>

#include "analysis/sections/sections.h"
#include "benchmarks/half_hull.h"
#include "surface/tessellation.h"

namespace {

const hull::LimitSurface& surface() {
  static const hull::LimitSurface built{hull::ControlMesh(hull::benchmarks::half_hull())};
  return built;
}

// 21 stations, 11 waterlines, 7 buttocks to 1 mm.
void BM_Lines(benchmark::State& state) {
  constexpr double kTolerance = 1e-3;
  for (auto _ : state) {
    for (int i = 0; i < 21; ++i) {
      benchmark::DoNotOptimize(hull::section(surface(), hull::Axis::kX, 5.0 * i, kTolerance));
    }
    for (int i = 0; i < 11; ++i) {
      benchmark::DoNotOptimize(hull::section(surface(), hull::Axis::kZ, 0.9 * i, kTolerance));
    }
    for (int i = 0; i < 7; ++i) {
      benchmark::DoNotOptimize(hull::section(surface(), hull::Axis::kY, 1.2 * i, kTolerance));
    }
  }
}

void BM_Tessellate(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(hull::tessellate(surface(), static_cast<int>(state.range(0))));
  }
}

BENCHMARK(BM_Lines)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Tessellate)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);

}  // namespace
