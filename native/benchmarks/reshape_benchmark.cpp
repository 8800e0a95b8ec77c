// SPDX-License-Identifier: GPL-3.0-or-later
// Wanted shifts of the surface, of half hulls of 140 and of 1,120 points within the limits that
// tools give them. One face in twelve is halved: many more points are irregular than on a hull that
// was modelled with so many.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "benchmarks/half_hull.h"
#include "benchmarks/half_hull_limits.h"
#include "benchmarks/ratio_report.h"
#include "modelling/reshape/reshape.h"

namespace {

using hull::Vector3d;
using hull::modelling::PlaceWeights;
using hull::modelling::Reshape;
using hull::modelling::ReshapeOptions;
using hull::surface::LimitSurface;

// Both kept for all benchmarks: building them is not of these times.
const LimitSurface& surface(int refine) {
  static const LimitSurface small{hull::mesh::ControlMesh(hull::benchmarks::half_hull())};
  static const LimitSurface large{hull::mesh::ControlMesh(hull::benchmarks::half_hull(3))};
  return refine == 1 ? small : large;
}

ReshapeOptions options(const LimitSurface& hull) {
  ReshapeOptions options;
  options.limits = hull::benchmarks::half_hull_limits(hull);
  return options;
}

// Fuller by a tenth around the middle.
std::vector<Vector3d> shifts(const Reshape& reshape) {
  std::vector<Vector3d> result;
  for (int k = 0; k < reshape.places().count(); ++k) {
    const Vector3d& p = reshape.places().position(k);
    result.emplace_back(0.0, 0.1 * p.y() * std::exp(-std::pow((p.x() - 50.0) / 20.0, 2)), 0.0);
  }
  return result;
}

// All of it, limits included.
void BM_Prepare(benchmark::State& state, int refine, int per_side) {
  const LimitSurface& hull = surface(refine);
  for (auto _ : state) {
    // Within the loop, since limits are part of what is prepared.
    ReshapeOptions own = options(hull);
    own.weights = std::make_shared<PlaceWeights>(hull, per_side);
    benchmark::DoNotOptimize(Reshape(hull, own));
  }
  state.counters["points"] = static_cast<double>(hull.mesh().points().size());
}

void BM_Weights(benchmark::State& state, int refine, int per_side) {
  for (auto _ : state) benchmark::DoNotOptimize(PlaceWeights(surface(refine), per_side));
}

void BM_Limits(benchmark::State& state, int refine) {
  for (auto _ : state) benchmark::DoNotOptimize(options(surface(refine)));
}

// With weights and limits of before, as for the same topology with its points elsewhere.
void BM_PrepareAgain(benchmark::State& state, int refine, int per_side) {
  const LimitSurface& hull = surface(refine);
  ReshapeOptions own = options(hull);
  own.weights = std::make_shared<PlaceWeights>(hull, per_side);
  for (auto _ : state) benchmark::DoNotOptimize(Reshape(hull, own));
}

void BM_Solve(benchmark::State& state, int refine, int per_side) {
  const LimitSurface& hull = surface(refine);
  ReshapeOptions own = options(hull);
  own.weights = std::make_shared<PlaceWeights>(hull, per_side);
  const Reshape reshape(hull, own);
  const std::vector<Vector3d> wanted = shifts(reshape);
  for (auto _ : state) benchmark::DoNotOptimize(reshape.solve(wanted));
}

BENCHMARK_CAPTURE(BM_Prepare, 140, 1, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_PrepareAgain, 140, 1, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Solve, 140, 1, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Prepare, 1120, 3, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Prepare, 1120_two, 3, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Weights, 1120, 3, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Limits, 1120, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_PrepareAgain, 1120, 3, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_PrepareAgain, 1120_two, 3, 2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Solve, 1120, 3, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Solve, 1120_two, 3, 2)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv,
      {{"1,120 points again instead of anew", "BM_PrepareAgain/1120", "BM_Prepare/1120"},
       {"two places a side instead of three", "BM_Prepare/1120_two", "BM_Prepare/1120"}},
      {{"140 points, prepared", "BM_Prepare/140"},
       {"140 points, solved", "BM_Solve/140", 16.0},
       {"1,120 points, prepared", "BM_Prepare/1120", 100.0},
       {"1,120 points, weights of places alone", "BM_Weights/1120"},
       {"1,120 points, limits of the centre plane alone", "BM_Limits/1120"},
       {"1,120 points, prepared again", "BM_PrepareAgain/1120"},
       {"1,120 points, solved", "BM_Solve/1120"}});
}
