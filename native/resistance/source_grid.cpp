// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/source_grid.h"

#include <algorithm>

#include "resistance/chebyshev.h"

namespace hull::resistance {
namespace {

using Along = ChebyshevNodes<SourceGrid::kAlong>;
using Down = ChebyshevNodes<SourceGrid::kDown>;

// How far the phase turns over a rectangle, and how many e-foldings the uppermost layer has:
// interpolation at n nodes is off by at most 2 (phase / 4)^n / n! (Lagrange's remainder).
constexpr double kPhase = 24.0, kFirstDecay = 2.0;

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

SourceGrid::Phases SourceGrid::phases(const Layer& layer,
                                      std::span<const double> wave_numbers) const {
  const Eigen::Map<const Eigen::VectorXd> k(wave_numbers.data(),
                                            static_cast<Eigen::Index>(wave_numbers.size()));
  const Eigen::MatrixXd nodes = k * (layer.width * Along::get().nodes().transpose());
  const Eigen::RowVectorXd sides =
      Eigen::RowVectorXd::LinSpaced(layer.panels, 0.0, layer.panels - 1).array() * layer.width +
      aft_;
  const Eigen::MatrixXd at_sides = k * sides;
  return {nodes.array().cos(), nodes.array().sin(), at_sides.array().cos(), at_sides.array().sin()};
}

Eigen::MatrixXcd SourceGrid::sums(int layer, std::span<const double> wave_numbers) const {
  const Layer& own = layers_[layer];
  const Phases phase = phases(own, wave_numbers);
  // Kept, for they are large and asked for again and again.
  thread_local Eigen::MatrixXd cosines, sines;
  cosines.noalias() = phase.node_cos * own.strengths;
  sines.noalias() = phase.node_sin * own.strengths;
  Eigen::MatrixXcd sums = Eigen::MatrixXcd::Zero(phase.node_cos.rows(), kDown);
  for (int panel = 0; panel < own.panels; ++panel) {
    const auto c = cosines.middleCols<kDown>(static_cast<Eigen::Index>(kDown) * panel).array(),
               s = sines.middleCols<kDown>(static_cast<Eigen::Index>(kDown) * panel).array();
    const Eigen::ArrayXd side_cos = phase.side_cos.col(panel), side_sin = phase.side_sin.col(panel);
    sums.real().array() += c.colwise() * side_cos - s.colwise() * side_sin;
    sums.imag().array() += c.colwise() * side_sin + s.colwise() * side_cos;
  }
  return sums;
}

void SourceGrid::add_back(int layer, std::span<const double> wave_numbers,
                          const Eigen::MatrixXcd& factors) {
  Layer& own = layers_[layer];
  const Phases phase = phases(own, wave_numbers);
  Eigen::MatrixXd real(factors.rows(), own.strengths.cols()), imaginary(real.rows(), real.cols());
  const Eigen::ArrayXXd a = factors.real(), b = factors.imag();
  for (int panel = 0; panel < own.panels; ++panel) {
    const Eigen::Index first = static_cast<Eigen::Index>(kDown) * panel;
    const Eigen::ArrayXd side_cos = phase.side_cos.col(panel), side_sin = phase.side_sin.col(panel);
    real.middleCols<kDown>(first) = a.colwise() * side_cos - b.colwise() * side_sin;
    imaginary.middleCols<kDown>(first) = a.colwise() * side_sin + b.colwise() * side_cos;
  }
  own.strengths += phase.node_cos.transpose() * real - phase.node_sin.transpose() * imaginary;
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
