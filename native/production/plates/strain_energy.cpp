// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/strain_energy.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <cmath>

namespace hull::production {

using Eigen::Vector2d;

namespace {

constexpr int kMostIterations = 150;
// Steps below this part of the plate's size end the search.
constexpr double kSmallStep = 1e-11;
// So do steps that gain less than this part of the energy: stretches change by half of it.
constexpr double kSmallGain = 1e-9;

// Six points, exact for polynomials of degree 4 (Dunavant 1985); weights sum to ½.
struct PlateRule {
  std::array<Eigen::Vector3d, 6> at;
  std::array<double, 6> weights;
  PlateRule() {
    const double a = 0.445948490915965, b = 0.091576213509771;
    const double wa = 0.5 * 0.223381589678011, wb = 0.5 * 0.109951743655322;
    for (int k = 0; k < 3; ++k) {
      at[k] = Eigen::Vector3d::Constant(a);
      at[k][k] = 1.0 - 2.0 * a;
      at[3 + k] = Eigen::Vector3d::Constant(b);
      at[3 + k][k] = 1.0 - 2.0 * b;
      weights[k] = wa;
      weights[3 + k] = wb;
    }
  }
};

// A point at which the strain counts.
struct StrainPoint {
  int element;
  Eigen::Matrix<double, 6, 2> slopes;
  double weight;  // m²
};

// The rotation nearest to f; never a reflection, so that triangles turned over cost energy.
Eigen::Matrix2d nearest_turn(const Eigen::Matrix2d& f) {
  return Eigen::Rotation2Dd(std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1))).toRotationMatrix();
}

class Sheet {
 public:
  Sheet(const PlateMesh& mesh, double poisson) : mesh_(mesh), poisson_(poisson) {
    static const PlateRule rule;
    double area = 0.0;
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
      for (std::size_t k = 0; k < rule.at.size(); ++k) {
        const auto point =
            element_point(mesh.shell->surface, mesh.triangle(mesh.elements[e]), rule.at[k]);
        if (!point) continue;
        points_.push_back({e, point->slopes, rule.weights[k] * point->area});
        area += points_.back().weight;
      }
    }
    // Thin elements would be as stiff as they are thin, and hold what they were turned over by in
    // the start. They have next to no area: their neighbours are to decide.
    for (StrainPoint& point : points_) {
      const double thin = height_of(mesh, mesh.elements[point.element]) / thin_height(mesh, area);
      point.weight *= std::min(1.0, std::max(thin * thin, 1e-12));
    }
  }

  double energy(const std::vector<Vector2d>& nodes) const {
    double sum = 0.0;
    for (const StrainPoint& point : points_)
      sum += residuals(slopes(point, nodes), point.weight).squaredNorm();
    return sum;
  }

  // The step of Gauss and Newton; where the sheet lies as a whole does not change.
  std::vector<Vector2d> step(const std::vector<Vector2d>& nodes, double damping);

 private:
  using Slopes = Eigen::Matrix2d;
  Slopes slopes(const StrainPoint& point, const std::vector<Vector2d>& nodes) const {
    Slopes f = Slopes::Zero();
    const auto& numbers = mesh_.elements[point.element].nodes;
    for (int k = 0; k < 6; ++k) f += nodes[numbers[k]] * point.slopes.row(k);
    return f;
  }

  // Whose squares sum to the energy.
  Eigen::Vector3d weighted(double e11, double e22, double e12, double weight) const {
    return std::sqrt(weight) * Eigen::Vector3d(std::sqrt(1.0 - poisson_ * poisson_) * e22,
                                               e11 + poisson_ * e22,
                                               std::sqrt(2.0 * (1.0 - poisson_)) * e12);
  }
  Eigen::Vector3d residuals(const Slopes& f, double weight) const {
    const Slopes u = nearest_turn(f).transpose() * f;
    return weighted(u(0, 0) - 1.0, u(1, 1) - 1.0, u(0, 1), weight);
  }

  Eigen::Matrix<double, 3, 12> slopes_of_residuals(const StrainPoint& point, const Slopes& turned,
                                                   const Slopes& f) const;

  const PlateMesh& mesh_;
  double poisson_;
  std::vector<StrainPoint> points_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  bool analysed_ = false;
};

// U = RᵀF changes by G + dRᵀ F, G = RᵀdF: with the turning rate ω of R that keeps U symmetric, (G21
// - G12) / tr U, by ω U12 more in the first, less in the second stretch, and ω U22 more in the
// shear. Where a triangle is turned over or next to it R is held.
Eigen::Matrix<double, 3, 12> Sheet::slopes_of_residuals(const StrainPoint& point,
                                                        const Slopes& turned,
                                                        const Slopes& f) const {
  const Slopes u = turned.transpose() * f;
  const double trace = u.trace();
  Eigen::Matrix<double, 3, 12> jacobian;
  for (int k = 0; k < 6; ++k) {
    const double d1 = point.slopes(k, 0), d2 = point.slopes(k, 1);
    for (int c = 0; c < 2; ++c) {
      const double along = turned(c, 0), across = turned(c, 1);
      const double turning = trace > 0.5 ? (across * d1 - along * d2) / trace : 0.0;
      const double shear =
          trace > 0.5 ? along * d2 + turning * u(1, 1) : 0.5 * (along * d2 + across * d1);
      jacobian.col(2 * k + c) = weighted(along * d1 + turning * u(0, 1),
                                         across * d2 - turning * u(0, 1), shear, point.weight);
    }
  }
  return jacobian;
}

std::vector<Vector2d> Sheet::step(const std::vector<Vector2d>& nodes, double damping) {
  const int n = 2 * mesh_.node_count;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  Eigen::Matrix<double, 12, 12> matrix = Eigen::Matrix<double, 12, 12>::Zero();
  Eigen::Matrix<double, 12, 1> slope = Eigen::Matrix<double, 12, 1>::Zero();
  const auto flush = [&](int element) {
    const auto& numbers = mesh_.elements[element].nodes;
    for (int i = 0; i < 12; ++i) {
      const int row = 2 * numbers[i / 2] + i % 2;
      right[row] -= slope[i];
      for (int j = 0; j < 12; ++j) {
        const int column = 2 * numbers[j / 2] + j % 2;
        if (column <= row) entries.emplace_back(row, column, matrix(i, j));
      }
    }
    matrix.setZero();
    slope.setZero();
  };
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const StrainPoint& point = points_[p];
    const Slopes f = slopes(point, nodes), turned = nearest_turn(f);
    const Eigen::Vector3d r = residuals(f, point.weight);
    const Eigen::Matrix<double, 3, 12> jacobian = slopes_of_residuals(point, turned, f);
    matrix += jacobian.transpose() * jacobian;
    slope += jacobian.transpose() * r;
    if (p + 1 == points_.size() || points_[p + 1].element != point.element) flush(point.element);
  }
  double stiffness = 0.0;
  for (const auto& entry : entries) {
    if (entry.row() == entry.col()) stiffness += entry.value();
  }
  stiffness /= n;
  // Turning and shifting change no energy: a little stiffness everywhere settles them.
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, (damping + 1e-10) * stiffness);
  Eigen::SparseMatrix<double> whole(n, n);
  whole.setFromTriplets(entries.begin(), entries.end());
  if (!analysed_) solver_.analyzePattern(whole);
  analysed_ = true;
  solver_.factorize(whole);
  const Eigen::VectorXd solved = solver_.solve(right);
  std::vector<Vector2d> steps;
  for (int i = 0; i < mesh_.node_count; ++i) steps.emplace_back(solved[2 * i], solved[2 * i + 1]);
  return steps;
}

double largest(const std::vector<Vector2d>& steps) {
  double most = 0.0;
  for (const Vector2d& s : steps) most = std::max(most, s.norm());
  return most;
}

}  // namespace

LeastEnergy least_energy(const PlateMesh& mesh, std::vector<Vector2d> nodes, double poisson) {
  Sheet sheet(mesh, poisson);
  double size = 0.0;
  for (const Vector2d& p : nodes) size = std::max(size, (p - nodes.front()).norm());
  LeastEnergy found{std::move(nodes), 0.0, 0, false};
  found.energy = sheet.energy(found.nodes);
  double damping = 0.0;
  while (found.iterations < kMostIterations) {
    ++found.iterations;
    const std::vector<Vector2d> steps = sheet.step(found.nodes, damping);
    if (largest(steps) <= kSmallStep * size) {
      found.converged = true;
      break;
    }
    std::vector<Vector2d> tried = found.nodes;
    for (std::size_t i = 0; i < tried.size(); ++i) tried[i] += steps[i];
    const double energy = sheet.energy(tried);
    if (energy <= found.energy) {
      found.converged = found.energy - energy <= kSmallGain * found.energy;
      found.energy = energy;
      found.nodes = std::move(tried);
      damping *= 0.1;
      if (damping < 1e-8) damping = 0.0;
      if (found.converged) break;
    } else if (energy - found.energy <= kSmallGain * found.energy) {
      found.converged = true;
      break;
    } else {
      damping = std::max(10.0 * damping, 1e-4);
    }
  }
  return found;
}

Eigen::Matrix2d plane_slopes(const ElementPoint& point, const PlateMesh::Element& element,
                             const std::vector<Vector2d>& nodes) {
  Eigen::Matrix2d f = Eigen::Matrix2d::Zero();
  for (int k = 0; k < 6; ++k) f += nodes[element.nodes[k]] * point.slopes.row(k);
  return f;
}

}  // namespace hull::production
