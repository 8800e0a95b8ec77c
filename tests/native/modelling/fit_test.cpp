// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "surface/creases/crease_curves.h"
#include "surface/queries/closest_point.h"
#include "test_meshes.h"

namespace hull::modelling {
namespace {

constexpr unsigned kFitSeed = 22112026;

std::vector<Vector3d> samples_of(const surface::LimitSurface& surface, int n) {
  std::vector<Vector3d> samples;
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        samples.push_back(
            surface.position(cell, static_cast<double>(i) / n, static_cast<double>(j) / n));
      }
    }
  }
  return samples;
}

std::vector<FitCurve> curves_of(const surface::LimitSurface& surface) {
  std::vector<FitCurve> curves;
  for (const surface::CreaseCurve& crease : surface::crease_curves(surface)) {
    FitCurve curve{{}, static_cast<int>(curves.size()), true};
    for (int i = 0; i <= 8 * crease.edge_count(); ++i) {
      curve.points.push_back(crease.evaluate(i / 8.0, 0).point);
    }
    curves.push_back(curve);
  }
  return curves;
}

surface::LimitSurface with_points(const surface::LimitSurface& surface,
                                  std::vector<Vector3d> points) {
  surface::LimitSurface other = surface;
  other.set_points(std::move(points));
  return other;
}

std::vector<Vector3d> shaken(const surface::LimitSurface& surface, std::mt19937& random,
                             double by) {
  std::normal_distribution<double> normal;
  std::vector<Vector3d> points = surface.mesh().points();
  for (auto& p : points) {
    p += by * Vector3d(normal(random), normal(random), normal(random)).normalized();
  }
  return points;
}

// A bulging sheet with a crease along it that fades out.
surface::LimitSurface sheet() {
  mesh::MeshArrays mesh = testing::grid(7, 6);
  for (auto& p : mesh.points) {
    p.z() = 0.08 * p.x() * (7.0 - p.x()) + 0.3 * std::abs(p.y() - 3.0) * (p.x() < 4.5 ? 1.0 : 0.3);
  }
  for (int i = 0; i < 4; ++i) mesh.creases.push_back({3 * 8 + i, 3 * 8 + i + 1});
  return surface::LimitSurface{mesh::ControlMesh(mesh)};
}

double farthest(const surface::LimitSurface& surface, const std::vector<Vector3d>& points) {
  double farthest = 0.0;
  for (const surface::ClosestPoint& at :
       surface::closest_points(surface::SurfaceTree(surface), points)) {
    farthest = std::max(farthest, at.distance);
  }
  return farthest;
}

TEST(Fit, FindsASurfaceAgain) {
  SCOPED_TRACE(::testing::Message() << "seed " << kFitSeed);
  std::mt19937 random(kFitSeed);
  const surface::LimitSurface surface = sheet();
  const FitTarget target{samples_of(surface, 5), {}, {}};
  const std::vector<FitCurve> curves = curves_of(surface);
  for (int trial = 0; trial < 5; ++trial) {
    const surface::LimitSurface start = with_points(surface, shaken(surface, random, 0.1));
    FitOptions options;
    options.fairness = 0.0;
    options.most_steps = 100;
    const Fit found = fit(start, target, curves, options);
    EXPECT_LT(found.rms, 1e-9);
    EXPECT_LT(found.curve_largest, 1e-8);
    const surface::LimitSurface back = with_points(surface, found.points);
    EXPECT_LT(farthest(back, samples_of(surface, 9)), 1e-7);
    EXPECT_LT(farthest(surface, samples_of(back, 9)), 1e-7);
  }
}

TEST(Fit, StaysWithinLimits) {
  std::mt19937 random(kFitSeed);
  const surface::LimitSurface surface = sheet();
  const surface::LimitSurface start = with_points(surface, shaken(surface, random, 0.2));
  FitOptions options;
  options.limits.limits.locked = {10, 11};
  const Vector3d across(0.0, 0.6, 0.8);
  options.limits.limits.held = {{20, across}, {21, across}, {21, Vector3d::UnitX()}};
  const Fit found = fit(start, {samples_of(surface, 4), {}, {}}, {}, options);
  const std::vector<Vector3d>& before = start.mesh().points();
  for (int point : {10, 11}) EXPECT_EQ(found.points[point], before[point]);
  for (int point : {20, 21}) {
    EXPECT_NEAR((found.points[point] - before[point]).dot(across), 0.0, 1e-14);
    EXPECT_GT((found.points[point] - before[point]).norm(), 1e-3);
  }
  EXPECT_EQ(found.points[21].x(), before[21].x());
}

// Targets beyond the border: they count for nothing, or draw the border out to them.
TEST(Fit, LeavesOutWhatLiesBeyondTheBorder) {
  const surface::LimitSurface flat{mesh::ControlMesh(testing::grid(4, 4))};
  std::vector<Vector3d> targets;
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j <= 40; ++j) targets.emplace_back(0.1 * i, 0.1 * j, 0.25);
  }
  FitOptions options;
  options.fairness = 1e-5;
  const Fit left = fit(flat, {targets, {}, {}}, {}, options);
  EXPECT_NEAR(left.counted, 41 * 41, 41);
  EXPECT_LT(left.largest, 1e-5);
  for (const Vector3d& p : left.points) EXPECT_LT(p.x(), 4.05);
  options.draw_border = true;
  const Fit drawn = fit(flat, {targets, {}, {}}, {}, options);
  EXPECT_EQ(drawn.counted, 61 * 41);
  EXPECT_LT(drawn.rms, 2e-2);
  options.draw_border = false;
  options.reach = 0.1;
  EXPECT_THROW(fit(flat, {targets, {}, {}}, {}, options), std::invalid_argument);
}

TEST(Fit, DoesNotTakeTheOtherSide) {
  const surface::LimitSurface flat{mesh::ControlMesh(testing::grid(4, 4))};
  FitTarget target;
  for (int i = 1; i < 40; ++i) {
    for (int j = 1; j < 40; ++j) {
      for (double side : {1.0, -1.0}) {
        target.points.emplace_back(0.1 * i, 0.1 * j, 0.05 * side);
        target.normals.emplace_back(0.0, 0.0, side);
      }
    }
  }
  const Fit found = fit(flat, target, {});
  EXPECT_EQ(found.counted, 39 * 39);
  for (const Vector3d& p : found.points) EXPECT_NEAR(p.z(), 0.05, 1e-3);
}

// A line without a chain is taken for the nearest crease of its direction; a line across for none.
TEST(Fit, DrawsCreasesToLines) {
  const surface::LimitSurface surface = sheet();
  FitCurve line{{}, FitCurve::kNearest, false}, across{{}, FitCurve::kNearest, false};
  for (int i = 5; i <= 30; ++i) {
    line.points.emplace_back(0.1 * i, 3.2, 0.08 * 0.1 * i * (7.0 - 0.1 * i));
    across.points.emplace_back(2.0, 3.0, 0.1 * i);
  }
  FitOptions options;
  options.reach = 1.5;
  options.stiffness = 1e-4;
  const Fit found = fit(surface, {samples_of(surface, 3), {}, {}}, {line, across}, options);
  double largest = 0.0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    largest = std::max(largest, found.curve_distances[i]);
    EXPECT_TRUE(std::isnan(found.curve_distances[line.points.size() + i]));
  }
  EXPECT_LT(largest, 0.06);
}

TEST(Fit, BringsPlacesOntoTheShape) {
  const surface::LimitSurface surface(mesh::ControlMesh(testing::grid(6, 4)));
  std::vector<Vector3d> raised = surface.mesh().points();
  for (Vector3d& p : raised) p.z() += 0.5;
  const surface::LimitSurface shape = with_points(surface, raised);
  // Targets on the one half of the shape only.
  FitTarget target;
  for (const Vector3d& p : samples_of(shape, 3)) {
    if (p.x() <= 3.0) target.points.push_back(p);
  }
  const auto largest_off = [&] {
    FitOptions options;
    options.fairness = 0.0;
    double most = 0.0;
    for (const Vector3d& p : fit(surface, target, {}, options).points) {
      most = std::max(most, std::abs(p.z() - 0.5));
    }
    return most;
  };
  EXPECT_GT(largest_off(), 0.1);
  target.shape = &shape;
  EXPECT_LT(largest_off(), 1e-9);
}

TEST(Fit, TellsItsProgressAndEndsByAnException) {
  const surface::LimitSurface surface = sheet();
  std::mt19937 random(kFitSeed);
  const surface::LimitSurface start = with_points(surface, shaken(surface, random, 0.1));
  std::vector<double> shares;
  FitOptions options;
  options.progress = [&](double share) { shares.push_back(share); };
  fit(start, {samples_of(surface, 3), {}, {}}, {}, options);
  ASSERT_GT(shares.size(), 2u);
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  options.progress = [](double share) {
    if (share > 0.0) throw std::runtime_error("enough");
  };
  EXPECT_THROW(fit(start, {samples_of(surface, 3), {}, {}}, {}, options), std::runtime_error);
}

TEST(Fit, NamesWhatIsWrong) {
  const surface::LimitSurface surface = sheet();
  const std::vector<Vector3d> one{{1.0, 1.0, 1.0}};
  const auto expect_wrong = [&](const FitTarget& target, const std::vector<FitCurve>& curves,
                                const FitOptions& options) {
    EXPECT_THROW(fit(surface, target, curves, options), std::invalid_argument);
  };
  expect_wrong({{{std::nan(""), 0.0, 0.0}}, {}, {}}, {}, {});
  expect_wrong({one, {Vector3d::UnitX(), Vector3d::UnitX()}, {}}, {}, {});
  expect_wrong({one, {}, {-1.0}}, {}, {});
  expect_wrong({one, {}, {}}, {{one, 0, true}}, {});
  expect_wrong({one, {}, {}}, {{{one[0], Vector3d::Zero()}, 99, true}}, {});
  FitOptions options;
  options.fairness = -1.0;
  expect_wrong({one, {}, {}}, {}, options);
  options = {};
  options.limits.limits.locked = {12345};
  expect_wrong({one, {}, {}}, {}, options);
}

}  // namespace
}  // namespace hull::modelling
