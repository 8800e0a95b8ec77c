// SPDX-License-Identifier: GPL-3.0-or-later
// Closest points and rays on the exact surface, one thread, a half hull of 140 points: time is per
// query. For comparison, the nearest of samples by trying each, which is not exact.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "benchmarks/half_hull.h"
#include "surface/queries/closest_point.h"
#include "surface/queries/ray_hits.h"
#include "surface/sampling/grid_samples.h"

namespace {

using hull::Vector3d;

constexpr int kQueries = 20000;

const hull::surface::LimitSurface& surface() {
  static const hull::surface::LimitSurface built{
      hull::mesh::ControlMesh(hull::benchmarks::half_hull())};
  return built;
}

const hull::surface::SurfaceTree& tree() {
  static const hull::surface::SurfaceTree built(surface());
  return built;
}

Vector3d offset(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  return {unit(random), unit(random), unit(random)};
}

// Anywhere near the surface, within `away` in each direction, m.
std::vector<Vector3d> scattered(double away) {
  // The same points in every run.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vector3d> points;
  for (int i = 0; i < kQueries; ++i) {
    const int cell = static_cast<int>(unit(random) * surface().cell_count());
    points.push_back(surface().position(cell, unit(random), unit(random)) + away * offset(random));
  }
  return points;
}

// Row after row of each cell, with the noise of an instrument.
std::vector<Vector3d> scanned(double noise) {
  std::mt19937 random(1);
  const hull::surface::GridSamples samples = hull::surface::evaluate_grid(surface(), 6, 0);
  std::vector<Vector3d> points;
  for (const Vector3d& p : samples.points) points.push_back(p + noise * offset(random));
  return points;
}

void per_query(benchmark::State& state, std::size_t queries) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * queries));
  state.counters["per_query"] = benchmark::Counter(
      static_cast<double>(queries),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void BM_BuildTree(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(hull::surface::SurfaceTree(surface()));
}

void BM_RefitTree(benchmark::State& state) {
  hull::surface::SurfaceTree moved(surface());
  for (auto _ : state) moved.refit(surface());
}

// Within so many mm.
void BM_ClosestPointsScattered(benchmark::State& state) {
  const std::vector<Vector3d> points = scattered(1e-3 * static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(hull::surface::closest_points(tree(), points));
  per_query(state, points.size());
}

void BM_ClosestPointsScanned(benchmark::State& state) {
  const std::vector<Vector3d> points = scanned(1e-3 * static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(hull::surface::closest_points(tree(), points));
  per_query(state, points.size());
}

// From 50 m off.
void BM_FirstRayHits(benchmark::State& state) {
  std::mt19937 random(2);
  std::vector<hull::surface::Ray> rays;
  for (const Vector3d& p : scattered(0.0)) {
    const Vector3d direction = offset(random).normalized();
    // Aimed at points of the surface: each ray hits, there or before.
    rays.push_back({p - 50.0 * direction, direction});
  }
  for (auto _ : state) {
    for (const hull::surface::Ray& ray : rays) {
      benchmark::DoNotOptimize(hull::surface::first_ray_hit(tree(), ray));
    }
  }
  per_query(state, rays.size());
}

void BM_NearestOfSamplesByTryingAll(benchmark::State& state) {
  const hull::surface::GridSamples samples = hull::surface::evaluate_grid(surface(), 16, 0);
  // Fewer queries: each tries all samples.
  std::vector<Vector3d> points = scattered(1.0);
  points.resize(200);
  double worst = 0.0;
  for (auto _ : state) {
    for (const Vector3d& p : points) {
      double least = std::numeric_limits<double>::infinity();
      for (const Vector3d& q : samples.points) least = std::min(least, (q - p).squaredNorm());
      // The exact query is timed with them, and takes next to nothing beside trying all.
      worst = std::max(worst, std::sqrt(least) - hull::surface::closest_point(tree(), p).distance);
    }
  }
  per_query(state, points.size());
  state.counters["error_mm"] = 1e3 * worst;
}

BENCHMARK(BM_BuildTree)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_RefitTree)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ClosestPointsScattered)->Arg(0)->Arg(10)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ClosestPointsScanned)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FirstRayHits)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_NearestOfSamplesByTryingAll)->Unit(benchmark::kMillisecond);

}  // namespace
