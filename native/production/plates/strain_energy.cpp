// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/strain_energy.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace hull::production {

namespace {

constexpr int kOnPoint = SheetSplines::kOnPoint;
// Steps with turns held, which find the way from any start, before those of Gauss and Newton.
constexpr int kFirstSteps = 8, kMostIterations = 150;
// Strains in the mean that are none.
constexpr double kNoStrain = 1e-10;
// Steps that gain less than this part of the energy end the search: stretches change by half of it.
constexpr double kSmallGain = 1e-10;
// Of third differences of coefficients, beside energies of about 1 times their squares: where next
// to nothing of a function lies on the plate, its neighbours say how it goes on.
constexpr double kGoingOn = 1e-7;

using Functions = std::array<int, kOnPoint>;
using Jacobian = Eigen::Matrix<double, 3, 2 * kOnPoint>;
using SquareOfPoint = Eigen::Matrix<double, 2 * kOnPoint, 2 * kOnPoint>;

// A point at which the strain counts.
struct StrainPoint {
  Functions functions;
  Eigen::Matrix<double, kOnPoint, 2> slopes;
  double weight;  // m²
};

// The rotation nearest to f; never a reflection, so that parts turned over cost energy.
Eigen::Matrix2d nearest_turn(const Eigen::Matrix2d& f) {
  return Eigen::Rotation2Dd(std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1))).toRotationMatrix();
}

class StrainedSheet {
 public:
  StrainedSheet(const SheetMap& map, const std::vector<PlatePoint>& points, double poisson)
      : splines_(map.splines), runs_(splines_.runs()), poisson_(poisson) {
    for (const PlatePoint& p : points) {
      const PlateChart::Value in_chart = map.chart.value(p.at);
      const SheetSplines::Values values = splines_.at(in_chart.at);
      points_.push_back({values.functions, values.slopes * (in_chart.slopes * p.tangents), p.area});
      area_ += p.area;
    }
    // Points of the same functions together: one block of the matrix for all of them.
    std::stable_sort(points_.begin(), points_.end(),
                     [](const auto& a, const auto& b) { return a.functions < b.functions; });
  }

  double area() const { return area_; }

  double energy(const std::vector<Vector2d>& c) const {
    double sum = 0.0;
    for (const StrainPoint& point : points_)
      sum += residuals(slopes(point, c), point.weight).squaredNorm();
    for (const auto& run : runs_) sum += kGoingOn * third_difference(run, c).squaredNorm();
    return sum;
  }

  // The coefficients of the least energy with the turns as they are, and without Poisson's ratio.
  std::vector<Vector2d> with_turns_held(const std::vector<Vector2d>& c);
  // The step of Gauss and Newton; where the sheet lies as a whole does not change.
  std::vector<Vector2d> step(const std::vector<Vector2d>& c, double damping);

 private:
  using Slopes = Eigen::Matrix2d;
  using Matrix = Eigen::SparseMatrix<double>;
  static constexpr std::array<double, 4> kThird{-1.0, 3.0, -3.0, 1.0};

  static Vector2d third_difference(const std::array<int, 4>& run, const std::vector<Vector2d>& c) {
    Vector2d sum = Vector2d::Zero();
    for (int k = 0; k < 4; ++k) sum += kThird[k] * c[run[k]];
    return sum;
  }
  static Slopes slopes(const StrainPoint& point, const std::vector<Vector2d>& c) {
    Slopes f = Slopes::Zero();
    for (int k = 0; k < kOnPoint; ++k) f += c[point.functions[k]] * point.slopes.row(k);
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
  Jacobian slopes_of_residuals(const StrainPoint& point, const Slopes& turned,
                               const Slopes& f) const;

  const SheetSplines& splines_;
  std::vector<std::array<int, 4>> runs_;
  double poisson_;
  double area_ = 0.0;
  std::vector<StrainPoint> points_;
  Eigen::SimplicialLDLT<Matrix> solver_, held_;
  bool analysed_ = false, held_made_ = false;
};

std::vector<Vector2d> StrainedSheet::with_turns_held(const std::vector<Vector2d>& c) {
  const int n = splines_.count();
  if (!held_made_) {
    std::vector<Eigen::Triplet<double>> entries;
    using Block = Eigen::Matrix<double, kOnPoint, kOnPoint>;
    Block block = Block::Zero();
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const Functions& numbers = points_[p].functions;
      block.noalias() += points_[p].weight * points_[p].slopes * points_[p].slopes.transpose();
      if (p + 1 < points_.size() && points_[p + 1].functions == numbers) continue;
      for (int i = 0; i < kOnPoint; ++i) {
        for (int j = 0; j < kOnPoint; ++j) {
          if (numbers[j] <= numbers[i]) entries.emplace_back(numbers[i], numbers[j], block(i, j));
        }
      }
      block.setZero();
    }
    for (const auto& run : runs_) {
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
          if (run[j] <= run[i])
            entries.emplace_back(run[i], run[j], kGoingOn * kThird[i] * kThird[j]);
        }
      }
    }
    entries.emplace_back(0, 0, 1.0);  // where it lies means nothing
    Matrix whole(n, n);
    whole.setFromTriplets(entries.begin(), entries.end());
    held_.compute(whole);
    held_made_ = true;
  }
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n, 2);
  right.row(0) = c[0].transpose();
  for (const StrainPoint& p : points_) {
    const Eigen::Matrix<double, kOnPoint, 2> wanted =
        p.weight * p.slopes * nearest_turn(slopes(p, c)).transpose();
    for (int i = 0; i < kOnPoint; ++i) right.row(p.functions[i]) += wanted.row(i);
  }
  const Eigen::MatrixX2d solved = held_.solve(right);
  std::vector<Vector2d> result;
  for (int i = 0; i < n; ++i) result.emplace_back(solved(i, 0), solved(i, 1));
  return result;
}

// U = RᵀF changes by G + dRᵀ F, G = RᵀdF: with the turning rate ω of R that keeps U symmetric, (G21
// - G12) / tr U, by ω U12 more in the first, less in the second stretch, and ω U22 more in the
// shear. Where a triangle is turned over or next to it R is held.
Jacobian StrainedSheet::slopes_of_residuals(const StrainPoint& point, const Slopes& turned,
                                            const Slopes& f) const {
  const Slopes u = turned.transpose() * f;
  const double trace = u.trace();
  Jacobian jacobian;
  for (int k = 0; k < kOnPoint; ++k) {
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

std::vector<Vector2d> StrainedSheet::step(const std::vector<Vector2d>& c, double damping) {
  const int n = 2 * splines_.count();
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  SquareOfPoint matrix = SquareOfPoint::Zero();
  Eigen::Matrix<double, 2 * kOnPoint, 1> slope = Eigen::Matrix<double, 2 * kOnPoint, 1>::Zero();
  const auto flush = [&](const Functions& numbers) {
    for (int i = 0; i < 2 * kOnPoint; ++i) {
      const int row = 2 * numbers[i / 2] + i % 2;
      right[row] -= slope[i];
      for (int j = 0; j < 2 * kOnPoint; ++j) {
        const int column = 2 * numbers[j / 2] + j % 2;
        if (column <= row) entries.emplace_back(row, column, matrix(i, j));
      }
    }
    matrix.setZero();
    slope.setZero();
  };
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const StrainPoint& point = points_[p];
    const Slopes f = slopes(point, c), turned = nearest_turn(f);
    const Jacobian jacobian = slopes_of_residuals(point, turned, f);
    matrix.noalias() += jacobian.transpose() * jacobian;
    slope += jacobian.transpose() * residuals(f, point.weight);
    if (p + 1 == points_.size() || points_[p + 1].functions != point.functions)
      flush(point.functions);
  }
  double stiffness = 0.0;
  for (const auto& entry : entries) {
    if (entry.row() == entry.col()) stiffness += entry.value();
  }
  stiffness /= n;
  for (const auto& run : runs_) {
    const Vector2d difference = third_difference(run, c);
    for (int i = 0; i < 4; ++i) {
      for (int d = 0; d < 2; ++d) {
        right[2 * run[i] + d] -= kGoingOn * kThird[i] * difference[d];
        for (int j = 0; j < 4; ++j) {
          if (run[j] <= run[i])
            entries.emplace_back(2 * run[i] + d, 2 * run[j] + d, kGoingOn * kThird[i] * kThird[j]);
        }
      }
    }
  }
  // Turning and shifting change no energy: a little stiffness everywhere settles them.
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, (damping + 1e-10) * stiffness);
  Matrix whole(n, n);
  whole.setFromTriplets(entries.begin(), entries.end());
  if (!analysed_) solver_.analyzePattern(whole);
  analysed_ = true;
  solver_.factorize(whole);
  const Eigen::VectorXd solved = solver_.solve(right);
  std::vector<Vector2d> steps;
  for (int i = 0; i < n; i += 2) steps.emplace_back(solved[i], solved[i + 1]);
  return steps;
}

}  // namespace

Vector2d SheetMap::place(const Vector3d& point) const {
  const SheetSplines::Values at = splines.at(chart.value(point).at);
  Vector2d sum = Vector2d::Zero();
  for (int k = 0; k < kOnPoint; ++k) {
    if (at.functions[k] >= 0) sum += at.values[k] * coefficients[at.functions[k]];
  }
  return sum;
}

Eigen::Matrix2d SheetMap::slopes(const PlatePoint& point) const {
  const PlateChart::Value in_chart = chart.value(point.at);
  const SheetSplines::Values at = splines.at(in_chart.at);
  Eigen::Matrix2d f = Eigen::Matrix2d::Zero();
  for (int k = 0; k < kOnPoint; ++k) {
    if (at.functions[k] >= 0) f += coefficients[at.functions[k]] * at.slopes.row(k);
  }
  return f * (in_chart.slopes * point.tangents);
}

LeastEnergy make_energy_least(SheetMap& map, const std::vector<PlatePoint>& points, double poisson,
                              bool is_near) {
  StrainedSheet sheet(map, points, poisson);
  for (int i = 0; i < (is_near ? 0 : kFirstSteps); ++i)
    map.coefficients = sheet.with_turns_held(map.coefficients);
  LeastEnergy found;
  found.energy = sheet.energy(map.coefficients);
  double damping = 0.0;
  const double none = kNoStrain * kNoStrain * sheet.area();
  while (found.iterations < kMostIterations && !found.converged) {
    ++found.iterations;
    const std::vector<Vector2d> steps = sheet.step(map.coefficients, damping);
    std::vector<Vector2d> tried = map.coefficients;
    for (std::size_t i = 0; i < tried.size(); ++i) tried[i] += steps[i];
    const double energy = sheet.energy(tried), change = std::abs(energy - found.energy);
    found.converged = change <= kSmallGain * found.energy + none;
    if (energy <= found.energy) {
      found.energy = energy;
      map.coefficients = std::move(tried);
      damping = damping < 1e-8 ? 0.0 : 0.1 * damping;
    } else {
      damping = std::max(10.0 * damping, 1e-4);
    }
  }
  return found;
}

}  // namespace hull::production
