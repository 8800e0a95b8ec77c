// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/strained_sheet.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hull::production {

namespace {

// Of third differences of coefficients, beside energies of about 1 times their squares: where next
// to nothing of a function lies on the plate, its neighbours say how it goes on.
constexpr double kGoingOn = 1e-7;
constexpr std::array<double, 4> kThird{-1.0, 3.0, -3.0, 1.0};

Vector2d third_difference(const std::array<int, 4>& run, const std::vector<Vector2d>& c) {
  Vector2d sum = Vector2d::Zero();
  for (int k = 0; k < 4; ++k) sum += kThird[k] * c[run[k]];
  return sum;
}

// The rotation nearest to f; never a reflection, so that parts turned over cost energy.
Eigen::Matrix2d nearest_turn(const Eigen::Matrix2d& f) {
  // The polar decomposition in closed form: its angle's tangent is (F21 - F12) / (F11 + F22).
  const Vector2d at(f(0, 0) + f(1, 1), f(1, 0) - f(0, 1));
  const double length = at.norm();
  const Vector2d way = length > 0.0 ? Vector2d(at / length) : Vector2d::UnitX();
  return (Eigen::Matrix2d() << way.x(), -way.y(), way.y(), way.x()).finished();
}

}  // namespace

// The sum of JᵀJ over points with the same functions, a block of rows at a time.
class StrainedSheet::SquareSum {
 public:
  using Matrix = Eigen::Matrix<double, 2 * kOnPoint, 2 * kOnPoint>;

  void add(const Jacobian& jacobian) {
    rows_.middleRows<3>(count_) = jacobian;
    count_ += 3;
    if (count_ == rows_.rows()) flush();
  }
  // Its lower half; the next sum begins.
  Matrix take() {
    flush();
    const Matrix taken = sum_;
    sum_.setZero();
    return taken;
  }

 private:
  void flush() {
    sum_.selfadjointView<Eigen::Lower>().rankUpdate(rows_.topRows(count_).transpose());
    count_ = 0;
  }

  Matrix sum_ = Matrix::Zero();
  Eigen::Matrix<double, 96, 2 * kOnPoint> rows_;
  Eigen::Index count_ = 0;
};

StrainedSheet::StrainedSheet(const PlateChart& chart, const SheetSplines& splines,
                             const std::vector<PlatePoint>& points, double poisson)
    : runs_(splines.runs()), poisson_(poisson), count_(splines.count()) {
  std::vector<Point> found;
  for (const PlatePoint& p : points) {
    const PlateChart::Value in_chart = chart.value(p.at);
    const SheetSplines::Values values = splines.at(in_chart.at);
    // By the chain rule to derivatives by lengths on the surface.
    found.push_back({values.functions, values.slopes * (in_chart.slopes * p.tangents), p.area});
    area_ += p.area;
  }
  // Points of the same functions together: one block of the matrix for all of them.
  std::vector<int> order(found.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&found](int a, int b) { return found[a].functions < found[b].functions; });
  points_.reserve(found.size());
  for (const int i : order) points_.push_back(found[i]);
}

Eigen::Matrix2d StrainedSheet::derivatives(const Point& point, const std::vector<Vector2d>& c) {
  Eigen::Matrix2d f = Eigen::Matrix2d::Zero();
  // None is missing: SheetSplines::use() had all of these points.
  for (int k = 0; k < kOnPoint; ++k) f += c[point.functions[k]] * point.slopes.row(k);
  return f;
}

// Whose squares sum to the energy.
Eigen::Vector3d StrainedSheet::weighted(double e11, double e22, double e12, double weight) const {
  // The density is (ε1 + ν ε2)² + (1 - ν²) ε2² + 2 (1 - ν) ε12².
  return std::sqrt(weight) * Eigen::Vector3d(std::sqrt(1.0 - poisson_ * poisson_) * e22,
                                             e11 + poisson_ * e22,
                                             std::sqrt(2.0 * (1.0 - poisson_)) * e12);
}

Eigen::Vector3d StrainedSheet::residuals(const Eigen::Matrix2d& f, double weight) const {
  const Eigen::Matrix2d u = nearest_turn(f).transpose() * f;
  return weighted(u(0, 0) - 1.0, u(1, 1) - 1.0, u(0, 1), weight);
}

double StrainedSheet::energy(const std::vector<Vector2d>& c) const {
  double sum = 0.0;
  for (const Point& point : points_)
    sum += residuals(derivatives(point, c), point.weight).squaredNorm();
  for (const auto& run : runs_) sum += kGoingOn * third_difference(run, c).squaredNorm();
  return sum;
}

// U = RᵀF changes by G + dRᵀ F, G = RᵀdF: with the turning rate ω of R that keeps U symmetric, (G21
// - G12) / tr U, by ω U12 more in the first, less in the second stretch, and ω U22 more in the
// shear. Where a triangle is turned over or next to it R is held.
StrainedSheet::ByDerivatives StrainedSheet::by_derivatives(const Eigen::Matrix2d& f,
                                                           double weight) const {
  const Eigen::Matrix2d turned = nearest_turn(f), u = turned.transpose() * f;
  const double trace = u.trace();
  const bool turns = trace > 0.5;
  ByDerivatives by;
  for (int c = 0; c < 2; ++c) {
    const double along = turned(c, 0), across = turned(c, 1);
    const double first = turns ? across / trace : 0.0, second = turns ? -along / trace : 0.0;
    by.col(c) = weighted(along + first * u(0, 1), -first * u(0, 1),
                         turns ? first * u(1, 1) : 0.5 * across, weight);
    by.col(2 + c) = weighted(second * u(0, 1), across - second * u(0, 1),
                             turns ? along + second * u(1, 1) : 0.5 * along, weight);
  }
  return by;
}

StrainedSheet::Jacobian StrainedSheet::jacobian(const Point& point,
                                                const std::vector<Vector2d>& c) const {
  const ByDerivatives by = by_derivatives(derivatives(point, c), point.weight);
  Jacobian all;
  for (int k = 0; k < kOnPoint; ++k) {
    all.middleCols<2>(2 * k) = by.leftCols<2>() * point.slopes(k, 0);
    all.middleCols<2>(2 * k) += by.rightCols<2>() * point.slopes(k, 1);
  }
  return all;
}

void StrainedSheet::hold_turns() {
  // With turns held and without Poisson's ratio the energy is the sum of |F - R|²: x and y part,
  // and have one and the same matrix, which does not change from step to step.
  const int n = count_;
  std::vector<Eigen::Triplet<double>> entries;
  using Block = Eigen::Matrix<double, kOnPoint, kOnPoint>;
  Block block = Block::Zero();
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const Functions& numbers = points_[p].functions;
    block.noalias() += points_[p].weight * points_[p].slopes * points_[p].slopes.transpose();
    if (p + 1 < points_.size() && points_[p + 1].functions == numbers) continue;
    // The lower half, which is all that the solver reads.
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

std::vector<Vector2d> StrainedSheet::with_turns_held(const std::vector<Vector2d>& c) {
  // By turns the nearest rotations follow from the map, and the map from them: neither makes the
  // energy without Poisson's ratio larger.
  if (!held_made_) hold_turns();
  const int n = count_;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n, 2);
  right.row(0) = c[0].transpose();
  for (const Point& p : points_) {
    const Eigen::Matrix<double, kOnPoint, 2> wanted =
        p.weight * p.slopes * nearest_turn(derivatives(p, c)).transpose();
    for (int i = 0; i < kOnPoint; ++i) right.row(p.functions[i]) += wanted.row(i);
  }
  const Eigen::MatrixX2d solved = held_.solve(right);
  std::vector<Vector2d> result;
  for (int i = 0; i < n; ++i) result.emplace_back(solved(i, 0), solved(i, 1));
  return result;
}

Eigen::VectorXd StrainedSheet::downhill(const std::vector<Vector2d>& c) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(2 * count_);
  for (const Point& point : points_) {
    const Eigen::Matrix2d f = derivatives(point, c);
    const Eigen::Vector4d slope =
        by_derivatives(f, point.weight).transpose() * residuals(f, point.weight);
    for (int k = 0; k < kOnPoint; ++k) {
      // F11 and F21 go with a function's first slope, F12 and F22 with its second one.
      sum.segment<2>(2 * point.functions[k]) -=
          point.slopes(k, 0) * slope.head<2>() + point.slopes(k, 1) * slope.tail<2>();
    }
  }
  for (const auto& run : runs_) {
    const Vector2d difference = third_difference(run, c);
    for (int k = 0; k < 4; ++k) sum.segment<2>(2 * run[k]) -= kGoingOn * kThird[k] * difference;
  }
  return sum;
}

void StrainedSheet::set_matrix(const std::vector<Vector2d>& c, double damping) {
  const int n = 2 * count_;
  std::vector<Eigen::Triplet<double>> entries;
  double stiffness = 0.0;
  const auto add = [&](int i, int j, double value) {
    entries.emplace_back(std::max(i, j), std::min(i, j), value);
    if (i == j) stiffness += value / n;
  };
  SquareSum square;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const Point& point = points_[p];
    square.add(jacobian(point, c));
    if (p + 1 < points_.size() && points_[p + 1].functions == point.functions) continue;
    const SquareSum::Matrix block = square.take();
    const auto place = [&](int k) { return 2 * point.functions[k / 2] + k % 2; };
    for (int j = 0; j < 2 * kOnPoint; ++j) {
      for (int i = j; i < 2 * kOnPoint; ++i) add(place(i), place(j), block(i, j));
    }
  }
  // Turning and shifting change no energy: a little stiffness everywhere settles them.
  const double everywhere = (damping + 1e-10) * stiffness;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, everywhere);
  for (const auto& run : runs_) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j <= i; ++j) {
        const double value = kGoingOn * kThird[i] * kThird[j];
        for (int d = 0; d < 2; ++d) add(2 * run[i] + d, 2 * run[j] + d, value);
      }
    }
  }
  Matrix whole(n, n);
  whole.setFromTriplets(entries.begin(), entries.end());
  // Entries are where functions meet, for any coefficients: the order of elimination is found once.
  if (!analysed_) solver_.analyzePattern(whole);
  analysed_ = true;
  solver_.factorize(whole);
}

}  // namespace hull::production
