// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/source_grid.h"

#include <algorithm>
#include <cassert>
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
constexpr double kInterpolated = 1e-11;
constexpr int kTurnedOn = 32;  // panels along which a wave is turned on before it is computed anew

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

using Rows = Eigen::Matrix<double, Eigen::Dynamic, SourceGrid::kDown>;
constexpr int kBlock = 2, kColumns = 6;  // rows and columns of a product that stay in registers

// c = a b, where a has a multiple of kBlock rows. Eigen's own product lays large matrices out anew
// for each few rows.
template <class Factor, class Columns>
void multiply(const Factor& a, const Columns& b, Rows& c) {
  using Block = Eigen::Matrix<double, kBlock, 1>;
  static_assert(SourceGrid::kDown % kColumns == 0);
  c.resize(a.rows(), SourceGrid::kDown);
  for (Eigen::Index row = 0; row < a.rows(); row += kBlock) {
    for (int column = 0; column < SourceGrid::kDown; column += kColumns) {
      std::array<Block, kColumns> sums;
      sums.fill(Block::Zero());
      for (Eigen::Index i = 0; i < a.cols(); ++i) {
        const Block own = a.col(i).template segment<kBlock>(row);
        for (int k = 0; k < kColumns; ++k) sums[k] += own * b(i, column + k);
      }
      for (int k = 0; k < kColumns; ++k) {
        c.col(column + k).template segment<kBlock>(row) = sums[k];
      }
    }
  }
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
    // Between a depth and its double, twelve nodes miss exp(-K d) by 2e-10 at most, K d being about
    // 9.
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
  // The ship's very ends may be rounded to beyond the last panel.
  place.panel = std::clamp(static_cast<int>(along), 0, layer.panels - 1);
  place.along = Along::get().at(along - place.panel);
  place.down = Down::get().at((depth - layer.top) / layer.height);
  return place;
}

void SourceGrid::add(double x, double depth, double strength) {
  const Place at = place(x, depth);
  // A quadrature mostly stays in a rectangle for a while: sources that wait for others of theirs
  // are added by one product of matrices in place of as many of rank one.
  auto own = std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& one) {
    return one.layer == at.layer && one.panel == at.panel;
  });
  if (own == waiting_.end()) {
    own = waiting_.begin() + next_;
    next_ = (next_ + 1) % static_cast<int>(waiting_.size());
    take(*own);
    own->layer = at.layer;
    own->panel = at.panel;
  }
  own->along.col(own->count) = strength * at.along;
  own->down.row(own->count) = at.down.transpose();
  if (++own->count == kAtOnce) take(*own);
}

void SourceGrid::take(Waiting& waiting) {
  if (waiting.count == 0) return;
  // Behind the last there is what was added before.
  waiting.along.rightCols(kAtOnce - waiting.count).setZero();
  waiting.down.bottomRows(kAtOnce - waiting.count).setZero();
  Rows sum;
  multiply(waiting.along, waiting.down, sum);
  layers_[waiting.layer].strengths.middleCols<kDown>(static_cast<Eigen::Index>(kDown) *
                                                     waiting.panel) += sum;
  waiting.count = 0;
}

void SourceGrid::take_all() {
  for (Waiting& waiting : waiting_) take(waiting);
}

SourceGrid::Waves SourceGrid::within(const Layer& layer, const Eigen::VectorXd& k) {
  // From the middle of a rectangle, whichever of its layer.
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

SourceGrid::Interpolation SourceGrid::interpolation(const Layer& layer, const Eigen::VectorXd& k) {
  const double low = k.minCoeff(), range = k.maxCoeff() - low;
  // No node is farther than half a rectangle from its middle.
  const int nodes = nodes_for(0.5 * range * layer.width);
  // As many waves as are asked for: these are summed themselves.
  if (nodes >= k.size()) {
    return padded({within(layer, k), Eigen::MatrixXd::Identity(k.size(), k.size())});
  }
  Eigen::VectorXd own(nodes);
  for (int i = 0; i < nodes; ++i) {
    own[i] = low + 0.5 * range * (1.0 - std::cos(std::numbers::pi * (i + 0.5) / nodes));
  }
  return padded({within(layer, own), lagrange(own, k)});
}

SourceGrid::Interpolation SourceGrid::padded(const Interpolation& by) {
  const auto up = [](Eigen::Index count) { return (count + kBlock - 1) / kBlock * kBlock; };
  const Eigen::Index nodes = by.polynomials.cols(), rows = by.polynomials.rows();
  Interpolation found{
      {Eigen::MatrixXd::Zero(up(nodes), kAlong), Eigen::MatrixXd::Zero(up(nodes), kAlong)},
      Eigen::MatrixXd::Zero(up(rows), up(nodes))};
  found.waves.cosines.topRows(nodes) = by.waves.cosines;
  found.waves.sines.topRows(nodes) = by.waves.sines;
  found.polynomials.topLeftCorner(rows, nodes) = by.polynomials;
  return found;
}

Eigen::MatrixXcd SourceGrid::sums(int layer, std::span<const double> wave_numbers) const {
  assert(std::all_of(waiting_.begin(), waiting_.end(), [](const Waiting& w) { return !w.count; }));
  const Layer& own = layers_[layer];
  const auto count = static_cast<Eigen::Index>(wave_numbers.size());
  const Interpolation by = interpolation(own, as_vector(wave_numbers));
  // Rows beyond those asked for have k = 0 and no polynomial: they stay zero.
  Eigen::ArrayXd k = Eigen::ArrayXd::Zero(by.polynomials.rows());
  k.head(count) = as_vector(wave_numbers).array();
  const Eigen::ArrayXd step_cos = (k * own.width).cos(), step_sin = (k * own.width).sin();
  Eigen::ArrayXd middle_cos, middle_sin, last;
  Rows at_nodes, cosines, sines, real = Rows::Zero(k.size(), kDown), imaginary = real;
  for (int panel = 0; panel < own.panels; ++panel) {
    if (panel % kTurnedOn == 0) {
      const Eigen::ArrayXd phases = k * (aft_ + (panel + 0.5) * own.width);
      middle_cos = phases.cos();
      middle_sin = phases.sin();
    }
    const auto strengths =
        own.strengths.middleCols<kDown>(static_cast<Eigen::Index>(kDown) * panel);
    multiply(by.waves.cosines, strengths, at_nodes);
    multiply(by.polynomials, at_nodes, cosines);
    multiply(by.waves.sines, strengths, at_nodes);
    multiply(by.polynomials, at_nodes, sines);
    // (cosines + i sines) times the wave at the panel's middle, which the next lines turn on by a
    // panel's width: a complex product in place of new cosines and sines.
    real.array() += cosines.array().colwise() * middle_cos - sines.array().colwise() * middle_sin;
    imaginary.array() +=
        cosines.array().colwise() * middle_sin + sines.array().colwise() * middle_cos;
    last = middle_cos;
    middle_cos = middle_cos * step_cos - middle_sin * step_sin;
    middle_sin = last * step_sin + middle_sin * step_cos;
  }
  Eigen::MatrixXcd sums(count, kDown);
  sums.real() = real.topRows(count);
  sums.imag() = imaginary.topRows(count);
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
  // Re(factor exp(i k x)) of each node: the transpose of sums().
  own.strengths += waves.cosines.transpose() * real - waves.sines.transpose() * imaginary;
}

void SourceGrid::differentiate() {
  for (Layer& layer : layers_) {
    // x runs down the columns, the depth along the rows of each panel's own columns.
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
