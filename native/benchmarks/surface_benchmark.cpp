// SPDX-License-Identifier: GPL-3.0-or-later
// The exact surface beside OpenSubdiv's Bfr::Surface<double> and Far::LimitStencilTableReal<double>
// (ten levels at irregular points, where they approximate all the same) on the same mesh, a half
// hull of 140 points. One thread, but where two are named. Times are per iteration; the counter
// "points" is in points a second. At the end the ratios are named.
#include <benchmark/benchmark.h>

#include <memory>
#include <random>

#include "benchmarks/half_hull.h"
#include "benchmarks/osd_surfaces.h"
#include "benchmarks/ratio_report.h"
#include "surface/parallel_for.h"
#include "surface/sampling/grid_samples.h"

namespace {

namespace bfr = hull::benchmarks::bfr;
using hull::Vector3d;
using hull::benchmarks::BfrSurfaces;
using hull::benchmarks::LimitStencils;
using hull::surface::LimitSurface;

hull::mesh::ControlMesh control_mesh(int refine = 1) {
  return hull::mesh::ControlMesh(hull::benchmarks::half_hull(refine));
}

constexpr int kGrid = 16;

void BM_GridOurs(benchmark::State& state) {
  // The scheme that OpenSubdiv has, for the same surface.
  const hull::surface::LimitSurface surface(control_mesh(), hull::surface::Scheme::kCatmullClark);
  hull::surface::GridSamples samples;
  for (auto _ : state) {
    hull::surface::evaluate_grid(surface, kGrid, static_cast<int>(state.range(0)), samples);
    benchmark::DoNotOptimize(samples.points.data());
  }
  state.counters["points"] =
      benchmark::Counter(static_cast<double>(surface.cell_count() * (kGrid + 1) * (kGrid + 1)),
                         benchmark::Counter::kIsIterationInvariantRate);
}

// The same number of points, on a grid of each quadrilateral, or each corner's part of other faces.
void BM_GridBfr(benchmark::State& state) {
  const hull::mesh::MeshArrays mesh = hull::benchmarks::half_hull();
  BfrSurfaces surfaces(mesh);
  surfaces.build(10);
  // Out of the clock, as the exact surface has its pieces made too.
  surfaces.prepare();
  const int order = static_cast<int>(state.range(0));
  std::int64_t count = 0;
  double out[18];
  for (auto _ : state) {
    // Counted within the loop, which visits every corner of every face.
    count = 0;
    for (int face = 0; face < surfaces.face_count(); ++face) {
      const bfr::Parameterization parameters = surfaces.parameters(face);
      for (int corner = 0; corner < mesh.face_sizes[face]; ++corner) {
        double at[2];
        parameters.GetVertexCoord(corner, at);
        // A quadrilateral is the unit square; of other faces each corner is the origin of its own.
        const bool is_quad = mesh.face_sizes[face] == 4;
        const double along_u = is_quad && at[0] > 0.5 ? -1.0 : 1.0;
        const double along_v = is_quad && at[1] > 0.5 ? -1.0 : 1.0;
        for (int j = 0; j <= kGrid; ++j) {
          for (int i = 0; i <= kGrid; ++i) {
            // Half the face's side from the corner inwards.
            const double s = 0.5 * i / kGrid, t = 0.5 * j / kGrid;
            const double uv[2] = {at[0] + along_u * s, at[1] + along_v * t};
            surfaces.evaluate(face, uv, order, out);
            benchmark::DoNotOptimize(out);
            ++count;
          }
        }
      }
    }
  }
  state.counters["points"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
}

void BM_GridStencils(benchmark::State& state) {
  const hull::mesh::MeshArrays mesh = hull::benchmarks::half_hull();
  // The stencils are made out of the clock; what is timed are their sums.
  LimitStencils stencils(mesh, kGrid, static_cast<int>(state.range(0)), 10);
  for (auto _ : state) {
    stencils.evaluate();
    benchmark::DoNotOptimize(stencils.points());
  }
  state.counters["points"] =
      benchmark::Counter(stencils.count(), benchmark::Counter::kIsIterationInvariantRate);
}

constexpr int kScattered = 20000;

struct Place {
  int cell;
  double u, v;
};

// The same in every run.
std::vector<Place> scattered_places(int cells, std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Place> places(count);
  for (Place& place : places) {
    place = {static_cast<int>(unit(random) * cells), unit(random), unit(random)};
  }
  return places;
}

void BM_ScatteredOurs(benchmark::State& state) {
  const hull::surface::LimitSurface surface(control_mesh(), hull::surface::Scheme::kCatmullClark);
  const std::vector<Place> places = scattered_places(surface.cell_count(), kScattered);
  const int order = static_cast<int>(state.range(0));
  hull::surface::SurfaceJet jet;
  for (auto _ : state) {
    for (const Place& place : places) {
      surface.evaluate(place.cell, place.u, place.v, order, jet);
      benchmark::DoNotOptimize(&jet);
    }
  }
  state.counters["points"] = benchmark::Counter(static_cast<double>(kScattered),
                                                benchmark::Counter::kIsIterationInvariantRate);
}

void BM_ScatteredBfr(benchmark::State& state) {
  const hull::mesh::MeshArrays mesh = hull::benchmarks::half_hull();
  BfrSurfaces surfaces(mesh);
  surfaces.build(10);
  surfaces.prepare();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<std::pair<int, Eigen::Vector2d>> places(kScattered);
  for (auto& [face, uv] : places) {
    face = static_cast<int>(unit(random) * surfaces.face_count());
    uv = {unit(random), unit(random)};
    if (mesh.face_sizes[face] == 4) continue;
    // In the quarter of a random corner of faces that are cut up.
    const auto corner = static_cast<int>(unit(random) * mesh.face_sizes[face]);
    double at[2];
    surfaces.parameters(face).GetVertexCoord(corner, at);
    uv = {at[0] + 0.5 * uv.x(), at[1] + 0.5 * uv.y()};
  }
  const int order = static_cast<int>(state.range(0));
  double out[18];
  for (auto _ : state) {
    for (const auto& [face, uv] : places) {
      surfaces.evaluate(face, uv.data(), order, out);
      benchmark::DoNotOptimize(out);
    }
  }
  state.counters["points"] = benchmark::Counter(static_cast<double>(kScattered),
                                                benchmark::Counter::kIsIterationInvariantRate);
}

void BM_ConstructCold(benchmark::State& state) {
  const hull::mesh::ControlMesh mesh = control_mesh();
  for (auto _ : state) {
    benchmark::DoNotOptimize(hull::surface::LimitSurface(mesh, hull::surface::Scheme::kBiermann));
  }
}

void BM_ConstructWarm(benchmark::State& state) {
  const hull::mesh::ControlMesh mesh = control_mesh();
  // From the second time on all bases at irregular points are known.
  const auto cache = std::make_shared<hull::surface::BasisCache>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        hull::surface::LimitSurface(mesh, hull::surface::Scheme::kBiermann, cache));
  }
}

void BM_ConstructBfr(benchmark::State& state) {
  const hull::mesh::MeshArrays mesh = hull::benchmarks::half_hull();
  BfrSurfaces surfaces(mesh);
  for (auto _ : state) surfaces.build(static_cast<int>(state.range(0)));
}

void BM_SetPointsOurs(benchmark::State& state) {
  const hull::mesh::ControlMesh mesh = control_mesh();
  hull::surface::LimitSurface surface(mesh, hull::surface::Scheme::kBiermann);
  for (auto _ : state) surface.set_points(mesh.points());
}

void BM_PreparePatchPointsBfr(benchmark::State& state) {
  const hull::mesh::MeshArrays mesh = hull::benchmarks::half_hull();
  BfrSurfaces surfaces(mesh);
  surfaces.build(static_cast<int>(state.range(0)));
  for (auto _ : state) surfaces.prepare();
}

// A million places, shared out among threads on one surface.
void BM_MillionPoints(benchmark::State& state) {
  constexpr std::size_t kCount = 1'000'000;
  const hull::surface::LimitSurface surface(control_mesh());
  const std::vector<Place> places = scattered_places(surface.cell_count(), kCount);
  std::vector<Vector3d> points(kCount);
  const int threads = static_cast<int>(state.range(0));
  for (auto _ : state) {
    hull::surface::parallel_for(kCount, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        // Each thread writes into a range of its own.
        points[i] = surface.position(places[i].cell, places[i].u, places[i].v);
      }
    });
    benchmark::DoNotOptimize(points.data());
  }
}

// A grid's points with first derivatives are 72 MB, which memory takes in little faster from two.
void BM_MillionGridPoints(benchmark::State& state) {
  constexpr int kFine = 45;  // 474 cells of 46 x 46 samples
  const hull::surface::LimitSurface surface(control_mesh());
  hull::surface::GridSamples samples;
  for (auto _ : state) {
    hull::surface::evaluate_grid(surface, kFine, 1, samples, static_cast<int>(state.range(0)));
    benchmark::DoNotOptimize(samples.points.data());
  }
}

BENCHMARK(BM_GridOurs)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_GridBfr)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_GridStencils)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ScatteredOurs)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ScatteredBfr)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ConstructCold)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ConstructBfr)->Arg(10)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ConstructWarm)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_SetPointsOurs)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_PreparePatchPointsBfr)->Arg(6)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_MillionPoints)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_MillionGridPoints)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv,
      {{"grid to Bfr, positions", "BM_GridOurs/0", "BM_GridBfr/0", 8.0},
       {"grid to Bfr, first derivatives", "BM_GridOurs/1", "BM_GridBfr/1", 8.0},
       {"grid to Bfr, second derivatives", "BM_GridOurs/2", "BM_GridBfr/2", 8.0},
       {"grid to LimitStencilTable, positions", "BM_GridOurs/0", "BM_GridStencils/0"},
       {"grid to LimitStencilTable, first derivatives", "BM_GridOurs/1", "BM_GridStencils/1"},
       {"grid to LimitStencilTable, second derivatives", "BM_GridOurs/2", "BM_GridStencils/2"},
       {"scattered to Bfr, positions", "BM_ScatteredOurs/0", "BM_ScatteredBfr/0", 2.5},
       {"scattered to Bfr, first derivatives", "BM_ScatteredOurs/1", "BM_ScatteredBfr/1", 3.0},
       {"scattered to Bfr, second derivatives", "BM_ScatteredOurs/2", "BM_ScatteredBfr/2", 4.0},
       {"construction, cold, to Bfr at ten levels", "BM_ConstructCold", "BM_ConstructBfr/10", 1.0},
       {"set_points to Bfr's, six levels", "BM_SetPointsOurs", "BM_PreparePatchPointsBfr/6", 1.0},
       {"10^6 scattered points, two threads to one", "BM_MillionPoints/2/real_time",
        "BM_MillionPoints/1/real_time", 1.7},
       {"10^6 grid points, two threads to one", "BM_MillionGridPoints/2/real_time",
        "BM_MillionGridPoints/1/real_time"}},
      {{"construction, warm", "BM_ConstructWarm", 0.5}});
}
