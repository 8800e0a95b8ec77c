// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit_bounds.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include "modelling/fit/fit.h"
#include "test_meshes.h"

namespace hull::modelling {
namespace {

constexpr unsigned kBoundsSeed = 25112026;
constexpr int kTrials = 200, kPoints = 2, kBounds = 5;

// Of all sets of bounds that are met as equations the one within all of them whose ½ x'Hx - g'x is
// least.
Eigen::VectorXd least_of_all_sets(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                                  const Eigen::MatrixXd& rows, const Eigen::VectorXd& gaps) {
  double least = std::numeric_limits<double>::infinity();
  Eigen::VectorXd best;
  for (int set = 0; set < 1 << kBounds; ++set) {
    std::vector<int> own;
    for (int i = 0; i < kBounds; ++i) {
      if (set >> i & 1) own.push_back(i);
    }
    const auto n = H.rows(), m = static_cast<Eigen::Index>(own.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + m, n + m);
    matrix.topLeftCorner(n, n) = H;
    matrix.topRightCorner(n, m) = rows(own, Eigen::all).transpose();
    matrix.bottomLeftCorner(m, n) = rows(own, Eigen::all);
    Eigen::VectorXd right(n + m);
    right << g, gaps(own);
    const Eigen::FullPivLU<Eigen::MatrixXd> factors(matrix);
    if (!factors.isInvertible()) continue;
    const Eigen::VectorXd x = factors.solve(right).head(n);
    const double value = 0.5 * x.dot(H * x) - g.dot(x);
    if ((rows * x - gaps).minCoeff() < -1e-9 || !(value < least)) continue;
    least = value;
    best = x;
  }
  return best;
}

TEST(FitBounds, LeastIsThatOfAllSetsOfBounds) {
  SCOPED_TRACE(::testing::Message() << "seed " << kBoundsSeed);
  std::mt19937 random(kBoundsSeed);
  std::normal_distribution<double> normal;
  const auto number = [&] { return normal(random); };
  const MoveSpace space({}, kPoints);
  int met = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<FitBound> list;
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(kBounds, 3 * kPoints);
    std::vector<Vector3d> points;
    for (int i = 0; i < kPoints; ++i) points.emplace_back(number(), number(), number());
    Eigen::VectorXd gaps(kBounds);
    for (int i = 0; i < kBounds; ++i) {
      const int point = i % kPoints;
      const Vector3d direction = Vector3d(number(), number(), number()).normalized();
      // Longer than 1: the bound is the same.
      list.push_back({point, 3.0 * direction, 3.0 * number()});
      rows.row(i).segment<3>(3 * static_cast<Eigen::Index>(point)) = direction;
      gaps[i] = list.back().least / 3.0 - direction.dot(points[point]);
    }
    const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(6, 6, number);
    const Eigen::MatrixXd H = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(6, 6);
    const Eigen::VectorXd g = Eigen::VectorXd::NullaryExpr(6, number);
    const Eigen::VectorXd wanted = least_of_all_sets(H, g, rows, gaps);
    if (wanted.size() == 0) continue;  // no point of that kind is within all
    const MoveBounds bounds(list, space);
    EXPECT_LT((bounds.gaps(points) - gaps).norm(), 1e-12);
    const Eigen::LLT<Eigen::MatrixXd> factors(H);
    const Eigen::VectorXd found =
        bounds.least(factors.solve(g), bounds.gaps(points),
                     [&](const Eigen::MatrixXd& right) { return factors.solve(right).eval(); });
    // As far as the form tells y apart: the root of rounding of the value.
    EXPECT_LT((found - wanted).norm(), 1e-7 * (1.0 + wanted.norm()));
    EXPECT_GT((rows * found - gaps).minCoeff(), -1e-9);
    if ((found - factors.solve(g)).norm() > 1e-6) ++met;
  }
  EXPECT_GT(met, kTrials / 2);
}

TEST(FitBounds, AreLeftOutWhereNoMoveIsAlongThem) {
  ReshapeLimits limits;
  limits.limits.locked = {0};
  limits.limits.held = {{1, Vector3d::UnitZ()}};
  const std::vector<FitBound> list{{0, Vector3d::UnitX(), 5.0}, {1, Vector3d::UnitZ(), 5.0}};
  const MoveSpace space(limits, kPoints);
  EXPECT_TRUE(MoveBounds(list, space).empty());
  EXPECT_FALSE(MoveBounds({{1, Vector3d::UnitY(), 5.0}}, space).empty());
}

// A sheet that is to lie along a saddle, of which a part is below z = 0, and not go below.
class BoundedSheet : public ::testing::Test {
 protected:
  BoundedSheet() : sheet_{mesh::ControlMesh(testing::grid(4, 4))} {
    mesh::MeshArrays saddle = testing::grid(4, 4);
    for (auto& p : saddle.points) p.z() = 0.1 * (p.x() - 2.0) * (p.y() - 2.0);
    const surface::LimitSurface wanted{mesh::ControlMesh(saddle)};
    for (int cell = 0; cell < wanted.cell_count(); ++cell) {
      for (int k = 0; k < 9; ++k) {
        target_.points.push_back(wanted.position(cell, (k % 3) / 2.0, (k / 3) / 2.0));
      }
    }
    options_.fairness = 0.0;
    options_.draw_border = true;
    options_.most_steps = 20;
    for (int i = 0; i < count(); ++i) options_.bounds.push_back({i, Vector3d::UnitZ(), 0.0});
  }

  int count() const { return sheet_.mesh().topology().vertex_count(); }

  surface::LimitSurface sheet_;
  FitTarget target_;
  FitOptions options_;
};

TEST_F(BoundedSheet, StaysWithinAndIsAtBoundsWhereItWouldLeaveThem) {
  const double rounding = 1e-12 * sheet_.mesh().size();
  FitOptions without = options_;
  without.bounds.clear();
  const Fit free = fit(sheet_, target_, {}, without);
  const Fit found = fit(sheet_, target_, {}, options_);
  std::vector<int> at_bound;
  for (int i = 0; i < count(); ++i) {
    EXPECT_GE(found.points[i].z(), -rounding);
    if (found.points[i].z() <= rounding) at_bound.push_back(i);
  }
  EXPECT_LT(free.rms, 1e-9);
  EXPECT_GT(found.rms, 1e-3);
  ASSERT_GT(at_bound.size(), 5u);
  ASSERT_LT(at_bound.size(), static_cast<std::size_t>(count()) - 5);
  // Held where they are the fit has nowhere to go …
  surface::LimitSurface fitted = sheet_;
  fitted.set_points(found.points);
  FitOptions held = without;
  for (int i : at_bound) held.limits.limits.held.push_back({i, Vector3d::UnitZ()});
  EXPECT_NEAR(fit(fitted, target_, {}, held).rms, found.rms, 1e-6 * found.rms);
  // … and each that is let go leaves it, or has no reason to.
  int leaving = 0;
  for (std::size_t k = 0; k < at_bound.size(); k += 3) {
    FitOptions but_one = options_;
    but_one.bounds.erase(but_one.bounds.begin() + at_bound[k]);
    leaving += fit(fitted, target_, {}, but_one).points[at_bound[k]].z() < -1e-3 ? 1 : 0;
  }
  EXPECT_GT(leaving, static_cast<int>(at_bound.size()) / 6);
}

TEST_F(BoundedSheet, ComesInFirstWhereItBeginsBeyond) {
  std::vector<Vector3d> points = sheet_.mesh().points();
  for (Vector3d& p : points) p.z() -= 0.5;
  points[7].z() = 0.25;
  surface::LimitSurface below = sheet_;
  below.set_points(points);
  options_.most_steps = 0;
  const Fit found = fit(below, target_, {}, options_);
  for (int i = 0; i < count(); ++i) {
    EXPECT_NEAR(found.points[i].z(), std::max(0.0, points[i].z()), kBoundRounding);
    EXPECT_EQ(found.points[i].x(), points[i].x());
  }
}

TEST_F(BoundedSheet, RefusesBoundsThatAreNone) {
  for (const FitBound& none :
       {FitBound{99, Vector3d::UnitZ(), 0.0}, FitBound{1, Vector3d::Zero(), 0.0},
        FitBound{1, Vector3d::UnitZ(), std::numeric_limits<double>::infinity()}}) {
    options_.bounds = {none};
    EXPECT_THROW(fit(sheet_, target_, {}, options_), std::invalid_argument);
  }
}

}  // namespace
}  // namespace hull::modelling
