// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/source_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "resistance/friction_line.h"
#include "resistance/wave_sums.h"

namespace hull::resistance {
namespace {

struct Source {
  double x, depth, strength;
};

// Of both signs, most of them near the water, as from seed 25.
std::vector<Source> some_sources(double aft, double forward, double deepest) {
  std::mt19937 random(25);
  std::uniform_real_distribution<double> along(aft, forward), share(0.0, 1.0);
  std::vector<Source> sources;
  for (int i = 0; i < 200; ++i) {
    sources.push_back({along(random), deepest * std::pow(share(random), 6), share(random) - 0.5});
  }
  return sources;
}

TEST(SourceGridTest, SumsWavesAsTheSourcesThemselvesDo) {
  const WaveScales scales{4.0, 64.0, 1024.0};
  const std::vector<Source> sources = some_sources(-5.0, 7.0, 1.5);
  SourceGrid grid(-5.0, 7.0, 1.5, scales);
  double size = 0.0;
  for (const Source& source : sources) {
    grid.add(source.x, source.depth, source.strength);
    size += std::abs(source.strength);
  }
  grid.take_all();
  const WaveSums sums(grid);
  const std::vector<double> along{4.0, 4.7, 9.0, 20.0, 41.0, 63.9};
  const auto amplitudes = sums.amplitudes(4.0, along);
  for (std::size_t i = 0; i < along.size(); ++i) {
    std::complex<double> direct = 0.0;
    for (const Source& source : sources) {
      direct += std::polar(source.strength * std::exp(-along[i] * along[i] / 4.0 * source.depth),
                           along[i] * source.x);
    }
    EXPECT_LT(std::abs(amplitudes[i] - direct), 1e-9 * size) << along[i];
  }
}

TEST(SourceGridTest, IntegralOfOneSourceIsThatOfItsDepth) {
  // |I| = exp(-ν λ² d): ∫₁^∞ exp(-2 ν d λ²) λ² / √(λ² - 1) dλ = e^-a (K₀(a) + K₁(a)) / 4, a = ν d.
  const double nu = 1.0, depth = 0.7;
  SourceGrid grid(-5.0, 5.0, 1.0, {nu, 64.0, 64.0 * 64.0});
  grid.add(1.3, depth, 1.0);
  grid.take_all();
  const WaveIntegral integral = WaveSums(grid).integral(nu, 1e-9, 64.0);
  const double a = nu * depth;
  const double closed =
      0.25 * std::exp(-a) * (std::cyl_bessel_k(0.0, a) + std::cyl_bessel_k(1.0, a));
  EXPECT_TRUE(integral.settled);
  EXPECT_NEAR(integral.value, closed, 1e-8 * closed);
}

// Its length is rounded once: a rounded one, rounded anew, may be the next.
TEST(SourceGridTest, IntegralsReachSixIntervalsWhateverTheLength) {
  for (double length = 1.0; length < 4.0; length += 0.05) {
    SourceGrid grid(0.0, length, 1.0, {0.1, 200.0, 4e5});
    grid.add(0.3, 1e-9, 1.0);  // near enough to the water for all waves
    grid.take_all();
    EXPECT_EQ(WaveSums(grid).integral(0.1, 0.0, 1.5).parts.size(), 5u) << length;
  }
}

TEST(SourceGridTest, DerivativesOfTheIntegralAreItsDifferences) {
  const WaveScales scales{2.0, 32.0, 512.0};
  const std::vector<Source> sources = some_sources(0.0, 10.0, 1.0);
  SourceGrid grid(0.0, 10.0, 1.0, scales);
  for (const Source& source : sources) grid.add(source.x, source.depth, source.strength);
  grid.take_all();
  const WaveIntegral integral = WaveSums(grid).integral(2.0, 0.0, 16.0);
  SourceGrid derivatives = grid;
  take_derivatives(integral, derivatives);
  const double x = 3.21, depth = 0.04, step = 1e-4;
  const auto value_with = [&](double at, double strength) {
    SourceGrid changed = grid;
    changed.add(at, depth, strength);
    changed.take_all();
    return WaveSums(changed).integral(2.0, 0.0, 16.0).value;
  };
  const SourceGrid::Jet jet = derivatives.at(x, depth);
  const double difference = (value_with(x, step) - value_with(x, -step)) / (2.0 * step);
  EXPECT_NEAR(jet.value, difference, 1e-7 * std::abs(difference));
  const double slope =
      (derivatives.at(x + step, depth).value - derivatives.at(x - step, depth).value) /
      (2.0 * step);
  EXPECT_NEAR(jet.by_x, slope, 1e-5 * std::abs(slope));
  const double fall =
      (derivatives.at(x, depth + step).value - derivatives.at(x, depth - step).value) /
      (2.0 * step);
  EXPECT_NEAR(jet.by_depth, fall, 1e-4 * std::abs(fall));
}

TEST(FrictionLineTest, IsTheFormula) {
  EXPECT_DOUBLE_EQ(ittc_1957(1e9), 0.075 / 49.0);
  EXPECT_THROW(ittc_1957(100.0), std::invalid_argument);
}

}  // namespace
}  // namespace hull::resistance
