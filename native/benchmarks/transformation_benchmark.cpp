// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "benchmarks/half_hull.h"
#include "benchmarks/ratio_report.h"
#include "modelling/transformation/section_shift.h"

namespace {

constexpr double kDraft = 7.0, kLength = 100.0, kBeam = 18.0;

// 140 points, or 1,120 for refine = 3.
const hull::analysis::HullBody& body(int refine) {
  static const hull::surface::LimitSurface small(
      hull::mesh::ControlMesh(hull::benchmarks::half_hull())),
      large(hull::mesh::ControlMesh(hull::benchmarks::half_hull(3)));
  static const hull::analysis::HullBody small_body(small, true), large_body(large, true);
  return refine == 1 ? small_body : large_body;
}

// All that a change in the redo panel takes: prepared, shifted to another Cb and LCB, measured.
void BM_Transformation(benchmark::State& state, int refine) {
  const hull::analysis::FloatingPosition position{kDraft, 0.0, 0.0, 0.5 * kLength};
  const hull::analysis::ProjectDimensions project{kLength, kBeam, kDraft};
  const hull::analysis::Immersion before =
      body(refine).immersion(hull::analysis::water_plane(position));
  hull::modelling::FormTargets targets;
  targets.volume = {hull::modelling::VolumeMeasure::kVolume, 1.01 * before.volume};
  targets.lcb = before.centre_of_buoyancy.x() + 0.5;
  for (auto _ : state) {
    hull::modelling::SectionShift shift(body(refine), position, project, 1.025, {}, {});
    benchmark::DoNotOptimize(shift.solve(targets));
  }
  state.counters["points"] = static_cast<double>(body(refine).surface().mesh().points().size());
}

BENCHMARK_CAPTURE(BM_Transformation, small, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Transformation, large, 3)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv, {},
      {{"Cb and LCB met, 140 points", "BM_Transformation/small"},
       {"Cb and LCB met, 1,120 points", "BM_Transformation/large", 200.0}});
}
