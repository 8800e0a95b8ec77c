// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/source_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "resistance/chebyshev.h"

namespace hull::resistance {
namespace {

using Along = ChebyshevNodes<SourceGrid::kAlong>;
using Down = ChebyshevNodes<SourceGrid::kDown>;

// How far the phase turns over a rectangle, and how many e-foldings the uppermost layer has:
// interpolation at n nodes is off by at most 2 (phase / 4)^n / n! (Lagrange's remainder).
constexpr double kPhase = 24.0, kFirstDecay = 2.0;
constexpr double kInterpolated = 1e-12;

// Of Chebyshev nodes of a range of k over which no phase turns by more than this.
int nodes_for(double phase) {
  double bound = 2.0;
  for (int n = 1;; ++n) {
    bound *= 0.25 * phase / n;
    if (bound < kInterpolated) return n;
  }
}

// Lagrange's polynomials of Chebyshev nodes (columns) at values (rows), as ChebyshevNodes has them.
Eigen::MatrixXd lagrange(const Eigen::VectorXd& nodes, const Eigen::VectorXd& at) {
  const Eigen::Index count = nodes.size();
  Eigen::RowVectorXd weights(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) + 0.5) / count;
    weights[i] = (i % 2 ? -1.0 : 1.0) * std::sin(angle);
  }
  Eigen::MatrixXd values(at.size(), count);
  for (Eigen::Index row = 0; row < at.size(); ++row) {
    const Eigen::RowVectorXd distances = at[row] - nodes.transpose().array();
    Eigen::Index same;
    if (distances.cwiseAbs().minCoeff(&same) == 0.0) {
      values.row(row) = Eigen::RowVectorXd::Unit(count, same);
      continue;
    }
    values.row(row) = weights.cwiseQuotient(distances);
    values.row(row) /= values.row(row).sum();
  }
  return values;
}

Eigen::VectorXd as_vector(std::span<const double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

SourceGrid::SourceGrid(double aft, double forward, double deepest, const WaveScales& scales)
    : aft_(aft), length_(forward - aft), scales_(scales) {
  double top = 0.0;
  while (top < deepest) {
    Layer layer;
    layer.top = top;
    layer.height = top > 0.0 ? top : kFirstDecay / scales.decay;
    layer.panels =
        std::max(1, static_cast<int>(std::ceil(length_ * scales.along_at(top) / kPhase)));
    layer.width = length_ / layer.panels;
    layer.depths = layer.top + layer.height * Down::get().nodes().transpose().array();
    layer.strengths.setZero(kAlong, kDown * layer.panels);
    layers_.push_back(std::move(layer));
    top += layers_.back().height;
  }
}

void SourceGrid::set_zero() {
  for (Layer& layer : layers_) layer.strengths.setZero();
}

SourceGrid::Place SourceGrid::place(double x, double depth) const {
  Place place;
  const double first = layers_[0].height;
  // Layers double from the second on: [h, 2h], [2h, 4h], …
  place.layer = depth < first ? 0 : 1 + static_cast<int>(std::log2(depth / first));
  place.layer = std::min(place.layer, layer_count() - 1);
  const Layer& layer = layers_[place.layer];
  const double along = (x - aft_) / layer.width;
  place.panel = std::clamp(static_cast<int>(along), 0, layer.panels - 1);
  place.along = Along::get().at(along - place.panel);
  place.down = Down::get().at((depth - layer.top) / layer.height);
  return place;
}

void SourceGrid::add(double x, double depth, double strength) {
  const Place at = place(x, depth);
  layers_[at.layer].strengths.middleCols<kDown>(static_cast<Eigen::Index>(kDown) * at.panel) +=
      (strength * at.along) * at.down.transpose();
}

SourceGrid::Waves SourceGrid::within(const Layer& layer, const Eigen::VectorXd& k) {
  const Eigen::MatrixXd phases =
      k * (layer.width * (Along::get().nodes().array() - 0.5).matrix()).transpose();
  return {phases.array().cos(), phases.array().sin()};
}

SourceGrid::Waves SourceGrid::at_middles(const Layer& layer, const Eigen::VectorXd& k) const {
  const Eigen::RowVectorXd middles =
      (Eigen::RowVectorXd::LinSpaced(layer.panels, 0.0, layer.panels - 1).array() + 0.5) *
          layer.width +
      aft_;
  const Eigen::MatrixXd phases = k * middles;
  return {phases.array().cos(), phases.array().sin()};
}

void SourceGrid::sum_rectangles(const Layer& layer, const Eigen::VectorXd& k,
                                Eigen::MatrixXd& cosines, Eigen::MatrixXd& sines) {
  const double low = k.minCoeff(), range = k.maxCoeff() - low;
  const int nodes = nodes_for(0.5 * range * layer.width);
  if (nodes >= k.size()) {
    const Waves waves = within(layer, k);
    cosines.noalias() = waves.cosines * layer.strengths;
    sines.noalias() = waves.sines * layer.strengths;
    return;
  }
  Eigen::VectorXd own(nodes);
  for (int i = 0; i < nodes; ++i) {
    own[i] = low + 0.5 * range * (1.0 - std::cos(std::numbers::pi * (i + 0.5) / nodes));
  }
  const Waves waves = within(layer, own);
  const Eigen::MatrixXd polynomials = lagrange(own, k);
  thread_local Eigen::MatrixXd at_nodes;
  at_nodes.noalias() = waves.cosines * layer.strengths;
  cosines.noalias() = polynomials * at_nodes;
  at_nodes.noalias() = waves.sines * layer.strengths;
  sines.noalias() = polynomials * at_nodes;
}

Eigen::MatrixXcd SourceGrid::sums(int layer, std::span<const double> wave_numbers) const {
  const Layer& own = layers_[layer];
  const Eigen::VectorXd k = as_vector(wave_numbers);
  const Waves middles = at_middles(own, k);
  // Kept, for they are large and asked for again and again.
  thread_local Eigen::MatrixXd cosines, sines;
  sum_rectangles(own, k, cosines, sines);
  Eigen::MatrixXcd sums = Eigen::MatrixXcd::Zero(k.size(), kDown);
  for (int panel = 0; panel < own.panels; ++panel) {
    const auto c = cosines.middleCols<kDown>(static_cast<Eigen::Index>(kDown) * panel).array(),
               s = sines.middleCols<kDown>(static_cast<Eigen::Index>(kDown) * panel).array();
    const Eigen::ArrayXd at_cos = middles.cosines.col(panel), at_sin = middles.sines.col(panel);
    sums.real().array() += c.colwise() * at_cos - s.colwise() * at_sin;
    sums.imag().array() += c.colwise() * at_sin + s.colwise() * at_cos;
  }
  return sums;
}

void SourceGrid::add_back(int layer, std::span<const double> wave_numbers,
                          const Eigen::MatrixXcd& factors) {
  Layer& own = layers_[layer];
  const Eigen::VectorXd k = as_vector(wave_numbers);
  const Waves waves = within(own, k), middles = at_middles(own, k);
  Eigen::MatrixXd real(factors.rows(), own.strengths.cols()), imaginary(real.rows(), real.cols());
  const Eigen::ArrayXXd a = factors.real(), b = factors.imag();
  for (int panel = 0; panel < own.panels; ++panel) {
    const Eigen::Index first = static_cast<Eigen::Index>(kDown) * panel;
    const Eigen::ArrayXd at_cos = middles.cosines.col(panel), at_sin = middles.sines.col(panel);
    real.middleCols<kDown>(first) = a.colwise() * at_cos - b.colwise() * at_sin;
    imaginary.middleCols<kDown>(first) = a.colwise() * at_sin + b.colwise() * at_cos;
  }
  own.strengths += waves.cosines.transpose() * real - waves.sines.transpose() * imaginary;
}

void SourceGrid::differentiate() {
  for (Layer& layer : layers_) {
    layer.by_x = Along::get().slopes() * layer.strengths / layer.width;
    layer.by_depth.resize(kAlong, layer.strengths.cols());
    for (int panel = 0; panel < layer.panels; ++panel) {
      const Eigen::Index first = static_cast<Eigen::Index>(kDown) * panel;
      layer.by_depth.middleCols<kDown>(first) = layer.strengths.middleCols<kDown>(first) *
                                                Down::get().slopes().transpose() / layer.height;
    }
  }
}

SourceGrid::Jet SourceGrid::at(double x, double depth) const {
  const Place at = place(x, depth);
  const Layer& layer = layers_[at.layer];
  const Eigen::Index first = static_cast<Eigen::Index>(kDown) * at.panel;
  const auto sum = [&](const Strengths& values) {
    return at.along.dot(values.middleCols<kDown>(first) * at.down);
  };
  return {sum(layer.strengths), sum(layer.by_x), sum(layer.by_depth)};
}

}  // namespace hull::resistance
