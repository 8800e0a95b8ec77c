// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/bspline_patch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace hull::conversion {
namespace {

constexpr unsigned kBsplinePatchSeed = 20260729;

std::mt19937 generator() {
  ::testing::Test::RecordProperty("seed", static_cast<int>(kBsplinePatchSeed));
  return std::mt19937(kBsplinePatchSeed);
}

BSplinePatch random_patch(std::mt19937& random, int degree_u, int degree_v, int count_u,
                          int count_v) {
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  BSplinePatch patch{degree_u,
                     degree_v,
                     open_uniform_knots(degree_u, count_u),
                     open_uniform_knots(degree_v, count_v),
                     count_u,
                     count_v,
                     {},
                     7};
  for (int i = 0; i < count_u * count_v; ++i) {
    patch.control_points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  }
  return patch;
}

TEST(OpenUniformKnots, AreClampedAndEquallySpaced) {
  EXPECT_EQ(open_uniform_knots(3, 4), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(open_uniform_knots(3, 6),
            (std::vector<double>{0, 0, 0, 0, 1.0 / 3, 2.0 / 3, 1, 1, 1, 1}));
  EXPECT_EQ(open_uniform_knots(1, 3), (std::vector<double>{0, 0, 0.5, 1, 1}));
}

TEST(BasisValues, AreAPartitionOfUnity) {
  for (int degree : {1, 2, 3, 5}) {
    for (int count : {degree + 1, degree + 2, degree + 5}) {
      const auto knots = open_uniform_knots(degree, count);
      for (double t : {0.0, 0.1, 0.25, 0.5, 0.77, 1.0}) {
        const BasisValues values = basis_values(knots, degree, t);
        EXPECT_GE(values.first, 0);
        EXPECT_LE(values.first + degree, count - 1);
        EXPECT_NEAR(values.rows.row(0).sum(), 1.0, 1e-15);
        EXPECT_GE(values.rows.row(0).minCoeff(), 0.0);
        EXPECT_NEAR(values.rows.row(1).sum(), 0.0, 1e-12);
        EXPECT_NEAR(values.rows.row(2).sum(), 0.0, 1e-11);
      }
    }
  }
}

// Greville points as control points make the identity map.
TEST(BSplinePatch, ReproducesLinearFunctions) {
  BSplinePatch patch{3, 2, open_uniform_knots(3, 6), open_uniform_knots(2, 5), 6, 5, {}, 0};
  const auto greville = [](const std::vector<double>& knots, int degree, int i) {
    double sum = 0.0;
    for (int k = 1; k <= degree; ++k) sum += knots[i + k];
    return sum / degree;
  };
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 5; ++j) {
      patch.control_points.emplace_back(greville(patch.knots_u, 3, i),
                                        greville(patch.knots_v, 2, j), 1.0);
    }
  }
  ASSERT_NO_THROW(patch.check());
  for (double u : {0.0, 0.3, 0.5, 2.0 / 3, 1.0}) {
    for (double v : {0.0, 0.2, 1.0 / 3, 0.9, 1.0}) {
      const surface::SurfaceJet d = patch.evaluate(u, v);
      EXPECT_LT((d.point - Vector3d(u, v, 1)).norm(), 1e-15);
      EXPECT_LT((d.du - Vector3d(1, 0, 0)).norm(), 1e-13);
      EXPECT_LT((d.dv - Vector3d(0, 1, 0)).norm(), 1e-13);
      EXPECT_LT(d.duu.norm() + d.duv.norm() + d.dvv.norm(), 1e-12);
    }
  }
}

TEST(BSplinePatch, OfFourPointsIsTheBezierPatch) {
  auto random = generator();
  const BSplinePatch patch = random_patch(random, 3, 3, 4, 4);
  for (double u : {0.0, 0.37, 1.0}) {
    for (double v : {0.0, 0.81, 1.0}) {
      const double bu[4] = {std::pow(1 - u, 3), 3 * u * std::pow(1 - u, 2), 3 * u * u * (1 - u),
                            u * u * u};
      const double bv[4] = {std::pow(1 - v, 3), 3 * v * std::pow(1 - v, 2), 3 * v * v * (1 - v),
                            v * v * v};
      Vector3d sum = Vector3d::Zero();
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) sum += bu[i] * bv[j] * patch.control_point(i, j);
      }
      EXPECT_LT((patch.position(u, v) - sum).norm(), 1e-15);
    }
  }
}

// Central differences of second order: with h = 1e-4 their error is about 1e-8 times the third
// derivative (at most a few hundred here) and rounding 1e-16 / 1e-4 or 1e-16 / 1e-8.
TEST(BSplinePatch, DerivativesAgreeWithFiniteDifferences) {
  auto random = generator();
  const BSplinePatch patch = random_patch(random, 3, 4, 6, 7);
  const double h = 1e-4;
  for (double u : {0.1, 0.4, 0.8}) {
    for (double v : {0.15, 0.45, 0.9}) {
      const surface::SurfaceJet d = patch.evaluate(u, v);
      const auto at = [&](double i, double j) { return patch.position(u + i * h, v + j * h); };
      EXPECT_LT((d.du - (at(1, 0) - at(-1, 0)) / (2 * h)).norm(), 1e-5);
      EXPECT_LT((d.dv - (at(0, 1) - at(0, -1)) / (2 * h)).norm(), 1e-5);
      EXPECT_LT((d.duu - (at(1, 0) - 2 * at(0, 0) + at(-1, 0)) / (h * h)).norm(), 1e-5);
      EXPECT_LT((d.dvv - (at(0, 1) - 2 * at(0, 0) + at(0, -1)) / (h * h)).norm(), 1e-4);
      EXPECT_LT((d.duv - (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * h * h)).norm(),
                1e-4);
    }
  }
}

TEST(BSplinePatch, SidesRunAroundItAndLieOnIt) {
  auto random = generator();
  const BSplinePatch patch = random_patch(random, 3, 2, 7, 4);
  const Eigen::Vector2d corners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int side = 0; side < 4; ++side) {
    const auto points = patch.side_points(side);
    const auto knots = patch.side_knots(side);
    const Eigen::Vector2d from = corners[side], to = corners[(side + 1) % 4];
    EXPECT_EQ(points.front(), patch.position(from.x(), from.y()));
    EXPECT_EQ(points.back(), patch.position(to.x(), to.y()));
    for (double t : {0.2, 0.6}) {
      const BasisValues values = basis_values(knots, patch.side_degree(side), t);
      Vector3d sum = Vector3d::Zero();
      for (int i = 0; i < values.rows.cols(); ++i) {
        sum += values.rows(0, i) * points[values.first + i];
      }
      const Eigen::Vector2d uv = from + t * (to - from);
      EXPECT_LT((patch.position(uv.x(), uv.y()) - sum).norm(), 1e-15) << "side " << side;
    }
  }
}

TEST(BSplinePatch, TransposedIsTheSameSurfaceTurnedOver) {
  auto random = generator();
  const BSplinePatch patch = random_patch(random, 3, 2, 5, 6);
  const BSplinePatch turned = patch.transposed();
  ASSERT_NO_THROW(turned.check());
  EXPECT_EQ(turned.cell, patch.cell);
  const surface::SurfaceJet a = patch.evaluate(0.3, 0.7), b = turned.evaluate(0.7, 0.3);
  EXPECT_LT((a.point - b.point).norm(), 1e-15);
  EXPECT_LT((a.du.cross(a.dv) + b.du.cross(b.dv)).norm(), 1e-12);
}

TEST(BSplinePatch, TurnedIsTheSameSurfaceWithItsSidesShifted) {
  auto random = generator();
  const BSplinePatch patch = random_patch(random, 3, 2, 6, 4);
  const BSplinePatch turned = patch.turned();
  ASSERT_NO_THROW(turned.check());
  EXPECT_EQ(turned.cell, patch.cell);
  const surface::SurfaceJet a = patch.evaluate(0.3, 0.7), b = turned.evaluate(0.7, 0.7);
  EXPECT_LT((a.point - b.point).norm(), 1e-15);
  EXPECT_LT((a.du.cross(a.dv) - b.du.cross(b.dv)).norm(), 1e-12);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(turned.side_points(k), patch.side_points((k + 1) % 4));
    EXPECT_LT(gap_between(turned.side_curve(k), patch.side_curve((k + 1) % 4)), 1e-14);
  }
}

TEST(BSplinePatch, ParametersOutsideAreTakenToTheEnds) {
  auto random = generator();
  const BSplinePatch patch = random_patch(random, 3, 3, 5, 5);
  EXPECT_EQ(patch.position(-0.5, 2.0), patch.position(0.0, 1.0));
}

TEST(BSplinePatch, CheckNamesTheCellAndTheFault) {
  auto random = generator();
  const BSplinePatch good = random_patch(random, 3, 3, 5, 5);
  ASSERT_NO_THROW(good.check());
  const auto message = [](const BSplinePatch& patch) -> std::string {
    try {
      patch.check();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  BSplinePatch bad = good;
  bad.control_points.pop_back();
  EXPECT_NE(message(bad).find("cell 7"), std::string::npos) << message(bad);
  EXPECT_NE(message(bad).find("24 control points given, 25 wanted"), std::string::npos);
  bad = good;
  bad.control_points[3].y() = std::nan("");
  EXPECT_NE(message(bad).find("not finite"), std::string::npos);
  bad = good;
  std::swap(bad.knots_u[4], bad.knots_u[5]);
  EXPECT_NE(message(bad).find("direction u"), std::string::npos);
  bad = good;
  bad.knots_v[4] = std::nan("");
  EXPECT_NE(message(bad).find("direction v"), std::string::npos);
  bad = good;
  bad.knots_v.push_back(1.0);
  EXPECT_NE(message(bad).find("10 knots given, 9 wanted"), std::string::npos);
  bad = good;
  bad.count_u = 3;
  EXPECT_NE(message(bad).find("too few"), std::string::npos);
}

}  // namespace
}  // namespace hull::conversion
