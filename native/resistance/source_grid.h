// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "resistance/wave_scales.h"

namespace hull::resistance {

// Sources spread over a centre plane, as few numbers from which all their waves up to given scales
// follow: exp(i k x - K d) is a polynomial in x and d on small rectangles, to 1e-10, so that a
// source counts by the values of Lagrange's polynomials at its place. Rectangles are in layers
// whose depths double from the water's surface down, where short waves do not reach: deep ones are
// long.
class SourceGrid {
 public:
  static constexpr int kAlong = 32, kDown = 12;  // Chebyshev nodes of a rectangle

  // For sources from x = aft to x = forward and depths from 0 to deepest, m. REQUIRES: aft <
  // forward, deepest > 0.
  SourceGrid(double aft, double forward, double deepest, const WaveScales& scales);

  const WaveScales& scales() const { return scales_; }
  double aft() const { return aft_; }
  double length() const { return length_; }
  int layer_count() const { return static_cast<int>(layers_.size()); }
  // Depths of a layer's nodes, and of its upper side.
  const Eigen::Array<double, 1, kDown>& depths(int layer) const { return layers_[layer].depths; }
  double top(int layer) const { return layers_[layer].top; }

  // After the last one take_all() is to be called: sources wait, to be added several at once.
  void add(double x, double depth, double strength);
  void take_all();
  void set_zero();

  // For each wave number (a row) and each node's depth (a column): ∑ strength exp(i k x) of the
  // layer. REQUIRES: wave numbers are not above scales().along.
  Eigen::MatrixXcd sums(int layer, std::span<const double> wave_numbers) const;

  // Adds to the strengths of nodes what a number gains by them whose derivatives by sums() are
  // given, as Re(factor · change): turns the grid into derivatives by strengths.
  void add_back(int layer, std::span<const double> wave_numbers, const Eigen::MatrixXcd& factors);

  // Of the polynomials through the nodes' strengths: the value, and derivatives by x and depth.
  struct Jet {
    double value = 0.0, by_x = 0.0, by_depth = 0.0;
  };
  // To be called after the last add_back(), before at().
  void differentiate();
  Jet at(double x, double depth) const;

 private:
  // Panel by panel along: kDown columns each.
  using Strengths = Eigen::Matrix<double, kAlong, Eigen::Dynamic>;
  struct Layer {
    double top, height, width;  // of a rectangle
    int panels;
    Eigen::Array<double, 1, kDown> depths;
    Strengths strengths, by_x, by_depth;
  };
  struct Place {
    int layer, panel;
    Eigen::Matrix<double, kAlong, 1> along;
    Eigen::Matrix<double, kDown, 1> down;
  };
  Place place(double x, double depth) const;
  static constexpr int kAtOnce = 16;
  // Sources of one rectangle.
  struct Waiting {
    int layer = -1, panel = -1, count = 0;
    Eigen::Matrix<double, kAlong, kAtOnce> along;
    Eigen::Matrix<double, kAtOnce, kDown> down;
  };
  void take(Waiting& waiting);
  // Cosines and sines of k times a distance, a row for each k: of the nodes from the middle of
  // their rectangle, and of these middles.
  struct Waves {
    Eigen::MatrixXd cosines, sines;
  };
  static Waves within(const Layer& layer, const Eigen::VectorXd& k);
  Waves at_middles(const Layer& layer, const Eigen::VectorXd& k) const;
  // Of ∑ strength exp(i k x) over a rectangle's nodes, x from its middle: the waves of few k, and
  // the polynomials by which the sums for all k (a row each) follow from theirs. They vary little
  // with k where rectangles are short.
  struct Interpolation {
    Waves waves;
    Eigen::MatrixXd polynomials;
  };
  static Interpolation interpolation(const Layer& layer, const Eigen::VectorXd& k);
  // With zeros to whole blocks of rows, and of polynomials.
  static Interpolation padded(const Interpolation& by);

  double aft_, length_;
  WaveScales scales_;
  std::vector<Layer> layers_;
  std::array<Waiting, 4> waiting_;
  int next_ = 0;  // of these, to be taken when another is needed
};

}  // namespace hull::resistance
