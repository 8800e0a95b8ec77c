// SPDX-License-Identifier: GPL-3.0-or-later
// What fit() makes least, made least by another method: Ceres' BFGS on the cost as fit.h defines
// it, by public functions alone, with differences for the slope of the energy.
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "modelling/fit/fit.h"
#include "modelling/thin_plate.h"
#include "surface/pieces/point_weights.h"
#include "surface/queries/closest_point.h"
#include "test_meshes.h"

namespace hull::modelling {
namespace {

constexpr unsigned kSeed = 22112026;

class Cost : public ceres::FirstOrderFunction {
 public:
  Cost(const surface::LimitSurface& start, const std::vector<Vector3d>& targets,
       const FitOptions& options)
      : start_(start),
        targets_(targets),
        locked_(options.limits.limits.locked),
        stiffness_(std::pow(options.stiffness * start.mesh().size(), 2)) {}

  double at(const std::vector<Vector3d>& points) const {
    double cost = 0.0;
    Evaluate(points.front().data(), &cost, nullptr);
    return cost;
  }

  int NumParameters() const override { return static_cast<int>(3 * start_.mesh().points().size()); }

  bool Evaluate(const double* values, double* cost, double* slopes) const override {
    surface::LimitSurface surface = start_;
    surface.set_points(points(values));
    const std::vector<surface::ClosestPoint> feet =
        surface::closest_points(surface::SurfaceTree(surface), targets_);
    surface::PointWeights weights(surface);
    if (slopes) std::fill_n(slopes, NumParameters(), 0.0);
    *cost = energy(values);
    const double share = 1.0 / static_cast<double>(feet.size());
    for (std::size_t i = 0; i < feet.size(); ++i) {
      const Vector3d off = feet[i].point - targets_[i];
      *cost += share * off.squaredNorm();
      if (!slopes) continue;
      // The foot's own way along the surface costs nothing, to first order.
      for (const surface::PointWeight& one : weights.at(feet[i].cell, feet[i].u, feet[i].v)) {
        Eigen::Map<Vector3d>(slopes + 3 * one.point) += 2.0 * share * one.weight * off;
      }
    }
    if (!slopes) return true;
    add_energy_slopes(values, slopes);
    for (int point : locked_) std::fill_n(slopes + 3 * point, 3, 0.0);
    return true;
  }

 private:
  std::vector<Vector3d> points(const double* values) const {
    std::vector<Vector3d> points;
    for (int i = 0; i < NumParameters(); i += 3) points.emplace_back(values + i);
    return points;
  }

  double energy(const double* values) const {
    std::vector<Vector3d> moves = points(values);
    for (std::size_t i = 0; i < moves.size(); ++i) moves[i] -= start_.mesh().points()[i];
    return stiffness_ * thin_plate_energy(start_, pieces_, moves);
  }

  // A quadratic form: central differences of any step are exact.
  void add_energy_slopes(const double* values, double* slopes) const {
    std::vector<double> moved(values, values + NumParameters());
    for (int i = 0; i < NumParameters(); ++i) {
      moved[i] = values[i] + 1.0;
      const double above = energy(moved.data());
      moved[i] = values[i] - 1.0;
      slopes[i] += (above - energy(moved.data())) / 2.0;
      moved[i] = values[i];
    }
  }

  const surface::LimitSurface& start_;
  const std::vector<Vector3d>& targets_;
  const std::vector<int>& locked_;
  surface::PieceWeights pieces_{start_};
  double stiffness_;
};

std::vector<int> borders(const mesh::Topology& mesh) {
  std::vector<int> points;
  for (int h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.twin(h) < 0) points.push_back(mesh.origin(h));
  }
  return points;
}

double made_least(const Cost& cost, const std::vector<Vector3d>& from) {
  std::vector<double> values;
  for (const Vector3d& p : from) values.insert(values.end(), p.begin(), p.end());
  ceres::GradientProblemSolver::Options options;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  options.line_search_direction_type = ceres::BFGS;
  options.function_tolerance = 1e-12;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-14;
  ceres::GradientProblemSolver::Summary summary;
  ceres::GradientProblem problem(new Cost(cost));
  ceres::Solve(options, problem, values.data(), &summary);
  return summary.final_cost;
}

TEST(FitMinimum, NoOtherMethodFindsLess) {
  std::mt19937 random(kSeed);
  std::normal_distribution<double> noise(0.0, 0.01);
  mesh::MeshArrays mesh = testing::grid(5, 4);
  const surface::LimitSurface start{mesh::ControlMesh(mesh)};
  // A bulge that the sheet, its border locked, can't follow wholly.
  std::vector<Vector3d> targets;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 8; ++j) {
      const double x = 0.3 + 0.44 * i, y = 0.3 + 0.42 * j;
      targets.emplace_back(x, y, 0.05 * x * (5.0 - x) * y * (4.0 - y) + noise(random));
    }
  }
  FitOptions options;
  options.fairness = 0.0;
  options.stiffness = 0.01;
  options.limits.limits.locked = borders(start.mesh().topology());
  const Fit found = fit(start, {targets, {}, {}}, {}, options);
  EXPECT_TRUE(found.settled);

  const Cost cost(start, targets, options);
  const double here = cost.at(found.points);
  const double least = made_least(cost, start.mesh().points());
  EXPECT_LT(least, 0.3 * cost.at(start.mesh().points()));
  // Steps of fit() that gain less than 1e-7 of the cost end it.
  EXPECT_NEAR(here, least, 1e-6 * least);
}

}  // namespace
}  // namespace hull::modelling
