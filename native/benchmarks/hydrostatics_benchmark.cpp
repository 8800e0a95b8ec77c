// SPDX-License-Identifier: GPL-3.0-or-later
// Hydrostatics and stability of a half hull of 140 points, one thread, beside what triangles of an
// accuracy of 1e-6 take for the volume alone, and Open CASCADE for that of the exported patches.
#include <benchmark/benchmark.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <cmath>
#include <numbers>

#include "analysis/hydrostatics/hydrostatics.h"
#include "analysis/stability/righting_levers.h"
#include "benchmarks/half_hull.h"
#include "benchmarks/ratio_report.h"
#include "conversion/patches/flat_patches.h"
#include "conversion/per_cell/per_cell.h"
#include "exchange/solids/brep_shape.h"
#include "surface/sampling/grid_samples.h"

namespace {

using hull::Vector3d;
using hull::analysis::HullBody;
using hull::surface::LimitSurface;

constexpr double kDraft = 6.0;
constexpr hull::analysis::ProjectDimensions kProject{100.0, 18.0, kDraft};

const hull::mesh::ControlMesh& control_mesh() {
  static const hull::mesh::ControlMesh mesh(hull::benchmarks::half_hull());
  return mesh;
}

const hull::surface::LimitSurface& surface() {
  static const hull::surface::LimitSurface built(control_mesh());
  return built;
}

hull::analysis::HullBody make_body(const hull::surface::LimitSurface& of, double tolerance) {
  return {of, true, hull::analysis::Openings::kClosed, tolerance};
}

const hull::analysis::HullBody& body(double tolerance = hull::analysis::kFinest) {
  // One body of each tolerance for all benchmarks: what is prepared once is not of these times.
  static const hull::analysis::HullBody finest = make_body(surface(), hull::analysis::kFinest);
  static const hull::analysis::HullBody live = make_body(surface(), hull::analysis::kLive);
  return tolerance == hull::analysis::kLive ? live : finest;
}

// A surface and its live body, whose points are moved to and fro.
class MovingBody {
 public:
  MovingBody(std::size_t moved, double tolerance)
      : surface_(control_mesh()), body_(make_body(surface_, tolerance)) {
    points_[0] = points_[1] = control_mesh().points();
    for (std::size_t i = 0; i < moved; ++i) {
      // From the middle of the hull, so that one point is one that matters.
      points_[1][points_[1].size() / 2 - moved / 2 + i].y() *= 1.001;
    }
  }
  const hull::analysis::HullBody& move() {
    // To and fro, so that nothing grows and no two updates are alike.
    surface_.set_points(points_[++count_ % 2]);
    body_.update();
    return body_;
  }

 private:
  hull::surface::LimitSurface surface_;
  hull::analysis::HullBody body_;
  std::vector<Vector3d> points_[2];
  int count_ = 0;
};

// Another draft each time, near enough for the same work.
double next_draft() {
  static int count = 0;
  return kDraft + 1e-3 * (++count % 100);
}

void BM_Immersion(benchmark::State& state, double tolerance) {
  const hull::analysis::HullBody& floating = body(tolerance);
  for (auto _ : state) {
    benchmark::DoNotOptimize(floating.immersion({Vector3d::UnitZ(), next_draft()}));
  }
}

void BM_Hydrostatics(benchmark::State& state, double tolerance) {
  const hull::analysis::HullBody& floating = body(tolerance);
  for (auto _ : state) {
    benchmark::DoNotOptimize(hull::analysis::hydrostatics(floating, {next_draft()}, kProject));
  }
}

// All points moved, or one of them.
void BM_HydrostaticsAfterSetPoints(benchmark::State& state, std::size_t moved, double tolerance) {
  MovingBody moving(moved, tolerance);
  for (auto _ : state) {
    benchmark::DoNotOptimize(hull::analysis::hydrostatics(moving.move(), {kDraft}, kProject));
  }
}

void BM_VolumeAfterSetPoints(benchmark::State& state, std::size_t moved, double tolerance) {
  MovingBody moving(moved, tolerance);
  for (auto _ : state) {
    benchmark::DoNotOptimize(moving.move().immersion({Vector3d::UnitZ(), kDraft}));
  }
}

void BM_RightingLevers(benchmark::State& state) {
  std::vector<double> heels;
  for (int i = 0; i < 19; ++i) heels.push_back(std::numbers::pi / 180.0 * 5.0 * i);
  const hull::analysis::Immersion upright = body().immersion({Vector3d::UnitZ(), kDraft});
  // Afloat level at the draft, with the centre of gravity above the base line by 5.5 m.
  const hull::analysis::LoadCase load{upright.volume * hull::analysis::kSeaWaterDensity,
                                      {upright.centre_of_buoyancy.x(), 0.0, 5.5}};
  for (auto _ : state) {
    benchmark::DoNotOptimize(hull::analysis::righting_levers(body(), load, heels));
  }
}

// Volume of the prism between the part of a triangle that is below the water and the water.
double prism_volume(const Vector3d* corners, double draft) {
  // The polygon left of the triangle below the water.
  Vector3d kept[4];
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const Vector3d &a = corners[i], &b = corners[(i + 1) % 3];
    const double ha = a.z() - draft, hb = b.z() - draft;
    if (ha < 0.0) kept[count++] = a;
    // Of a triangle that the water cuts, three or four corners are left (Sutherland and Hodgman
    // 1974).
    if ((ha < 0.0) != (hb < 0.0)) kept[count++] = a + (b - a) * (ha / (ha - hb));
  }
  double volume = 0.0;
  for (int i = 1; i + 1 < count; ++i) {
    const Vector3d &a = kept[0], &b = kept[i], &c = kept[i + 1];
    const double area =
        0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
    // The divergence theorem with the field (0, 0, z - draft), which vanishes on the water: no lid
    // is needed.
    volume += area * ((a.z() + b.z() + c.z()) / 3.0 - draft);
  }
  return volume;
}

double triangulated_volume(const hull::surface::GridSamples& samples, int cells, double draft) {
  double volume = 0.0;
  for (int cell = 0; cell < cells; ++cell) {
    for (int i = 0; i < samples.n; ++i) {
      for (int j = 0; j < samples.n; ++j) {
        const Vector3d& a = samples.points[samples.index(cell, i, j)];
        const Vector3d& b = samples.points[samples.index(cell, i + 1, j)];
        const Vector3d& c = samples.points[samples.index(cell, i + 1, j + 1)];
        const Vector3d& d = samples.points[samples.index(cell, i, j + 1)];
        const Vector3d lower[] = {a, b, c}, upper[] = {a, c, d};
        volume += prism_volume(lower, draft) + prism_volume(upper, draft);
      }
    }
  }
  // Both sides.
  return 2.0 * volume;
}

// Divisions of a cell's side that make the triangles' volume right to 1e-6.
int fine_enough() {
  const double exact = body().immersion({Vector3d::UnitZ(), kDraft}).volume;
  for (int n = 8; n < 256; ++n) {
    const double volume = triangulated_volume(hull::surface::evaluate_grid(surface(), n, 0),
                                              surface().cell_count(), kDraft);
    if (std::abs(volume - exact) <= 1e-6 * exact) return n;
  }
  return 256;
}

void BM_TriangulatedVolume(benchmark::State& state) {
  static const int n = fine_enough();
  hull::surface::GridSamples samples;
  for (auto _ : state) {
    // With the points made anew, as they are after a move.
    hull::surface::evaluate_grid(surface(), n, 0, samples);
    benchmark::DoNotOptimize(triangulated_volume(samples, surface().cell_count(), kDraft));
  }
  state.counters["triangles"] = 2.0 * surface().cell_count() * n * n;
}

// Of the whole shell: Open CASCADE would have to cut it by the water first.
void BM_OpenCascadeVolume(benchmark::State& state) {
  const hull::conversion::PatchSet patches = hull::conversion::fit_per_cell(surface());
  const TopoDS_Shape shape =
      hull::exchange::make_brep_shape(hull::conversion::without_flat_patches(patches).patches)
          .shape;
  for (auto _ : state) {
    GProp_GProps volume;
    // Without a tolerance: by a fixed rule.
    BRepGProp::VolumeProperties(shape, volume);
    benchmark::DoNotOptimize(volume.Mass());
  }
}

BENCHMARK_CAPTURE(BM_Immersion, finest, hull::analysis::kFinest)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Immersion, live, hull::analysis::kLive)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Hydrostatics, finest, hull::analysis::kFinest)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Hydrostatics, live, hull::analysis::kLive)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_HydrostaticsAfterSetPoints, all, 140, hull::analysis::kLive)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_HydrostaticsAfterSetPoints, one, 1, hull::analysis::kLive)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_VolumeAfterSetPoints, all, 140, hull::analysis::kLive)
    ->Unit(benchmark::kMillisecond);
// To the accuracy of the triangles that it is compared with.
BENCHMARK_CAPTURE(BM_VolumeAfterSetPoints, all_1e6, 140, 1e-6)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_VolumeAfterSetPoints, one, 1, hull::analysis::kLive)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_RightingLevers)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_TriangulatedVolume)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_OpenCascadeVolume)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv,
      {{"volume to 1e-6 by triangles, points moved", "BM_VolumeAfterSetPoints/all_1e6",
        "BM_TriangulatedVolume", 20.0},
       {"volume of the shell by Open CASCADE", "BM_VolumeAfterSetPoints/all",
        "BM_OpenCascadeVolume"}},
      {{"all hydrostatics at a new draft, to 1e-8", "BM_Hydrostatics/live", 1.0},
       {"all hydrostatics at a new draft, to 1e-13", "BM_Hydrostatics/finest"},
       {"all hydrostatics after all points moved, to 1e-8", "BM_HydrostaticsAfterSetPoints/all",
        1.5},
       {"all hydrostatics after one point moved, to 1e-8", "BM_HydrostaticsAfterSetPoints/one"},
       {"volume after one point moved, to 1e-8", "BM_VolumeAfterSetPoints/one"},
       {"19 righting levers, free trim", "BM_RightingLevers", 100.0}});
}
