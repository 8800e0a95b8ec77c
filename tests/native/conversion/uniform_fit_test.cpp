// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/per_cell/uniform_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "conversion/patches/bspline_patch.h"

namespace hull::conversion {
namespace {

Vector3d cubic(double t) { return {1 + t - 2 * t * t * t, t * t, 3 - t + 0.5 * t * t * t}; }

Vector3d bicubic(double u, double v) { return cubic(u).cwiseProduct(cubic(v)); }

Vector3d wave(double u, double v) { return {u, v, std::sin(3 * u) * std::cos(2 * v)}; }

BSplinePatch fitted(const UniformFit& fit, Vector3d (*surface)(double, double)) {
  const int n = fit.control_points(), m = fit.intervals();
  BSplinePatch patch{3, 3, open_uniform_knots(3, n), open_uniform_knots(3, n), n, n, {}, 0};
  patch.control_points.assign(n * n, Vector3d::Zero());
  const Eigen::Vector2d corners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int side = 0; side < 4; ++side) {
    std::vector<Vector3d> data;
    for (int i = 0; i <= m; ++i) {
      const Eigen::Vector2d uv =
          corners[side] + (corners[(side + 1) % 4] - corners[side]) * (static_cast<double>(i) / m);
      data.push_back(surface(uv.x(), uv.y()));
    }
    const auto points = fit.curve(data);
    for (int i = 0; i < n; ++i) patch.control_points[patch.side_index(side, i)] = points[i];
  }
  std::vector<Vector3d> data;
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= m; ++j) {
      data.push_back(surface(static_cast<double>(i) / m, static_cast<double>(j) / m));
    }
  }
  fit.interior(data, patch.control_points);
  return patch;
}

double largest_distance(const BSplinePatch& patch, Vector3d (*surface)(double, double)) {
  double largest = 0.0;
  for (double u = 0.0; u <= 1.0; u += 1.0 / 32) {
    for (double v = 0.0; v <= 1.0; v += 1.0 / 32) {
      largest = std::max(largest, (patch.position(u, v) - surface(u, v)).norm());
    }
  }
  return largest;
}

TEST(UniformFit, ReproducesBicubicSurfaces) {
  for (int n = 4; n <= 9; ++n) {
    const UniformFit fit(n, 2 * n + 2);
    EXPECT_LT(largest_distance(fitted(fit, bicubic), bicubic), 1e-13) << n;
  }
}

TEST(UniformFit, KeepsTheEndsOfCurvesBitForBit) {
  const UniformFit fit(5, 12);
  std::vector<Vector3d> data;
  for (int i = 0; i <= 12; ++i) data.push_back(wave(i / 12.0, 0.3));
  const auto points = fit.curve(data);
  EXPECT_EQ(points.front(), data.front());
  EXPECT_EQ(points.back(), data.back());
}

// The normal equations: the residual is orthogonal to every free basis function.
TEST(UniformFit, IsTheLeastSquaresSolution) {
  const int n = 6, m = 14;
  const UniformFit fit(n, m);
  std::vector<Vector3d> data;
  for (int i = 0; i <= m; ++i) {
    const double t = static_cast<double>(i) / m;
    data.emplace_back(std::exp(t), std::sin(9 * t), std::abs(t - 0.4));
  }
  const auto points = fit.curve(data);
  const auto knots = open_uniform_knots(3, n);
  std::vector<Vector3d> gradient(n, Vector3d::Zero());
  for (int i = 0; i <= m; ++i) {
    const BasisValues values = basis_values(knots, 3, static_cast<double>(i) / m);
    Vector3d residual = -data[i];
    for (int k = 0; k < 4; ++k) residual += values.rows(0, k) * points[values.first + k];
    for (int k = 0; k < 4; ++k) gradient[values.first + k] += values.rows(0, k) * residual;
  }
  for (int k = 1; k < n - 1; ++k) EXPECT_LT(gradient[k].norm(), 1e-14) << k;
}

// Cubic splines approximate smooth functions to fourth order: half the spans' width, a sixteenth of
// the distance.
TEST(UniformFit, ConvergesWithFourthOrder) {
  const double coarse = largest_distance(fitted(UniformFit(7, 16), wave), wave);
  const double fine = largest_distance(fitted(UniformFit(11, 24), wave), wave);
  EXPECT_GT(coarse / fine, 10.0);
  EXPECT_LT(fine, 1e-4);
}

TEST(UniformFit, LeavesTheBorderAlone) {
  const UniformFit fit(5, 12);
  const BSplinePatch patch = fitted(fit, wave);
  std::vector<Vector3d> points = patch.control_points;
  fit.interior(std::vector<Vector3d>(13 * 13, Vector3d(5, 6, 7)), points);
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < 5; ++i) {
      EXPECT_EQ(points[patch.side_index(side, i)], patch.control_points[patch.side_index(side, i)]);
    }
  }
}

TEST(UniformFit, RefusesTooFewOfEither) {
  EXPECT_THROW(UniformFit(3, 10), std::invalid_argument);
  EXPECT_THROW(UniformFit(5, 4), std::invalid_argument);
}

}  // namespace
}  // namespace hull::conversion
