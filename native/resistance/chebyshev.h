// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace hull::resistance {

// Lagrange's polynomials of the n Chebyshev nodes (of the first kind) of [0, 1], by the barycentric
// formula (Berrut & Trefethen 2004, equations 4.2 and 9.4).
template <int n>
class ChebyshevNodes {
 public:
  using Values = Eigen::Matrix<double, n, 1>;

  ChebyshevNodes() {
    for (int i = 0; i < n; ++i) {
      const double angle = std::numbers::pi * (i + 0.5) / n;
      nodes_[i] = 0.5 * (1.0 - std::cos(angle));
      weights_[i] = (i % 2 ? -1.0 : 1.0) * std::sin(angle);
    }
    for (int i = 0; i < n; ++i) {
      double diagonal = 0.0;
      for (int j = 0; j < n; ++j) {
        if (j == i) continue;
        slopes_(i, j) = weights_[j] / weights_[i] / (nodes_[i] - nodes_[j]);
        diagonal -= slopes_(i, j);
      }
      slopes_(i, i) = diagonal;
    }
  }

  const Values& nodes() const { return nodes_; }
  // Derivatives at the nodes (rows) of the polynomials (columns).
  const Eigen::Matrix<double, n, n>& slopes() const { return slopes_; }

  // All polynomials at t.
  Values at(double t) const {
    const Values distances = Values::Constant(t) - nodes_;
    for (int i = 0; i < n; ++i) {
      if (distances[i] == 0.0) return Values::Unit(i);
    }
    const Values values = weights_.cwiseQuotient(distances);
    return values * (1.0 / values.sum());
  }

  static const ChebyshevNodes& get() {
    static const ChebyshevNodes nodes;
    return nodes;
  }

 private:
  Values nodes_, weights_;
  Eigen::Matrix<double, n, n> slopes_;
};

}  // namespace hull::resistance
