// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/wave_sums.h"

#include <algorithm>
#include <cmath>

#include "analysis/arithmetic/gauss.h"

namespace hull::resistance {
namespace {

constexpr int kNodes = 12;          // of an interval of k …
constexpr double kTurn = 12.0;      // … over which phases between bow and stern turn so far
constexpr int kLeastIntervals = 3;  // that an integral is made of, beyond its beginning
constexpr int kBatch = 64;          // waves whose derivatives are summed at once

const analysis::GaussRule& interval_rule() {
  static const analysis::GaussRule rule = analysis::gauss_rule(kNodes);
  return rule;
}

std::vector<double> interval_nodes(double begin, double width) {
  std::vector<double> nodes = interval_rule().nodes;
  for (double& node : nodes) node = begin + width * node;
  return nodes;
}

}  // namespace

WaveSums::WaveSums(const SourceGrid& grid, double length)
    : grid_(grid), length_(length), width_(kTurn / length) {}

double WaveSums::least_reach(double length) { return (kLeastIntervals + 3) * kTurn / length; }

WaveSums::Table WaveSums::table_of(std::span<const double> along) const {
  Table table(grid_.layer_count());
  const double least = *std::min_element(along.begin(), along.end());
  for (int layer = 0; layer < grid_.layer_count(); ++layer) {
    if (least <= grid_.scales().along_at(grid_.top(layer))) table[layer] = grid_.sums(layer, along);
  }
  return table;
}

std::complex<double> WaveSums::amplitude(const Table& table, std::size_t wave, double decay) const {
  std::complex<double> sum = 0.0;
  for (int layer = 0; layer < grid_.layer_count(); ++layer) {
    if (table[layer].size() == 0 || decay * grid_.top(layer) > WaveScales::kReach) break;
    const Eigen::Array<double, 1, SourceGrid::kDown> fall = (-decay * grid_.depths(layer)).exp();
    sum += (table[layer].row(static_cast<Eigen::Index>(wave)).array() * fall).sum();
  }
  return sum;
}

std::vector<std::complex<double>> WaveSums::amplitudes(double nu,
                                                       std::span<const double> along) const {
  const Table table = table_of(along);
  std::vector<std::complex<double>> result;
  for (std::size_t i = 0; i < along.size(); ++i) {
    result.push_back(amplitude(table, i, along[i] * along[i] / nu));
  }
  return result;
}

// From k = ν on, by k = ν cosh t: λ² / √(λ² - 1) dλ = cosh² t dt has no singularity.
void WaveSums::add_first(double nu, double end, WaveIntegral& integral) const {
  const double last = std::acosh(end / nu);
  const int parts = 1 + static_cast<int>(std::ceil(last * end * length_ / kTurn));
  std::vector<double> along, weights;
  for (int part = 0; part < parts; ++part) {
    for (int i = 0; i < kNodes; ++i) {
      const double t = last * (part + interval_rule().nodes[i]) / parts;
      along.push_back(nu * std::cosh(t));
      weights.push_back(interval_rule().weights[i] * last / parts * std::pow(std::cosh(t), 2));
    }
  }
  const std::vector<std::complex<double>> amplitude = amplitudes(nu, along);
  for (std::size_t i = 0; i < along.size(); ++i) {
    integral.waves.push_back({along[i], along[i] * along[i] / nu, weights[i], amplitude[i]});
    integral.value += weights[i] * std::norm(amplitude[i]);
  }
}

double WaveSums::add_interval(double nu, int interval, WaveIntegral& integral) {
  const std::vector<double> along = interval_nodes(interval * width_, width_);
  auto table = tables_.find(interval);
  if (table == tables_.end()) table = tables_.emplace(interval, table_of(along)).first;
  double sum = 0.0;
  for (int i = 0; i < kNodes; ++i) {
    const double lambda = along[i] / nu, decay = along[i] * lambda;
    const double weight = interval_rule().weights[i] * width_ / nu * lambda * lambda /
                          std::sqrt(lambda * lambda - 1.0);
    const std::complex<double> own = amplitude(table->second, i, decay);
    integral.waves.push_back({along[i], decay, weight, own});
    sum += weight * std::norm(own);
  }
  integral.value += sum;
  return sum;
}

WaveIntegral WaveSums::integral(double nu, double tolerance, double shortest) {
  WaveIntegral integral;
  // Half an interval from the singularity Gauss's rule is as good as elsewhere.
  const int first = static_cast<int>(std::ceil(nu / width_ + 0.5));
  add_first(nu, first * width_, integral);
  const double reach = std::max(nu * shortest, least_reach(length_));
  std::vector<double> parts;
  for (int interval = first; (interval + 1) * width_ <= reach; ++interval) {
    parts.push_back(add_interval(nu, interval, integral));
    const int end = interval + 1, half = end / 2;
    if (half < first || end < first + kLeastIntervals) continue;
    double octave = 0.0;
    for (int k = half; k < end; ++k) octave += parts[k - first];
    // An integrand that falls off as λ⁻³ has a third of its last octave left.
    integral.error = octave / 3.0;
    integral.shortest = end * width_ / nu;
    integral.settled = integral.error <= tolerance * integral.value;
    if (integral.settled) break;
  }
  return integral;
}

void take_derivatives(const WaveIntegral& integral, SourceGrid& grid) {
  grid.set_zero();
  const std::vector<SummedWave>& waves = integral.waves;
  for (std::size_t begin = 0; begin < waves.size(); begin += kBatch) {
    const std::size_t count = std::min<std::size_t>(kBatch, waves.size() - begin);
    std::vector<double> along(count);
    for (std::size_t i = 0; i < count; ++i) along[i] = waves[begin + i].along;
    const double least = *std::min_element(along.begin(), along.end());
    for (int layer = 0; layer < grid.layer_count(); ++layer) {
      if (least > grid.scales().along_at(grid.top(layer))) break;
      Eigen::MatrixXcd factors(count, SourceGrid::kDown);
      for (std::size_t i = 0; i < count; ++i) {
        const SummedWave& wave = waves[begin + i];
        factors.row(static_cast<Eigen::Index>(i)) =
            2.0 * wave.weight * std::conj(wave.amplitude) *
            (-wave.decay * grid.depths(layer)).exp().matrix().cast<std::complex<double>>();
      }
      grid.add_back(layer, along, factors);
    }
  }
  grid.differentiate();
}

}  // namespace hull::resistance
