// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "modelling/fit/fit.h"
#include "modelling/reshape/move_space.h"

namespace hull::modelling {

// Bounds of control points as rows · y >= gaps of moves within a space, y in its basis.
class MoveBounds {
 public:
  // REQUIRES: bounds of points of the space, with directions. Those that the space has no move
  // along are left out.
  MoveBounds(const std::vector<FitBound>& bounds, const MoveSpace& space);

  bool empty() const { return bounds_.empty(); }

  // What is missing at points as they are, m: positive where one is beyond its bound.
  Eigen::VectorXd gaps(const std::vector<Vector3d>& points) const;

  // Of the y within the bounds that where ½ yᵀHy - gᵀy is least; `free` is that without bounds,
  // H⁻¹ g, and `solve` takes right sides, a column each, to H⁻¹ of them, H positive definite.
  // Bounds are met to kBoundRounding of the longer of y and gaps. Those that are broken join the
  // ones that count, until none is: some rounds, each with a dual problem (bounded_dual.h) of
  // those.
  using Solve = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;
  Eigen::VectorXd least(Eigen::VectorXd free, const Eigen::VectorXd& gaps,
                        const Solve& solve) const;

  // The shortest moves of all points that bring them within the bounds; none where they are.
  std::optional<std::vector<Vector3d>> moves_within(const std::vector<Vector3d>& points) const;

 private:
  const MoveSpace& space_;
  std::vector<FitBound> bounds_;  // their directions of length 1
  ConditionRows rows_;            // of y
};

inline constexpr double kBoundRounding = 1e-12;

}  // namespace hull::modelling
