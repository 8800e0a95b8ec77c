// SPDX-License-Identifier: GPL-3.0-or-later
// Two half hulls of triangles, laid into one polygon and merged: of the size of Kang & Lee 2012,
// who needed 15 s, and of 62,000 triangles.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "benchmarks/half_hull.h"
#include "benchmarks/ratio_report.h"
#include "morphing/overlay/merged_discs.h"
#include "surface/limit_surface.h"
#include "surface/sampling/tessellation.h"

namespace {

using hull::morphing::ConvexPolygon;
using hull::morphing::DiscMap;
using hull::morphing::TriangleDisc;

// A finer one has its stations moved forward, so that edges of two cross everywhere.
TriangleDisc half_hull(int refine, int divisions, double fineness) {
  const hull::surface::LimitSurface surface{
      hull::mesh::ControlMesh(hull::benchmarks::half_hull(refine))};
  hull::surface::Tessellation facets = hull::surface::tessellate(surface, divisions);
  for (hull::Vector3d& p : facets.points) {
    p.x() = 100.0 * std::pow(std::max(0.0, p.x()) / 100.0, fineness);
  }
  std::vector<hull::morphing::Triangle> triangles;
  for (const auto& [a, b, c, d] : facets.quads) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return {std::move(facets.points), triangles};
}

// Fore and aft ends of keel and deck.
std::vector<int> corners_of(const TriangleDisc& disc) {
  const auto best = [&](double forward, double up) {
    int found = -1;
    double most = -1e9;
    for (int h : disc.border()) {
      const hull::Vector3d& p = disc.points()[disc.topology().origin(h)];
      const double value = forward * p.x() + up * p.z();
      if (value > most) std::tie(found, most) = std::make_pair(disc.topology().origin(h), value);
    }
    return found;
  };
  return {best(-1, -1), best(-1, 1), best(1, 1), best(1, -1)};
}

DiscMap mapped(const TriangleDisc& disc) {
  return {disc, corners_of(disc), ConvexPolygon({{0, 0}, {1, 0.1}, {1, 0.3}, {0, 0.3}})};
}

void BM_Map(benchmark::State& state, int refine, int divisions) {
  const TriangleDisc disc = half_hull(refine, divisions, 1.0);
  for (auto _ : state) benchmark::DoNotOptimize(mapped(disc));
  state.counters["triangles"] = disc.triangle_count();
}

// From triangles to the merged mesh.
void BM_Merge(benchmark::State& state, int refine, int divisions, int other_refine,
              int other_divisions) {
  const TriangleDisc first = half_hull(refine, divisions, 1.0);
  const TriangleDisc second = half_hull(other_refine, other_divisions, 1.3);
  std::size_t triangles = 0;
  for (auto _ : state) {
    const hull::morphing::MergedDiscs merged(mapped(first), mapped(second));
    triangles = merged.triangles().size();
  }
  state.counters["triangles"] = first.triangle_count();
  state.counters["others"] = second.triangle_count();
  state.counters["merged"] = static_cast<double>(triangles);
}

BENCHMARK_CAPTURE(BM_Map, large, 2, 4)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Merge, paper, 1, 1, 1, 1)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Merge, large, 2, 4, 1, 8)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv, {},
      {{"two parents of some 550 points", "BM_Merge/paper/process_time", 100.0},
       {"one of 62,000 triangles laid into a polygon", "BM_Map/large/process_time", 0.0},
       {"two of 62,000 triangles", "BM_Merge/large/process_time", 10000.0}});
}
