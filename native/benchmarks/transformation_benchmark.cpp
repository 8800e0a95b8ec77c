// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "analysis/immersion/sea_water.h"
#include "benchmarks/half_hull.h"
#include "benchmarks/ratio_report.h"
#include "modelling/transformation/section_shift.h"

namespace {

constexpr double kDraft = 7.0, kLength = 100.0, kBeam = 18.0;

// All that a change in the redo panel takes: prepared, shifted to another Cb and LCB, measured.
void BM_Transformation(benchmark::State& state, int refine, int halved_every) {
  const hull::surface::LimitSurface surface(
      hull::mesh::ControlMesh(hull::benchmarks::half_hull(refine, halved_every)));
  const hull::analysis::HullBody body(surface, true);
  const hull::analysis::FloatingPosition position{kDraft, 0.0, 0.0, 0.5 * kLength};
  const hull::analysis::ProjectDimensions project{kLength, kBeam, kDraft};
  const hull::analysis::Immersion before = body.immersion(hull::analysis::water_plane(position));
  hull::modelling::FormTargets targets;
  // A change as a designer makes it: 1 % of volume, and half a metre of LCB.
  targets.volume = {hull::modelling::VolumeMeasure::kVolume, 1.01 * before.volume};
  targets.lcb = before.centre_of_buoyancy.x() + 0.5;
  for (auto _ : state) {
    hull::modelling::SectionShift shift(body, position, project, hull::analysis::kSeaWaterDensity,
                                        {}, {});
    benchmark::DoNotOptimize(shift.solve(targets));
  }
  state.counters["points"] = static_cast<double>(surface.mesh().points().size());
}

BENCHMARK_CAPTURE(BM_Transformation, small, 1, 12)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Transformation, large, 3, 108)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Transformation, foreign, 3, 12)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv, {},
      {{"Cb and LCB met, 140 points", "BM_Transformation/small"},
       {"Cb and LCB met, 1,120 points", "BM_Transformation/large", 200.0},
       {"... of them triangulated in places", "BM_Transformation/foreign", 200.0}});
}
