// SPDX-License-Identifier: GPL-3.0-or-later
// The strain of a sheet laid flat: its energy, and the equations of the steps that lessen it.
#pragma once

#include <Eigen/SparseCholesky>
#include <array>
#include <vector>

#include "production/plates/plate_chart.h"
#include "production/plates/plate_mesh.h"
#include "production/plates/sheet_splines.h"

namespace hull::production {

class StrainedSheet {
 public:
  // points: the quadrature's, at which the strain counts.
  StrainedSheet(const PlateChart& chart, const SheetSplines& splines,
                const std::vector<PlatePoint>& points, double poisson);

  double area() const { return area_; }
  // m²; of coefficients of the splines, as all below.
  double energy(const std::vector<Vector2d>& c) const;

  // The coefficients of the least energy with the turns as they are, and without Poisson's ratio.
  std::vector<Vector2d> with_turns_held(const std::vector<Vector2d>& c);
  // Minus half the slopes of the energy by the coefficients' components.
  Eigen::VectorXd downhill(const std::vector<Vector2d>& c) const;
  // The matrix of Gauss's and Newton's method; where the sheet lies as a whole does not change.
  void set_matrix(const std::vector<Vector2d>& c, double damping);
  Eigen::VectorXd step(const Eigen::VectorXd& downhill) const { return solver_.solve(downhill); }

 private:
  static constexpr int kOnPoint = SheetSplines::kOnPoint;
  using Functions = std::array<int, kOnPoint>;
  using Matrix = Eigen::SparseMatrix<double>;
  // A point at which the strain counts.
  struct Point {
    Functions functions;
    Eigen::Matrix<double, kOnPoint, 2> slopes;
    double weight;  // m²
  };
  // Of the residuals by the map's derivatives F: by F11, F21, F12 and F22.
  using ByDerivatives = Eigen::Matrix<double, 3, 4>;
  // Of the residuals by the coefficients of a point's functions, x and y in turn.
  using Jacobian = Eigen::Matrix<double, 3, 2 * kOnPoint>;
  class SquareSum;

  static Eigen::Matrix2d derivatives(const Point& point, const std::vector<Vector2d>& c);
  Eigen::Vector3d weighted(double e11, double e22, double e12, double weight) const;
  Eigen::Vector3d residuals(const Eigen::Matrix2d& f, double weight) const;
  ByDerivatives by_derivatives(const Eigen::Matrix2d& f, double weight) const;
  Jacobian jacobian(const Point& point, const std::vector<Vector2d>& c) const;
  void hold_turns();

  std::vector<std::array<int, 4>> runs_;
  double poisson_;
  double area_ = 0.0;
  int count_;
  std::vector<Point> points_;
  Eigen::SimplicialLDLT<Matrix> solver_, held_;
  bool analysed_ = false, held_made_ = false;
};

}  // namespace hull::production
