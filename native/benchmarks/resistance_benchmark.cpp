// SPDX-License-Identifier: GPL-3.0-or-later
// Michell's integral for a half hull of 140 and of 1120 points at forty Froude numbers from 0.15 to
// 0.6, from the hull in the water on, and its derivatives by all control points at one of them. One
// thread.
#include <benchmark/benchmark.h>

#include <cmath>

#include "benchmarks/half_hull_surface.h"
#include "benchmarks/ratio_report.h"
#include "resistance/michell_integral.h"

namespace {

using hull::analysis::HullBody;
using hull::benchmarks::half_hull_surface;
using hull::resistance::MichellIntegral;
using hull::surface::LimitSurface;

// Upright, with a draft of 6 m amidships.
constexpr hull::analysis::FloatingPosition kAfloat{6.0, 0.0, 0.0, 50.0};
constexpr int kSpeeds = 40;

double speed_at(double froude, double length) {
  return froude * std::sqrt(hull::resistance::kGravity * length);
}

void BM_FortySpeeds(benchmark::State& state) {
  const LimitSurface surface = half_hull_surface(state);
  const HullBody body(surface, true);
  for (auto _ : state) {
    const MichellIntegral integral(body, kAfloat);
    std::vector<double> speeds;
    for (int i = 0; i < kSpeeds; ++i) {
      // The length is that in the water, which only the integral knows.
      speeds.push_back(speed_at(0.15 + 0.45 * i / (kSpeeds - 1), integral.length()));
    }
    benchmark::DoNotOptimize(integral.resistance(speeds));
  }
}
BENCHMARK(BM_FortySpeeds)->Args({1, 12})->Args({3, 108})->Unit(benchmark::kMillisecond);

void BM_Gradient(benchmark::State& state) {
  const LimitSurface surface = half_hull_surface(state);
  const HullBody body(surface, true);
  // Of the topology, so prepared once for all speeds and points.
  const hull::analysis::BodyDerivatives derivatives(body);
  const MichellIntegral integral(body, kAfloat);
  const double speed = speed_at(0.3, integral.length());
  for (auto _ : state) benchmark::DoNotOptimize(integral.gradient(derivatives, speed));
}
BENCHMARK(BM_Gradient)->Args({1, 12})->Args({3, 108})->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv, {},
      {{"40 speeds, 140 points", "BM_FortySpeeds/1/12", 2000.0},
       {"40 speeds, 1,120 points", "BM_FortySpeeds/3/108", 2000.0},
       {"derivatives, 140 points", "BM_Gradient/1/12"},
       {"derivatives, 1,120 points", "BM_Gradient/3/108"}});
}
