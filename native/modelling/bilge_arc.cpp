// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/bilge_arc.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "surface/bicubic.h"

namespace hull {
namespace {

using Eigen::Vector2d;

constexpr int kFitSamples = 64, kFinalSamples = 1024;  // of each span
constexpr int kMostSteps = 4000;
// Of the deviation: how near to its proved lower bound the search ends.
constexpr double kGap = 2e-4;

// The control points as a linear function of the unknowns: points(x) = fixed + Σ x_i part_i. The
// second half is the mirror image of the first, so that only that is unknown.
class BilgeShape {
 public:
  BilgeShape(int count, double angle, BilgeBorders borders)
      : size_(count + 2),
        axis_(std::sin(0.5 * angle), -std::cos(0.5 * angle)),
        fixed_(size_, Vector2d(0.0, 0.0)) {
    put(0, {0.0, -1.0});
    if (borders == BilgeBorders::kWhereBest) add(0, {-1.0, 0.0}, 0.0);
    // Starting values: along the circle.
    const auto on_circle = [&](int i) {
      const double turn = angle * i / (size_ - 1);
      return Vector2d(std::sin(turn), -std::cos(turn));
    };
    put(1, {0.0, -1.0});
    add(1, {1.0, 0.0}, on_circle(1).x());
    for (int i = 2; i < (size_ + 1) / 2; ++i) {
      if (2 * i == size_ - 1) {
        add(i, axis_, 1.0);
      } else {
        add(i, {1.0, 0.0}, on_circle(i).x());
        add(i, {0.0, 1.0}, on_circle(i).y());
      }
    }
  }

  int size() const { return size_; }
  Eigen::Index unknowns() const { return static_cast<Eigen::Index>(parts_.size()); }
  const std::vector<Vector2d>& fixed() const { return fixed_; }
  const std::vector<std::vector<Vector2d>>& parts() const { return parts_; }
  Eigen::VectorXd start() const {
    return Eigen::Map<const Eigen::VectorXd>(start_.data(), unknowns());
  }

  std::vector<Vector2d> points(const Eigen::VectorXd& x) const {
    std::vector<Vector2d> result = fixed_;
    for (Eigen::Index i = 0; i < unknowns(); ++i) {
      for (int k = 0; k < size_; ++k) result[k] += x[i] * parts_[i][k];
    }
    return result;
  }

 private:
  Vector2d image(const Vector2d& p) const { return 2.0 * axis_.dot(p) * axis_ - p; }
  void put(int point, const Vector2d& at) {
    fixed_[point] = at;
    fixed_[size_ - 1 - point] = image(at);
  }
  void add(int point, const Vector2d& direction, double value) {
    std::vector<Vector2d> part(size_, Vector2d(0.0, 0.0));
    part[size_ - 1 - point] = image(direction);
    part[point] = direction;
    parts_.push_back(std::move(part));
    start_.push_back(value);
  }

  int size_;
  Vector2d axis_;  // of symmetry
  std::vector<Vector2d> fixed_;
  std::vector<std::vector<Vector2d>> parts_;
  std::vector<double> start_;
};

// Sums of four neighbouring control points of a span, with the reflected ones beyond the ends.
Vector2d spline(const std::vector<Vector2d>& points, int span, const Basis& basis) {
  const int last = static_cast<int>(points.size()) - 1;
  Vector2d sum(0.0, 0.0);
  for (int b = 0; b < 4; ++b) {
    const int i = span - 1 + b;
    const Vector2d p = i < 0      ? Vector2d(2.0 * points[0] - points[1])
                       : i > last ? Vector2d(2.0 * points[last] - points[last - 1])
                                  : points[i];
    sum += basis[b] * p;
  }
  return sum;
}

// Signed distance from the straight bottom, or from the circle, and its gradient.
double distance(const Vector2d& q) { return q.x() < 0.0 ? -q.y() - 1.0 : q.norm() - 1.0; }
Vector2d gradient(const Vector2d& q) {
  return q.x() < 0.0 ? Vector2d(0.0, -1.0) : Vector2d(q / q.norm());
}

// Calls visit(span, t) along the first half of the curve.
template <class Visit>
void for_half(int size, int samples, const Visit& visit) {
  const int spans = size - 1;
  for (int i = 0; 2 * i <= spans * samples; ++i) {
    const int span = std::min(i / samples, spans - 1);
    visit(span, static_cast<double>(i) / samples - span);
  }
}

// Curve points of the fit: a constant and one column for each unknown.
struct FitSamples {
  std::vector<Vector2d> fixed;
  std::vector<std::vector<Vector2d>> parts;  // by sample

  explicit FitSamples(const BilgeShape& shape) {
    for_half(shape.size(), kFitSamples, [&](int span, double t) {
      const Basis basis = cubic_basis(t);
      fixed.push_back(spline(shape.fixed(), span, basis));
      parts.emplace_back();
      for (const auto& part : shape.parts()) parts.back().push_back(spline(part, span, basis));
    });
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(fixed.size()); }
};

// Lawson's iteration: least squares, whose weights grow where the deviation is large. The weighted
// mean is a lower bound of the least largest deviation, for what is nearly linear.
Eigen::VectorXd minimax(const BilgeShape& shape) {
  const FitSamples samples(shape);
  const Eigen::Index n = samples.count(), m = shape.unknowns();
  Eigen::VectorXd x = shape.start(), best = x, e(n), weight = Eigen::VectorXd::Constant(n, 1.0 / n);
  Eigen::MatrixXd J(n, m);
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostSteps; ++step) {
    for (Eigen::Index i = 0; i < n; ++i) {
      Vector2d q = samples.fixed[i];
      for (Eigen::Index k = 0; k < m; ++k) q += x[k] * samples.parts[i][k];
      e[i] = distance(q);
      for (Eigen::Index k = 0; k < m; ++k) J(i, k) = gradient(q).dot(samples.parts[i][k]);
    }
    const double largest = e.cwiseAbs().maxCoeff();
    if (largest < least) {
      least = largest;
      best = x;
    }
    const double bound = std::sqrt(weight.dot(e.cwiseAbs2()));
    if (step > 10 && largest < (1.0 + kGap) * bound) break;
    // The first steps find the curve, with even weights; then these turn towards the largest.
    if (step > 10) {
      weight = weight.cwiseProduct(e.cwiseAbs());
      weight /= weight.sum();
    }
    const Eigen::VectorXd root = weight.cwiseSqrt();
    const Eigen::MatrixXd weighted = root.asDiagonal() * J;
    x -= weighted.colPivHouseholderQr().solve(root.cwiseProduct(e));
  }
  return best;
}

void measure(BilgeArc& arc) {
  arc.deviation = arc.greatest_curvature = 0.0;
  arc.least_curvature = std::numeric_limits<double>::infinity();
  const int size = static_cast<int>(arc.points.size());
  for_half(size, kFinalSamples, [&](int span, double t) {
    const Vector2d q = spline(arc.points, span, cubic_basis(t));
    const Vector2d d1 = spline(arc.points, span, cubic_basis_d1(t));
    const Vector2d d2 = spline(arc.points, span, cubic_basis_d2(t));
    const double curvature = (d1.x() * d2.y() - d1.y() * d2.x()) / std::pow(d1.norm(), 3);
    arc.deviation = std::max(arc.deviation, std::abs(distance(q)));
    arc.greatest_curvature = std::max(arc.greatest_curvature, curvature);
    if (4.0 * (span + t) >= size - 1) {
      arc.least_curvature = std::min(arc.least_curvature, curvature);
    }
  });
}

}  // namespace

BilgeArc bilge_arc(int count, double angle, BilgeBorders borders) {
  if (count < kFewestBilgePoints || count > kMostBilgePoints) {
    throw std::invalid_argument("A bilge takes " + std::to_string(kFewestBilgePoints) + " to " +
                                std::to_string(kMostBilgePoints) +
                                " control points between the borders of the flats, not " +
                                std::to_string(count) + ".");
  }
  constexpr double kDegree = std::numbers::pi / 180.0;
  if (!(angle >= 10.0 * kDegree && angle <= 170.0 * kDegree)) {
    throw std::invalid_argument(
        "The flat side must be turned from the flat bottom by 10 to 170 degrees, not " +
        std::to_string(angle / kDegree) + ".");
  }
  const BilgeShape shape(count, angle, borders);
  BilgeArc arc{shape.points(minimax(shape)), 0.0, 0.0, 0.0};
  measure(arc);
  return arc;
}

}  // namespace hull
