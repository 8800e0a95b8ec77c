// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of triangles alone, small and large: the surface with its particulars afloat, and the
// conversion to patches. What is told per triangle must not grow with their number.
#include <benchmark/benchmark.h>

#include <cmath>

#include "analysis/hydrostatics/hydrostatics.h"
#include "benchmarks/ratio_report.h"
#include "conversion/exact/exact_conversion.h"

namespace {

using hull::surface::LimitSurface;

// Half a hull of 2 n² triangles, 100 x 10 x 10 m: six around every inner point.
hull::mesh::MeshArrays half_hull_of_triangles(int n) {
  hull::mesh::MeshArrays mesh;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
      // Not quite to the ends, where the hull would have no breadth; the keel is put into the
      // centre plane.
      const double y = 10.0 * std::sin(3.14159265 * (0.05 + 0.9 * s)) * std::sqrt(0.01 + t);
      mesh.points.emplace_back(100.0 * s, t > 0.0 ? y : 0.0, 10.0 * t * t);
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      mesh.face_sizes.insert(mesh.face_sizes.end(), {3, 3});
      // All halved along one diagonal, which makes six triangles meet in a point.
      mesh.face_vertices.insert(mesh.face_vertices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  return mesh;
}

void count_triangles(benchmark::State& state) {
  const double n = static_cast<double>(state.range(0));
  state.counters["triangles/s"] =
      benchmark::Counter(2.0 * n * n, benchmark::Counter::kIsIterationInvariantRate);
}

void BM_HydrostaticsOfTriangles(benchmark::State& state) {
  const hull::mesh::ControlMesh mesh(half_hull_of_triangles(static_cast<int>(state.range(0))));
  for (auto _ : state) {
    benchmark::DoNotOptimize(hull::analysis::upright_hydrostatics(LimitSurface(mesh), 6.0, true));
  }
  count_triangles(state);
}

void BM_PatchesOfTriangles(benchmark::State& state) {
  const LimitSurface surface{
      hull::mesh::ControlMesh(half_hull_of_triangles(static_cast<int>(state.range(0))))};
  std::size_t points = 0;
  for (auto _ : state) {
    const hull::conversion::PatchSet set = hull::conversion::exact_patches(surface);
    // Of the last time, as all are alike.
    points = 0;
    for (const auto& patch : set.patches) points += patch.control_points.size();
  }
  count_triangles(state);
  const double n = static_cast<double>(state.range(0));
  state.counters["points/triangle"] = static_cast<double>(points) / (2.0 * n * n);
}

BENCHMARK(BM_HydrostaticsOfTriangles)->Arg(10)->Arg(34)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PatchesOfTriangles)->Arg(10)->Arg(34)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv, {},
      {{"hydrostatics of 20,000 triangles", "BM_HydrostaticsOfTriangles/100", 5000.0},
       {"2,312 triangles as patches", "BM_PatchesOfTriangles/34", 15000.0}});
}
