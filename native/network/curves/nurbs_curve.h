// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/vectors.h"

namespace hull::network {

using Points3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

// A rational B-spline curve in space over knots of which the first and last are there degree + 1
// times. Immutable.
class NurbsCurve {
 public:
  // No weights: all 1. Throws std::invalid_argument for knots that fall or do not fit, for what is
  // no number, and for weights that are not positive.
  NurbsCurve(int degree, std::vector<double> knots, Points3 points, Eigen::VectorXd weights = {});

  int degree() const { return degree_; }
  const std::vector<double>& knots() const { return knots_; }
  const Points3& points() const { return points_; }
  const Eigen::VectorXd& weights() const { return weights_; }
  double begin() const { return knots_.front(); }
  double end() const { return knots_.back(); }

  // A row an order: the point, and derivatives by the parameter up to `order`; those above the
  // degree of a curve with equal weights are zero. At inner knots they are those of the span above.
  // REQUIRES: begin() <= t <= end().
  Points3 evaluate(double t, int order) const;
  Vector3d point(double t) const { return evaluate(t, 0).row(0); }

  NurbsCurve reversed() const;

  // Bit by bit.
  bool operator==(const NurbsCurve& other) const {
    return degree_ == other.degree_ && knots_ == other.knots_ &&
           points_.rows() == other.points_.rows() && points_ == other.points_ &&
           weights_ == other.weights_;
  }

  // Where it is nearest to a place: of all parts, none of which turns back within 1e-4 of the
  // curve's size.
  double nearest_parameter(const Vector3d& place) const;

 private:
  double nearest_in(double low, double high, const Vector3d& place) const;

  int degree_;
  std::vector<double> knots_;
  Points3 points_;
  Eigen::VectorXd weights_;
};

}  // namespace hull::network
