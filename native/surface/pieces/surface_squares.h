// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "surface/limit_surface.h"

namespace hull::surface {

// All refined points of a surface that its leaves and corners take, as SurfaceLayout numbers them,
// as sums of control points, a row each; rows of others are empty.
using WeightRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
WeightRows refined_weights(const LimitSurface& surface);

// The squares that a surface is evaluated from, leaves and corners, cell after cell. What is a
// linear function of a square's points is one matrix for all squares of a kind, and these are few:
// sums over a whole surface need neither be multiplied out by control points, nor kept for each
// square.
//
// Depends on topology, tags and scheme only. Immutable.
class SurfaceSquares {
 public:
  // What squares have in common.
  struct Kind {
    const CornerBasis* basis;  // of corners, whose points the square's are; none of leaves, …
    // … of whose 16 B-spline points these are the weights of the square's points: those beyond
    // creases and borders are reflections of others.
    Eigen::MatrixXd spread;
    std::vector<int> squares;

    Eigen::Index point_count() const { return basis ? basis->point_count() : spread.cols(); }
  };

  explicit SurfaceSquares(const LimitSurface& surface);

  int count() const { return static_cast<int>(squares_.size()); }
  int cell(int square) const { return squares_[square].cell; }
  // Of SurfaceLayout's leaves or corners.
  int index(int square) const { return squares_[square].index; }
  int kind(int square) const { return squares_[square].kind; }
  const std::vector<Kind>& kinds() const { return kinds_; }
  // Its refined points.
  std::span<const int> points(int square) const {
    const Square& own = squares_[square];
    return {points_.data() + own.first, static_cast<std::size_t>(own.count)};
  }
  // Of refined points, by control points.
  const WeightRows& weights() const { return weights_; }

 private:
  struct Square {
    int cell, index, kind, first, count;
  };
  class Builder;

  std::shared_ptr<const SurfaceLayout> layout_;  // whose bases kinds have
  std::vector<Square> squares_;
  std::vector<Kind> kinds_;
  std::vector<int> points_;
  WeightRows weights_;
};

}  // namespace hull::surface
