// SPDX-License-Identifier: GPL-3.0-or-later
// Fairing 100 points of a hull of 1,000: what is prepared once, and each change of the deviation.
#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>
#include <vector>

#include "benchmarks/ratio_report.h"
#include "modelling/fairing/fair_region.h"

namespace {

using hull::modelling::FairEnergy;
using hull::modelling::FairRegion;

constexpr int kColumns = 40, kRows = 25, kAlong = 10, kUp = 10;

// One side of a hull, half a wave along and up, with ripples of the points.
hull::surface::LimitSurface side() {
  hull::mesh::MeshArrays mesh;
  for (int i = 0; i < kColumns; ++i) {
    for (int j = 0; j < kRows; ++j) {
      const double x = static_cast<double>(i) / (kColumns - 1), z = static_cast<double>(j) / kRows;
      // The breadth vanishes at both ends; the last term ripples the points by up to 4 cm.
      mesh.points.emplace_back(100.0 * x,
                               8.0 * std::sqrt(z + 0.05) * (1.0 - std::pow(2.0 * x - 1.0, 4)) +
                                   0.01 * ((i * 7 + j * 3) % 5),
                               10.0 * z);
    }
  }
  for (int i = 0; i + 1 < kColumns; ++i) {
    for (int j = 0; j + 1 < kRows; ++j) {
      const int a = i * kRows + j;
      mesh.face_sizes.push_back(4);
      // The normals point to port, into the water.
      mesh.face_vertices.insert(mesh.face_vertices.end(), {a, a + 1, a + kRows + 1, a + kRows});
    }
  }
  return hull::surface::LimitSurface(hull::mesh::ControlMesh(mesh));
}

hull::modelling::FairOptions options(FairEnergy energy, bool along_normals) {
  hull::modelling::FairOptions options;
  for (int i = 0; i < kAlong; ++i) {
    // In the middle of the side, away from its borders.
    for (int j = 0; j < kUp; ++j) options.points.push_back((15 + i) * kRows + 7 + j);
  }
  options.energy = energy;
  options.along_normals = along_normals;
  return options;
}

void prepare(benchmark::State& state) {
  const hull::surface::LimitSurface surface = side();
  for (auto _ : state) {
    benchmark::DoNotOptimize(FairRegion(surface, options(FairEnergy::kThinPlate, true)));
  }
}
BENCHMARK(prepare)->Unit(benchmark::kMillisecond);

// Arguments: the energy, and whether points move along normals alone.
void change(benchmark::State& state) {
  const hull::surface::LimitSurface surface = side();
  const FairRegion region(surface,
                          options(static_cast<FairEnergy>(state.range(0)), state.range(1) != 0));
  double deviation = 0.001;
  for (auto _ : state) {
    benchmark::DoNotOptimize(region.solve(deviation, std::numeric_limits<double>::infinity()));
    // Another one each time, as when a slider is drawn.
    deviation = deviation < 0.01 ? 1.1 * deviation : 0.001;
  }
}
BENCHMARK(change)
    ->Args({static_cast<int>(FairEnergy::kThinPlate), 1})
    ->Args({static_cast<int>(FairEnergy::kThinPlate), 0})
    ->Args({static_cast<int>(FairEnergy::kLengthwise), 1})
    ->Args({static_cast<int>(FairEnergy::kVariation), 1})
    ->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  // The names of the limits below have this number in them.
  static_assert(static_cast<int>(FairEnergy::kThinPlate) == 0);
  return hull::benchmarks::run_and_compare(argc, argv, {},
                                           {{"100 of 1,000 points prepared", "prepare"},
                                            {"another deviation, thin plate", "change/0/1", 50.0},
                                            {"... in any direction", "change/0/0", 50.0}});
}
