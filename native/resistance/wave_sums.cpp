// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/wave_sums.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/arithmetic/gauss.h"

namespace hull::resistance {
namespace {

// Nodes of an interval of k, over which phases between the ship's end and middle turn by half of
// kTurn: interpolation between them is off by at most 2 (kTurn / 8)^n / n!, Gauss's rule by less.
constexpr int kNodes = 20;
constexpr double kTurn = 24.0;
constexpr int kLeastIntervals = 3;  // that an integral is made of, beyond its beginning
constexpr int kReachedIntervals = kLeastIntervals + 3;  // of k from 0 on, whatever λ is
constexpr int kBatch = 64;  // waves whose derivatives are summed at once

// Gauss's rule on [0, 1] with Lagrange's polynomials of its nodes.
struct IntervalRule {
  analysis::GaussRule rule = analysis::gauss_rule(kNodes);
  std::array<double, kNodes> barycentric;

  IntervalRule() {
    for (int i = 0; i < kNodes; ++i) {
      double product = 1.0;
      for (int j = 0; j < kNodes; ++j) {
        // An interval of length 1 has the capacity 1/4: with its reciprocal products stay near 1.
        // All weights have the same factor, which cancels out in polynomials().
        if (j != i) product *= 4.0 * (rule.nodes[i] - rule.nodes[j]);
      }
      barycentric[i] = 1.0 / product;
    }
  }

  Eigen::RowVectorXd polynomials(double t) const {
    Eigen::RowVectorXd values(kNodes);
    for (int i = 0; i < kNodes; ++i) {
      if (t == rule.nodes[i]) return Eigen::RowVectorXd::Unit(kNodes, i);
      values[i] = barycentric[i] / (t - rule.nodes[i]);
    }
    return values / values.sum();
  }

  static const IntervalRule& get() {
    static const IntervalRule rule;
    return rule;
  }
};

std::vector<double> interval_nodes(double begin, double width) {
  std::vector<double> nodes = IntervalRule::get().rule.nodes;
  for (double& node : nodes) node = begin + width * node;
  return nodes;
}

// Up to the next of four steps an octave: intervals of k, and so where an integral ends, stay as
// they are while points move a little.
double rounded_up(double length) { return std::exp2(std::ceil(4.0 * std::log2(length)) / 4.0); }

// The interval before which an integral's beginning ends. Half an interval from the singularity
// Gauss's rule is as good as elsewhere.
int first_interval(double nu, double width) {
  return static_cast<int>(std::ceil(nu / width + 0.5));
}

}  // namespace

WaveSums::WaveSums(const SourceGrid& grid)
    : grid_(grid), length_(rounded_up(grid.length())), width_(kTurn / length_) {}

double WaveSums::least_reach(double length) {
  return kReachedIntervals * kTurn / rounded_up(length);
}

double WaveSums::first_reach(double nu, double length) {
  const double width = kTurn / rounded_up(length);
  return first_interval(nu, width) * width;
}

WaveSums::Table WaveSums::table_of(std::span<const double> along) const {
  Table table(grid_.layer_count());
  const double least = *std::min_element(along.begin(), along.end());
  for (int layer = 0; layer < grid_.layer_count(); ++layer) {
    if (least <= grid_.scales().along_at(grid_.top(layer))) table[layer] = grid_.sums(layer, along);
  }
  return table;
}

// Of the wave that `row` makes of a layer's sums, of its table.
template <class Row>
WaveSums::Complex WaveSums::amplitude(const Table& table, double decay, const Row& row) const {
  Complex sum = 0.0;
  for (int layer = 0; layer < grid_.layer_count(); ++layer) {
    // Layers come from the water down: below one that the wave does not reach it reaches none.
    if (table[layer].size() == 0 || decay * grid_.top(layer) > WaveScales::kReach) break;
    // The sums are of waves along x, by nodes' depths: what is left is how each depth is reached.
    const Eigen::Array<double, 1, SourceGrid::kDown> fall = (-decay * grid_.depths(layer)).exp();
    sum += (row(table[layer]).array() * fall).sum();
  }
  return sum;
}

std::vector<std::complex<double>> WaveSums::amplitudes(double nu,
                                                       std::span<const double> along) const {
  const Table table = table_of(along);
  const auto count = static_cast<Eigen::Index>(along.size());
  std::vector<std::complex<double>> result;
  for (Eigen::Index i = 0; i < count; ++i) {
    result.push_back(amplitude(table, along[i] * along[i] / nu,
                               [&](const Eigen::MatrixXcd& sums) { return sums.row(i); }));
  }
  return result;
}

const WaveSums::Table& WaveSums::interval_table(int interval) {
  auto table = tables_.find(interval);
  if (table == tables_.end()) {
    const std::vector<double> nodes = interval_nodes(interval * width_, width_);
    table = tables_.emplace(interval, table_of(nodes)).first;
  }
  return table->second;
}

// From k = ν on, by k = ν cosh t: λ² / √(λ² - 1) dλ = cosh² t dt has no singularity.
void WaveSums::add_first(double nu, double end, WaveIntegral& integral) {
  const IntervalRule& rule = IntervalRule::get();
  const double middle = grid_.aft() + 0.5 * grid_.length();
  const double last = std::acosh(end / nu);
  // Even in t: k changes by less than `end` times t, and phases over a part by less than kTurn.
  const int parts = 1 + static_cast<int>(std::ceil(last * end * length_ / kTurn));
  for (int part = 0; part < parts; ++part) {
    for (int i = 0; i < kNodes; ++i) {
      const double t = last * (part + rule.rule.nodes[i]) / parts;
      const double along = nu * std::cosh(t), decay = along * std::cosh(t);
      const int interval = static_cast<int>(along / width_);
      // About the middle phases turn least between the interval's nodes.
      Eigen::RowVectorXcd rows = rule.polynomials(along / width_ - interval).cast<Complex>();
      for (int k = 0; k < kNodes; ++k) {
        const double node = (interval + rule.rule.nodes[k]) * width_;
        rows[k] *= std::polar(1.0, (along - node) * middle);
      }
      // The singularity went into dt: cosh² t = λ² is all that is left.
      const double weight = rule.rule.weights[i] * last / parts * std::pow(std::cosh(t), 2);
      const Complex own = amplitude(
          interval_table(interval), decay,
          [&](const Eigen::MatrixXcd& sums) -> Eigen::RowVectorXcd { return rows * sums; });
      integral.waves.push_back({along, decay, weight, own});
      integral.value += weight * std::norm(own);
    }
  }
}

double WaveSums::add_interval(double nu, int interval, WaveIntegral& integral) {
  const analysis::GaussRule& rule = IntervalRule::get().rule;
  const std::vector<double> nodes = interval_nodes(interval * width_, width_);
  const Table& table = interval_table(interval);
  double sum = 0.0;
  for (int i = 0; i < kNodes; ++i) {
    // With k = ν λ, dλ = dk / ν.
    const double lambda = nodes[i] / nu, decay = nodes[i] * lambda;
    const double weight =
        rule.weights[i] * width_ / nu * lambda * lambda / std::sqrt(lambda * lambda - 1.0);
    const Complex own =
        amplitude(table, decay, [&](const Eigen::MatrixXcd& sums) { return sums.row(i); });
    integral.waves.push_back({nodes[i], decay, weight, own});
    sum += weight * std::norm(own);
  }
  integral.value += sum;
  return sum;
}

WaveIntegral WaveSums::integral(double nu, double tolerance, double shortest, WaveIntegral begun) {
  WaveIntegral integral = std::move(begun);
  if (integral.first < 0) {
    integral.first = first_interval(nu, width_);
    add_first(nu, integral.first * width_, integral);
    integral.shortest = integral.first * width_ / nu;
  }
  const int first = integral.first;
  const double reach = std::max(nu * shortest, kReachedIntervals * width_);
  for (int interval = first + static_cast<int>(integral.parts.size());
       (interval + 1) * width_ <= reach; ++interval) {
    integral.parts.push_back(add_interval(nu, interval, integral));
    const int end = interval + 1, half = end / 2;
    integral.shortest = end * width_ / nu;
    // The last octave of k, from its half on, has to be of whole intervals.
    if (half < first || end < first + kLeastIntervals) continue;
    double octave = 0.0;
    for (int k = half; k < end; ++k) octave += integral.parts[k - first];
    // An integrand that falls off as λ⁻³ has a third of its last octave left.
    integral.error = integral.errors[end] = octave / 3.0;
    const auto before = integral.errors.find(half);
    if (before != integral.errors.end() && octave > 0.0) {
      // What the last doubling of λ made of the error.
      integral.fall = std::log2(before->second / integral.error);
    }
    integral.settled = integral.error <= tolerance * integral.value;
    if (integral.settled) break;
  }
  return integral;
}

void take_derivatives(const WaveIntegral& integral, SourceGrid& grid) {
  grid.set_zero();
  const std::vector<SummedWave>& waves = integral.waves;
  // Many waves make one product of matrices in add_back().
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
            // d|I|² = 2 Re(conj(I) dI).
            2.0 * wave.weight * std::conj(wave.amplitude) *
            (-wave.decay * grid.depths(layer)).exp().matrix().cast<std::complex<double>>();
      }
      grid.add_back(layer, along, factors);
    }
  }
  grid.differentiate();
}

}  // namespace hull::resistance
