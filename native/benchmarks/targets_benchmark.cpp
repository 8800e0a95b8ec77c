// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of a half hull's numbers by its control points, and five targets that it is brought
// to, at 140 and at some 1000 points. One thread.
#include <benchmark/benchmark.h>

#include "benchmarks/half_hull_surface.h"
#include "benchmarks/ratio_report.h"
#include "modelling/targets/targets.h"

namespace {

using hull::analysis::FormNumber;
using hull::benchmarks::half_hull_surface;
using hull::surface::LimitSurface;

constexpr hull::analysis::FloatingPosition kAfloat{6.0, 0.0, 0.0, 50.0};
constexpr hull::analysis::ProjectDimensions kProject{100.0, 18.0, 6.0};

// Faces and how many are halved, as of half_hull().
void hulls(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({1, 12})->Args({3, 108})->Args({3, 12});
}

void BM_Derivatives(benchmark::State& state) {
  const LimitSurface surface = half_hull_surface(state);
  const hull::analysis::HullBody body(surface, true);
  const hull::analysis::BodyDerivatives derivatives(body);
  const hull::analysis::Immersion immersion = body.immersion(water_plane(kAfloat));
  for (auto _ : state) benchmark::DoNotOptimize(derivatives.immersion(immersion));
}
BENCHMARK(BM_Derivatives)->Apply(hulls)->Unit(benchmark::kMillisecond);

void BM_FiveTargets(benchmark::State& state) {
  const LimitSurface surface = half_hull_surface(state);
  hull::modelling::TargetOptions options;
  options.water.position = kAfloat;
  options.water.project = kProject;
  for (std::size_t i = 0; i < surface.mesh().points().size(); ++i) {
    // Points in the centre plane stay in it.
    if (surface.mesh().points()[i].y() != 0.0) continue;
    options.limits.limits.held.push_back({static_cast<int>(i), hull::Vector3d::UnitY()});
  }
  const hull::analysis::HullBody body(surface, true);
  const hull::analysis::BodyDerivatives derivatives(body);
  // Targets are a little off what the hull has, wherever that is.
  hull::analysis::FormNumbers now(derivatives, kAfloat, kProject);
  std::vector<hull::modelling::FormTarget> targets;
  const auto want = [&](FormNumber number, double factor) {
    hull::modelling::FormTarget target;
    target.number = number;
    target.low = target.high = factor * now.value(number);
    targets.push_back(target);
  };
  want(FormNumber::kDisplacedVolume, 1.04);
  want(FormNumber::kLcb, 0.99);
  want(FormNumber::kProjectMidship, 1.005);
  want(FormNumber::kWaterplaneArea, 1.02);
  want(FormNumber::kKmTransverse, 1.01);
  for (auto _ : state) {
    const auto reached = hull::modelling::reach_targets(surface, targets, options);
    state.counters["steps"] = reached.iterations;
    // A time without the targets met would be none.
    if (reached.status != hull::modelling::TargetStatus::kMet) state.SkipWithError("not met");
  }
}
BENCHMARK(BM_FiveTargets)->Apply(hulls)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv, {},
      {{"five targets, 140 points", "BM_FiveTargets/1/12"},
       {"five targets, 1,120 points", "BM_FiveTargets/3/108", 1000.0},
       {"... of them triangulated in places", "BM_FiveTargets/3/12", 1000.0}});
}
