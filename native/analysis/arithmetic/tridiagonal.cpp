// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/tridiagonal.h"

#include <cstddef>
#include <utility>

namespace hull::analysis {

// Thomas' algorithm.
std::vector<Vector3d> Tridiagonal::solve(std::vector<Vector3d> right) const {
  std::vector<double> pivots = diagonal;
  const std::size_t n = pivots.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = below[i] / pivots[i - 1];
    pivots[i] -= factor * above[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) right[i] -= above[i] * right[i + 1];
    right[i] /= pivots[i];
  }
  return right;
}

// The corners of the cyclic matrix are a product of two vectors (Sherman and Morrison 1950).
std::vector<Vector3d> Tridiagonal::solve_cyclic(std::vector<Vector3d> right) const {
  const std::size_t n = diagonal.size();
  // Any shift but zero does; with this one the diagonal dominates no less.
  const double corner = below[0], other = above[n - 1], shift = -diagonal[0];
  Tridiagonal inner = *this;
  inner.diagonal[0] -= shift;
  inner.diagonal[n - 1] -= corner * other / shift;
  // Numbers in the x of points, so that one solver serves both.
  std::vector<Vector3d> u(n, Vector3d::Zero());
  u[0].x() = shift;
  u[n - 1].x() = other;
  std::vector<Vector3d> m = inner.solve(std::move(right));
  const std::vector<Vector3d> z = inner.solve(std::move(u));
  const double ratio = corner / shift;
  const Vector3d share = (m[0] + ratio * m[n - 1]) / (1.0 + z[0].x() + ratio * z[n - 1].x());
  for (std::size_t i = 0; i < n; ++i) m[i] -= z[i].x() * share;
  return m;
}

}  // namespace hull::analysis
