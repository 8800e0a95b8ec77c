// SPDX-License-Identifier: GPL-3.0-or-later
// Three shape fields on a half hull, two that move and one that protects: what a change of falloff,
// extent or shift costs, and what a change of a base, after which other control points are within
// the extents.
#include <benchmark/benchmark.h>

#include <memory>
#include <utility>

#include "benchmarks/half_hull.h"
#include "benchmarks/half_hull_limits.h"
#include "benchmarks/ratio_report.h"
#include "modelling/fields/shape_fields.h"
#include "modelling/reshape/reshape.h"

namespace {

using hull::Vector3d;
using hull::modelling::FieldPlaces;
using hull::modelling::Reshape;
using hull::modelling::ReshapeOptions;
using hull::modelling::ShapeFields;
using hull::surface::LimitSurface;

ReshapeOptions options(const LimitSurface& hull) {
  ReshapeOptions options;
  options.limits = hull::benchmarks::half_hull_limits(hull);
  // Weights of the topology alone: made once, and shared by all that is made anew below.
  options.weights = std::make_shared<hull::modelling::PlaceWeights>(hull);
  return options;
}

// A fuller shoulder and a raised sheer, a line along the bottom protected.
ShapeFields fields(double falloff, double ahead) {
  using hull::modelling::AlongBase, hull::modelling::FieldCurve;
  hull::modelling::ShapeField shoulder, sheer, bottom;
  shoulder.base = hull::modelling::point_base({65.0 + ahead, 8.0, 4.0});
  shoulder.extent = AlongBase<double>(18.0);
  shoulder.shift = AlongBase<Vector3d>({0.0, 0.4, 0.0});
  sheer.base = hull::modelling::curve_base(
      FieldCurve::through({{60.0 + ahead, 8.5, 10.0}, {80.0, 7.0, 10.0}, {99.0, 1.0, 10.0}}));
  sheer.extent = AlongBase<double>(5.0);
  sheer.shift = AlongBase<Vector3d>({0.0, 0.0, 0.5});
  bottom.base =
      hull::modelling::curve_base(FieldCurve::through({{20.0, 3.0, 0.0}, {80.0, 3.0, 0.0}}));
  bottom.extent = AlongBase<double>(4.0);
  bottom.protects = true;
  std::vector<hull::modelling::ShapeField> all{shoulder, sheer, bottom};
  for (auto& field : all) field.kappa = AlongBase<double>(falloff);
  return {all, true, hull::modelling::FieldBlend::kExact};
}

FieldPlaces places_of(const hull::modelling::SurfacePlaces& places) {
  std::vector<Vector3d> points;
  for (int k = 0; k < places.count(); ++k) points.push_back(places.position(k));
  return FieldPlaces(std::move(points));
}

std::vector<Vector3d> shifts_of(const ShapeFields& fields, FieldPlaces& places) {
  std::vector<Vector3d> shifts;
  for (const auto& found : fields.at(places)) shifts.push_back(found.shift);
  return shifts;
}

// Which control points stay is known from before.
void BM_Falloff(benchmark::State& state, int refine, int halved_every) {
  const LimitSurface hull{
      hull::mesh::ControlMesh(hull::benchmarks::half_hull(refine, halved_every))};
  const Reshape reshape(hull, options(hull));
  FieldPlaces places = places_of(reshape.places());
  double falloff = 0.3;
  for (auto _ : state) {
    // Another one each time, as when a slider is drawn.
    falloff = falloff > 0.8 ? 0.3 : falloff + 0.01;
    benchmark::DoNotOptimize(reshape.solve(shifts_of(fields(falloff, 0.0), places)));
  }
  state.counters["points"] = static_cast<double>(hull.mesh().points().size());
}

void BM_Base(benchmark::State& state, int refine, int halved_every) {
  const LimitSurface hull{
      hull::mesh::ControlMesh(hull::benchmarks::half_hull(refine, halved_every))};
  const ReshapeOptions free = options(hull);
  const hull::modelling::SurfacePlaces places(hull, free.weights);
  FieldPlaces points = places_of(places);
  double ahead = 0.0;
  for (auto _ : state) {
    ahead = ahead > 5.0 ? 0.0 : ahead + 0.1;
    const std::vector<Vector3d> shifts = shifts_of(fields(0.6, ahead), points);
    ReshapeOptions own = free;
    // Points outside all extents stay: which those are changes with the base, and so does what has
    // to be factorised.
    own.limits.limits.locked = places.points_beyond(shifts);
    benchmark::DoNotOptimize(Reshape(hull, own).solve(shifts));
  }
}

// The processor's time of all threads together, however many there are.
BENCHMARK_CAPTURE(BM_Falloff, 140, 1, 12)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Falloff, 1120, 3, 108)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Base, 140, 1, 12)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Base, 1120, 3, 108)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv, {},
      {{"140 points, another falloff", "BM_Falloff/140/process_time", 16.0},
       {"140 points, another base", "BM_Base/140/process_time", 50.0},
       {"1,120 points, another falloff", "BM_Falloff/1120/process_time", 100.0},
       {"1,120 points, another base", "BM_Base/1120/process_time", 100.0}});
}
