// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "modelling/freedom.h"

namespace hull::modelling {

// Along the direction a control point moves as much as another one does.
struct TiedPoint {
  int point, leader;
  Vector3d direction;  // of any length but zero
};

// A sum over moves of control points, Σ slopes[i] · move(points[i]).
struct MoveCondition {
  std::vector<int> points;
  std::vector<Vector3d> slopes;
};

// What control points may do while a surface is reshaped.
struct ReshapeLimits {
  MoveLimits limits;                 // locked points, and points held in planes
  std::vector<TiedPoint> tied = {};  // where the surface is to stay square to a plane, for one
  std::vector<int> prescribed = {};  // control points that move as they are told, each time anew
  std::vector<MoveCondition> kept = {};  // sums that stay zero; they may depend on one another
};

// All moves of the control points within limits, Δ = basis() · y + particular(prescribed moves):
// none but these is ever taken, so the limits hold to rounding, and exactly for locked and
// prescribed points.
//
// Columns of the basis are orthonormal, and each is along one axis where the limits that it has to
// do with are.
class MoveSpace {
 public:
  // Throws std::invalid_argument for points and directions that are none.
  MoveSpace(const ReshapeLimits& limits, int point_count);

  // 3 x points rows (x, y, z of each), a column for each degree of freedom.
  const Eigen::SparseMatrix<double>& basis() const { return basis_; }
  int size() const { return static_cast<int>(basis_.cols()); }
  int point_count() const { return point_count_; }

  // The shortest moves within the limits by which the prescribed points move as told, one vector
  // each; 3 x points long. Throws std::invalid_argument, naming those that contradict the
  // limits or one another, where there are none.
  Eigen::VectorXd particular(const std::vector<Vector3d>& prescribed) const;

 private:
  class Builder;
  // Coordinates (3 · point + axis) that limits make depend on one another, with all that is asked
  // of them: rows · Δ = value, where `told` is the coordinate of a prescribed point the row stands
  // for, or -1 for zero.
  struct Group {
    std::vector<int> coordinates;
    Eigen::MatrixXd rows;
    std::vector<int> told;
    Eigen::MatrixXd inverse;  // of the rows: from values to the shortest moves
  };

  std::vector<int> prescribed_;
  std::vector<Group> told_groups_;  // those with a prescribed point
  Eigen::SparseMatrix<double> basis_;
  int point_count_;
};

// Throws std::invalid_argument, in which `name` tells which it is, for a condition of points that
// are none of `point_count`, or without a finite slope for each.
void check_condition(const MoveCondition& condition, int point_count, const char* name);

// A row a condition, by the moves of all points: x, y and z of each. Throws as check_condition().
using ConditionRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
ConditionRows condition_rows(const std::vector<MoveCondition>& conditions, int point_count);

}  // namespace hull::modelling
