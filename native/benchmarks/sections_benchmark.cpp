// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a half hull of 140 points, after a point was moved, by exact sections and by slicing
// a triangulation of equal accuracy. On one processor.
#include <benchmark/benchmark.h>
#include <sched.h>

#include <algorithm>
#include <cstdio>
#include <unordered_map>

#include "analysis/sections/section_splines.h"
#include "analysis/sections/sections.h"
#include "benchmarks/half_hull.h"
#include "benchmarks/ratio_report.h"
#include "surface/sampling/tessellation.h"

namespace {

using hull::Vector3d;
using hull::analysis::Axis;
using hull::analysis::Plane;

constexpr double kTolerance = 1e-3;  // 1 mm on 100 m

// 21 stations, 11 waterlines, 7 buttocks.
const std::vector<hull::analysis::Plane>& planes() {
  static const std::vector<hull::analysis::Plane> all = [] {
    std::vector<hull::analysis::Plane> list;
    for (int i = 0; i < 21; ++i) {
      list.push_back(hull::analysis::plane_across(hull::analysis::Axis::kX, 5.0 * i));
    }
    for (int i = 0; i < 11; ++i) {
      list.push_back(hull::analysis::plane_across(hull::analysis::Axis::kZ, 0.9 * i));
    }
    for (int i = 0; i < 7; ++i) {
      list.push_back(hull::analysis::plane_across(hull::analysis::Axis::kY, 1.2 * i));
    }
    return list;
  }();
  return all;
}

const hull::surface::LimitSurface& surface() {
  static const hull::surface::LimitSurface built{
      hull::mesh::ControlMesh(hull::benchmarks::half_hull())};
  return built;
}

void BM_Sections(benchmark::State& state) {
  for (auto _ : state) {
    // All planes in one call share what is made of the surface.
    benchmark::DoNotOptimize(hull::analysis::sections(surface(), planes(), {kTolerance, {}}));
  }
}

void BM_SectionsOneByOne(benchmark::State& state) {
  for (auto _ : state) {
    for (const hull::analysis::Plane& plane : planes()) {
      benchmark::DoNotOptimize(hull::analysis::section(surface(), plane, kTolerance));
    }
  }
}

void BM_SectionSplines(benchmark::State& state) {
  for (auto _ : state) {
    for (const hull::analysis::Plane& plane : planes()) {
      benchmark::DoNotOptimize(hull::analysis::section_splines(surface(), plane, kTolerance));
    }
  }
}

// Polylines of a triangulation's section, joined along its edges.
class Slicer {
 public:
  explicit Slicer(const hull::surface::Tessellation& grid)
      : grid_(grid), heights_(grid.points.size()) {}

  std::vector<std::vector<Vector3d>> slice(const hull::analysis::Plane& plane) {
    nodes_.clear();
    points_.clear();
    links_.clear();
    // Once for each point, and not for each triangle that has it.
    for (std::size_t i = 0; i < heights_.size(); ++i) heights_[i] = plane.height(grid_.points[i]);
    for (const auto& q : grid_.quads) {
      const bool below[] = {heights_[q[0]] < 0.0, heights_[q[1]] < 0.0, heights_[q[2]] < 0.0,
                            heights_[q[3]] < 0.0};
      // Most quadrilaterals are told off by this.
      if (below[0] == below[1] && below[1] == below[2] && below[2] == below[3]) continue;
      add(q[0], q[1], q[2]);
      add(q[0], q[2], q[3]);
    }
    return join();
  }

 private:
  int node(int a, int b) {
    // Both triangles of an edge find the same node.
    if (a > b) std::swap(a, b);
    const auto key = static_cast<long long>(a) << 32 | b;
    const auto [place, fresh] = nodes_.try_emplace(key, static_cast<int>(points_.size()));
    if (fresh) {
      // One is below and the other not, so that the difference is never nothing.
      const double t = heights_[a] / (heights_[a] - heights_[b]);
      points_.push_back(grid_.points[a] + t * (grid_.points[b] - grid_.points[a]));
      links_.push_back({-1, -1});
    }
    return place->second;
  }
  void add(int a, int b, int c) {
    const bool below[] = {heights_[a] < 0.0, heights_[b] < 0.0, heights_[c] < 0.0};
    if (below[0] == below[1] && below[1] == below[2]) return;
    int ends[2], count = 0;
    if (below[0] != below[1]) ends[count++] = node(a, b);
    if (below[1] != below[2]) ends[count++] = node(b, c);
    if (below[2] != below[0]) ends[count++] = node(c, a);
    for (int k = 0; k < 2; ++k) {
      auto& link = links_[ends[k]];
      // The first free one of two: a node has two neighbours at most, one of each triangle at its
      // edge.
      link[link[0] >= 0] = ends[1 - k];
    }
  }
  std::vector<std::vector<Vector3d>> join() {
    std::vector<std::vector<Vector3d>> curves;
    std::vector<char> used(points_.size(), 0);
    // Open curves from their ends first; what is then left are rings.
    for (const bool closed : {false, true}) {
      for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
        if (used[i] || (!closed && links_[i][1] >= 0)) continue;
        auto& curve = curves.emplace_back();
        int at = i, from = -1;
        while (at >= 0 && !used[at]) {
          used[at] = 1;
          curve.push_back(points_[at]);
          const int next = links_[at][0] != from ? links_[at][0] : links_[at][1];
          from = at;
          at = next;
        }
        if (closed) curve.push_back(points_[i]);
      }
    }
    return curves;
  }

  const hull::surface::Tessellation& grid_;
  std::vector<double> heights_;
  std::unordered_map<long long, int> nodes_;
  std::vector<Vector3d> points_;
  std::vector<std::array<int, 2>> links_;
};

// The distance of the surface, over the middles of quadrilaterals, from their diagonals, that 99 of
// 100 keep to. The largest, beside irregular points, falls with n only as 1/n.
double facet_error(int n) {
  const hull::surface::Tessellation grid = hull::surface::tessellate(surface(), n);
  const hull::surface::Tessellation finer = hull::surface::tessellate(surface(), 2 * n);
  std::vector<double> errors;
  for (int q = 0; q < static_cast<int>(grid.quads.size()); ++q) {
    const int cell = q / (n * n), i = q % n, j = q / n % n;
    // With n doubled, the quadrilateral's middle is a point of the finer grid: the third corner of
    // the first of its four quarters.
    const Vector3d& middle = finer.points[finer.quads[(4 * cell * n + 4 * j) * n + 2 * i][2]];
    const auto& c = grid.quads[q];
    errors.push_back((middle - 0.5 * (grid.points[c[0]] + grid.points[c[2]])).norm());
  }
  const auto kept = errors.end() - static_cast<std::ptrdiff_t>(errors.size() / 100) - 1;
  std::nth_element(errors.begin(), kept, errors.end());
  return *kept;
}

// The fewest divisions of a cell whose facets are accurate to the tolerance.
int divisions() {
  static const int found = [] {
    int n = 1;
    // The error falls with the square of n, so that this ends soon.
    while (facet_error(n) > kTolerance) ++n;
    std::printf("%d x %d quadrilaterals a cell: 99 of 100 within %.2f mm\n", n, n,
                1e3 * facet_error(n));
    return n;
  }();
  return found;
}

// With the triangulation, which has to be made anew as the sections' bounds have.
void BM_SlicedTriangulation(benchmark::State& state) {
  const int n = divisions();
  for (auto _ : state) {
    const hull::surface::Tessellation grid = hull::surface::tessellate(surface(), n);
    Slicer slicer(grid);
    for (const hull::analysis::Plane& plane : planes()) {
      benchmark::DoNotOptimize(slicer.slice(plane));
    }
  }
}

BENCHMARK(BM_Sections)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SectionsOneByOne)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SectionSplines)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SlicedTriangulation)->Unit(benchmark::kMillisecond);

// Where there are more, sections are divided among them, and slices are not.
void stay_on_one_processor() {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  sched_setaffinity(0, sizeof one, &one);
}

}  // namespace

int main(int argc, char** argv) {
  stay_on_one_processor();
  return hull::benchmarks::run_and_compare(
      argc, argv,
      {{"39 lines, against a sliced triangulation", "BM_Sections", "BM_SlicedTriangulation"},
       {"39 lines at once, against one by one", "BM_Sections", "BM_SectionsOneByOne"}},
      {{"39 lines to 1 mm per 100 m", "BM_Sections", 5.0}});
}
