// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <functional>
#include <vector>

#include "surface/pieces/surface_squares.h"

namespace hull::surface {

// Sums over a surface of quadratic forms that are known by the points of its squares, brought to
// its control points. Depends on topology, tags and scheme only. Immutable.
class SquareForms {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  explicit SquareForms(const LimitSurface& surface);

  const SurfaceSquares& squares() const { return squares_; }

  // Control points x control points. `add` is told each square in turn, and adds its form to a
  // matrix of zeros: the square's points x these, symmetric.
  using Add = std::function<void(int square, Eigen::MatrixXd& form)>;
  Matrix sum(const Add& add) const;

 private:
  // Squares that follow one another in a cell, and the control points of all of these, rising.
  struct Group {
    int first_square, square_count, first_point, point_count;
  };
  void find_groups();
  void find_pattern();
  // Qᵀ · form · Q, Q the weights of the square's points by the group's control points.
  void add_square(int square, const Eigen::MatrixXd& form, Eigen::MatrixXd& of_group) const;
  void add_group(const Group& group, const Eigen::MatrixXd& form, Matrix& sum) const;

  SurfaceSquares squares_;
  std::vector<Group> groups_;
  std::vector<int> group_points_;
  // Of squares, one after another: for each weight of each of its points where the control point is
  // among those of the group.
  std::vector<int> first_place_, places_;
  Matrix pattern_;
};

}  // namespace hull::surface
