// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/bilge_arc.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "analysis/arithmetic/degree.h"
#include "mesh/dense_solvers.h"
#include "surface/pieces/bicubic.h"

namespace hull::modelling {
namespace {

constexpr int kFitSamples = 64, kFinalSamples = 1024;  // of each span
constexpr int kMostSteps = 4000;
constexpr int kEvenSteps = 10;
// Of the deviation: how near to its proved lower bound the search ends.
constexpr double kGap = 2e-4;
constexpr double kNearestOuter = 0.05;

// The control points as a linear function of the unknowns: points(x) = fixed + Σ x_i part_i. The
// first and the last are those beyond the borders: reflected where the border is a crease.
class BilgeShape {
 public:
  BilgeShape(int count, double angle, const BilgeBorder& bottom, const BilgeBorder& side)
      : size_(count + 4), fixed_(zeros()) {
    const auto on_circle = [&](int i) {
      const double turn = angle * i / (count + 1);
      return Vector2d(std::sin(turn), -std::cos(turn));
    };
    // The side's end is the image of the bottom's in the bisector of the angle: both are laid out
    // by the same lines.
    const Vector2d axis(std::sin(0.5 * angle), -std::cos(0.5 * angle));
    const double first = on_circle(1).x();
    place_end(bottom, 0, 1, first, [](const Vector2d& p) { return p; });
    place_end(side, size_ - 1, -1, first,
              [&](const Vector2d& p) { return Vector2d(2.0 * axis.dot(p) * axis - p); });
    for (int i = 2; i < count; ++i) {
      add({{i + 1, {1.0, 0.0}}}, on_circle(i).x());
      add({{i + 1, {0.0, 1.0}}}, on_circle(i).y());
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
  struct Share {
    int point;
    Vector2d direction;
  };

  std::vector<Vector2d> zeros() const { return std::vector<Vector2d>(size_, Vector2d(0.0, 0.0)); }

  // The point beyond the border, the border and the point after it, all three in the flat, numbered
  // onwards from `outer`. `frame` takes the bottom to the flat.
  template <class Frame>
  void place_end(const BilgeBorder& border, int outer, int step, double first, const Frame& frame) {
    const int at = outer + step, next = at + step;
    const Vector2d along = frame({1.0, 0.0});
    for (int point : {outer, at, next}) fixed_[point] = frame({0.0, -1.0});
    if (border.kind == BilgeBorder::Kind::kSmooth) {
      // The surface goes on smoothly: the border's control point is free along the flat, and the
      // one beyond it is given, away from the bilge.
      fixed_[outer] -= border.outer * along;
      add({{at, along}}, std::min(0.25 * (border.outer - first), 0.2 * first));
      add({{next, along}}, first);
      return;
    }
    // A crease ends the cubic in its own point, as if the point beyond were 2 border - next: it
    // moves against the next one, and twice as far as the border.
    if (border.kind == BilgeBorder::Kind::kBest) add({{outer, 2.0 * along}, {at, along}}, 0.0);
    add({{outer, -along}, {next, along}}, first);
  }

  void add(std::initializer_list<Share> shares, double value) {
    parts_.push_back(zeros());
    for (const Share& share : shares) parts_.back()[share.point] = share.direction;
    start_.push_back(value);
  }

  int size_;
  std::vector<Vector2d> fixed_;
  std::vector<std::vector<Vector2d>> parts_;
  std::vector<double> start_;
};

// Flats and circle as the section is to be.
class RoundedCorner {
 public:
  explicit RoundedCorner(double angle) : angle_(angle), side_(std::sin(angle), -std::cos(angle)) {}

  // Signed distance, positive outside, and its gradient.
  double distance(const Vector2d& q) const { return gradient(q).dot(q) - 1.0; }
  Vector2d gradient(const Vector2d& q) const {
    const double turn = std::atan2(q.x(), -q.y());
    // Far along the side's flat the turn is beyond 180 degrees, and so below zero: the bottom ends
    // opposite to the bisector of the angle.
    const bool is_beyond = turn < 0.5 * angle_ - std::numbers::pi;
    if (turn < 0.0 && !is_beyond) return {0.0, -1.0};
    return is_beyond || turn > angle_ ? side_ : Vector2d(q / q.norm());
  }

 private:
  double angle_;
  Vector2d side_;
};

Vector2d spline(const std::vector<Vector2d>& points, int span, const surface::Basis& basis) {
  Vector2d sum(0.0, 0.0);
  for (int b = 0; b < 4; ++b) sum += basis[b] * points[span + b];
  return sum;
}

// Calls visit(span, t) along the curve between the borders.
template <class Visit>
void for_curve(int size, int samples, const Visit& visit) {
  const int spans = size - 3;
  for (int i = 0; i <= spans * samples; ++i) {
    // The last place is the end of the last span, not the start of one more.
    const int span = std::min(i / samples, spans - 1);
    visit(span, static_cast<double>(i) / samples - span);
  }
}

// Curve points of the fit: a constant and one part for each unknown.
struct FitSamples {
  std::vector<Vector2d> fixed;
  std::vector<std::vector<Vector2d>> parts;  // by sample

  explicit FitSamples(const BilgeShape& shape) {
    for_curve(shape.size(), kFitSamples, [&](int span, double t) {
      const surface::Basis basis = surface::cubic_basis(t);
      fixed.push_back(spline(shape.fixed(), span, basis));
      parts.emplace_back();
      for (const auto& part : shape.parts()) parts.back().push_back(spline(part, span, basis));
    });
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(fixed.size()); }
};

// Lawson's iteration (1961): least squares, whose weights grow where the deviation is large. The
// weighted mean is a lower bound of the least largest deviation, for what is nearly linear.
Eigen::VectorXd minimax(const BilgeShape& shape, const RoundedCorner& wanted) {
  const FitSamples samples(shape);
  const Eigen::Index n = samples.count(), m = shape.unknowns();
  Eigen::VectorXd x = shape.start(), best = x, e(n);
  Eigen::VectorXd weight = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
  Eigen::MatrixXd J(n, m);
  double least = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostSteps; ++step) {
    for (Eigen::Index i = 0; i < n; ++i) {
      Vector2d q = samples.fixed[i];
      for (Eigen::Index k = 0; k < m; ++k) q += x[k] * samples.parts[i][k];
      // Gauss and Newton: the distance is taken as straight across flats and circle at each point.
      const Vector2d gradient = wanted.gradient(q);
      e[i] = wanted.distance(q);
      for (Eigen::Index k = 0; k < m; ++k) J(i, k) = gradient.dot(samples.parts[i][k]);
    }
    const double largest = e.cwiseAbs().maxCoeff();
    if (largest < least) {
      least = largest;
      best = x;
    }
    const double bound = std::sqrt(weight.dot(e.cwiseAbs2()));
    // The first steps find the curve, with even weights; then these turn towards the largest.
    if (step > kEvenSteps) {
      if (largest < (1.0 + kGap) * bound) break;
      weight = weight.cwiseProduct(e.cwiseAbs());
      weight /= weight.sum();
    }
    const Eigen::VectorXd root = weight.cwiseSqrt();
    const Eigen::MatrixXd weighted = root.asDiagonal() * J;
    // Roots of the weights, as the solution takes squares of its rows.
    x -= mesh::least_norm_solution(weighted, root.cwiseProduct(e));
  }
  return best;
}

// `points`: with those beyond the borders.
BilgeArc measured(const std::vector<Vector2d>& points, const RoundedCorner& wanted) {
  BilgeArc arc{
      {points.begin() + 1, points.end() - 1}, 0.0, std::numeric_limits<double>::infinity(), 0.0};
  const int size = static_cast<int>(points.size()), spans = size - 3;
  for_curve(size, kFinalSamples, [&](int span, double t) {
    const Vector2d q = spline(points, span, surface::cubic_basis(t));
    const Vector2d d1 = spline(points, span, surface::cubic_basis_d1(t));
    const Vector2d d2 = spline(points, span, surface::cubic_basis_d2(t));
    const double curvature = cross(d1, d2) / std::pow(d1.norm(), 3);
    arc.deviation = std::max(arc.deviation, std::abs(wanted.distance(q)));
    arc.greatest_curvature = std::max(arc.greatest_curvature, curvature);
    if (std::abs(span + t - 0.5 * spans) <= 0.25 * spans) {
      arc.least_curvature = std::min(arc.least_curvature, curvature);
    }
  });
  return arc;
}

void check(const BilgeBorder& border) {
  if (border.kind != BilgeBorder::Kind::kSmooth || border.outer >= kNearestOuter) return;
  throw std::invalid_argument(
      "The flat beside the bilge is too short: beyond where the circle touches it, its next "
      "control point must be a twentieth of the radius away or more.");
}

// With outer points far away the best fit may run to and fro in the flat.
void check_order(const std::vector<Vector2d>& points) {
  const std::size_t n = points.size();
  const Vector2d first = points[2] - points[1], last = points[n - 2] - points[n - 3];
  const bool is_straight =
      first.dot(points[2] - points[0]) > 0.0 && last.dot(points[n - 1] - points[n - 3]) > 0.0 &&
      first.dot(points[1] - points[0]) > 0.0 && last.dot(points[n - 1] - points[n - 2]) > 0.0;
  if (is_straight) return;
  throw std::invalid_argument(
      "The next control point of the flat beside the bilge is too far away: add one nearer, or "
      "make the border of the flat a crease.");
}

}  // namespace

BilgeArc bilge_arc(int count, double angle, const BilgeBorder& bottom, const BilgeBorder& side) {
  if (count < kFewestBilgePoints || count > kMostBilgePoints) {
    throw std::invalid_argument("A bilge takes " + std::to_string(kFewestBilgePoints) + " to " +
                                std::to_string(kMostBilgePoints) +
                                " control points between the borders of the flats, not " +
                                std::to_string(count) + ".");
  }
  if (!(angle >= 10.0 * analysis::kDegree && angle <= 170.0 * analysis::kDegree)) {
    throw std::invalid_argument(
        "The flat side must be turned from the flat bottom by 10 to 170 degrees, not " +
        std::to_string(angle / analysis::kDegree) + ".");
  }
  check(bottom);
  check(side);
  const BilgeShape shape(count, angle, bottom, side);
  const RoundedCorner wanted(angle);
  const std::vector<Vector2d> points = shape.points(minimax(shape, wanted));
  check_order(points);
  return measured(points, wanted);
}

}  // namespace hull::modelling
