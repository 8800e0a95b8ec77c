// SPDX-License-Identifier: GPL-3.0-or-later
// Two half hulls of triangles, laid into one polygon and merged: of the size of Kang & Lee 2012,
// who needed 15 s, and of 62,000 triangles. And what a moved weight of a family of two parents of
// 140 points takes, with its lines and numbers.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "analysis/hydrostatics/hydrostatics.h"
#include "analysis/sections/sections.h"
#include "benchmarks/half_hull.h"
#include "benchmarks/ratio_report.h"
#include "morphing/families/hull_family.h"
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
  // Halved along one diagonal all over.
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
      // The border's point farthest in this direction.
      const double value = forward * p.x() + up * p.z();
      if (value > most) std::tie(found, most) = std::make_pair(disc.topology().origin(h), value);
    }
    return found;
  };
  return {best(-1, -1), best(-1, 1), best(1, 1), best(1, -1)};
}

DiscMap mapped(const TriangleDisc& disc) {
  // Both discs go into one polygon, their four corners to its own.
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

// 21 stations, 11 waterlines and 7 buttocks.
std::vector<hull::analysis::Plane> planes() {
  using hull::analysis::Axis, hull::analysis::plane_across;
  std::vector<hull::analysis::Plane> all;
  for (int i = 0; i < 21; ++i) all.push_back(plane_across(Axis::kX, 5.0 * i));
  for (int i = 0; i < 11; ++i) all.push_back(plane_across(Axis::kZ, 0.9 * i));
  for (int i = 0; i < 7; ++i) all.push_back(plane_across(Axis::kY, 1.2 * i));
  return all;
}

// A half hull, and one that is longer, fuller aft and deeper forward.
hull::morphing::HullFamily two_parents() {
  hull::mesh::MeshArrays mesh = hull::benchmarks::half_hull();
  const hull::surface::LimitSurface first{hull::mesh::ControlMesh(mesh)};
  for (hull::Vector3d& p : mesh.points) {
    const double ahead = p.x() / 100.0;
    p.x() *= 1.1;
    p.y() *= 1.15 - 0.1 * ahead;
    p.z() *= 1.0 + 0.1 * ahead * ahead;
  }
  return hull::morphing::HullFamily(
      {first, hull::surface::LimitSurface(hull::mesh::ControlMesh(mesh))});
}

// What a moved slider asks for: the member, whether it is folded, its surface, numbers and lines,
// all at the accuracy of live work (1 mm for lines). A hundred weights to and fro.
void BM_Member(benchmark::State& state) {
  constexpr double kDraft = 6.0;
  const hull::morphing::HullFamily family = two_parents();
  // A copy, whose points are set: nothing is built anew for a member.
  hull::surface::LimitSurface surface = family.parents()[0];
  hull::analysis::HullBody body(surface, true, hull::analysis::Openings::kClosed,
                                hull::analysis::kLive);
  const std::vector<hull::analysis::Plane> lines = planes();
  int count = 0;
  bool is_folded = false;
  for (auto _ : state) {
    const double t = 0.01 * (++count % 101);
    const std::vector<hull::Vector3d> points = family.points(std::vector<double>{1.0 - t, t});
    // Kept, so that the check is not left out by the compiler, and told at the end.
    is_folded = is_folded || family.first_fold(points).has_value();
    surface.set_points(points);
    body.update();
    benchmark::DoNotOptimize(
        hull::analysis::hydrostatics(body, {kDraft}, {100.0 + 10.0 * t, 18.0, kDraft}));
    benchmark::DoNotOptimize(hull::analysis::sections(surface, lines, {1e-3, {}}));
  }
  if (is_folded) state.SkipWithError("a member between the parents is folded");
  state.counters["points"] = family.point_count();
}

BENCHMARK(BM_Member)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
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
      {{"a weight of 140 points moved, with lines and numbers", "BM_Member/process_time", 16.0},
       {"two parents of some 550 points", "BM_Merge/paper/process_time", 100.0},
       {"one of 62,000 triangles laid into a polygon", "BM_Map/large/process_time", 0.0},
       {"two of 62,000 triangles", "BM_Merge/large/process_time", 10000.0}});
}
