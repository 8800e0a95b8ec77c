// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/curves/nurbs_curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/arithmetic/spline_basis.h"
#include "network/curves/curve_pieces.h"

namespace hull::network {
namespace {

using Eigen::Index;

constexpr double kSmall = 1e-4;  // of a curve's size: pieces with one nearest point
constexpr int kMostSteps = 60;

}  // namespace

NurbsCurve::NurbsCurve(int degree, std::vector<double> knots, Points3 points,
                       Eigen::VectorXd weights)
    : degree_(degree),
      knots_(std::move(knots)),
      points_(std::move(points)),
      weights_(std::move(weights)) {
  if (weights_.size() == 0) weights_ = Eigen::VectorXd::Ones(points_.rows());
  const auto clamp = static_cast<std::size_t>(degree_) + 1;
  if (degree_ < 1 || points_.rows() < degree_ + 1 ||
      knots_.size() != static_cast<std::size_t>(points_.rows()) + clamp) {
    throw std::invalid_argument("A curve of degree " + std::to_string(degree_) + " with " +
                                std::to_string(points_.rows()) + " control points cannot have " +
                                std::to_string(knots_.size()) + " knots.");
  }
  // Sorting by < says nothing of NaN: numbers are looked at first.
  const auto is_number = [](double t) { return std::isfinite(t); };
  const bool is_clamped = knots_.front() == knots_[clamp - 1] &&
                          knots_.back() == knots_[knots_.size() - clamp] &&
                          knots_.front() < knots_.back();
  if (!std::ranges::all_of(knots_, is_number) || !std::ranges::is_sorted(knots_) || !is_clamped) {
    throw std::invalid_argument(
        "The knots of a curve must rise, and be there degree + 1 times at its ends.");
  }
  if (!points_.allFinite() || weights_.size() != points_.rows() || !weights_.allFinite() ||
      !(weights_.minCoeff() > 0.0)) {
    throw std::invalid_argument(
        "Control points of a curve must be places, each with a weight above zero.");
  }
}

// The derivatives of a quotient, from those of its numerator and denominator (Piegl and Tiller
// 1997, 4.3).
Points3 NurbsCurve::evaluate(double t, int order) const {
  const Index span = analysis::span_of(knots_, degree_, t);
  const auto points = points_.middleRows(span - degree_, degree_ + 1);
  const auto weights = weights_.segment(span - degree_, degree_ + 1);
  Points3 rows(order + 1, 3);
  Eigen::VectorXd below(order + 1);
  // A row is first the numerator's derivative A^(k); less binomial(k, i) w^(i) C^(k - i) for i from
  // 1 to k, with the denominator w, it is w C^(k).
  for (int k = 0; k <= order; ++k) {
    // A quotient goes on beyond the degree of its numerator and denominator.
    if (k > degree_) {
      rows.row(k).setZero();
      below[k] = 0.0;
    } else {
      const Eigen::VectorXd basis =
          analysis::basis_at(knots_, degree_, t, span, k).cwiseProduct(weights);
      rows.row(k) = basis.transpose() * points;
      below[k] = basis.sum();
    }
    double binomial = 1.0;
    for (int i = 1; i <= k; ++i) {
      binomial *= static_cast<double>(k - i + 1) / i;
      rows.row(k) -= binomial * below[i] * rows.row(k - i);
    }
    rows.row(k) /= below[0];
  }
  return rows;
}

NurbsCurve NurbsCurve::reversed() const {
  std::vector<double> knots;
  for (auto knot = knots_.rbegin(); knot != knots_.rend(); ++knot) {
    // Over the same parameters.
    knots.push_back(begin() + (end() - *knot));
  }
  return {degree_, std::move(knots), points_.colwise().reverse(), weights_.reverse()};
}

// Pieces that are further than a point that is known are left out, others halved.
double NurbsCurve::nearest_parameter(const Vector3d& place) const {
  double best = begin(), least = (point(best) - place).squaredNorm();
  const auto offer = [&](double t) {
    const double distance = (point(t) - place).squaredNorm();
    if (distance >= least) return;
    least = distance;
    best = t;
  };
  // With both ends, and the middle of all that is halved, the bound falls soon, and most pieces go.
  offer(end());
  std::vector<CurvePiece> pieces = pieces_of(*this);
  Eigen::AlignedBox3d around;
  for (const CurvePiece& piece : pieces) around.extend(piece.box());
  // An end by size: from the centre of an arc no piece is further than another, and none would go.
  const double small = kSmall * around.diagonal().norm();
  while (!pieces.empty()) {
    const CurvePiece piece = std::move(pieces.back());
    pieces.pop_back();
    const Eigen::AlignedBox3d box = piece.box();
    // The piece lies in the box of its control points, as their weights are positive.
    if (box.squaredExteriorDistance(place) > least) continue;
    const double middle = 0.5 * (piece.low + piece.high);
    if (box.diagonal().norm() > small && middle > piece.low && middle < piece.high) {
      offer(middle);
      pieces.resize(pieces.size() + 2);
      piece.split(pieces[pieces.size() - 1], pieces[pieces.size() - 2]);
    } else {
      offer(nearest_in(piece.low, piece.high, place));
    }
  }
  return best;
}

// Newton's method on half the squared distance's slope, with bisection where it leaves the interval
// in which the slope changes its sign; an end where it does not.
double NurbsCurve::nearest_in(double low, double high, const Vector3d& place) const {
  const auto slope_at = [&](double t, double* bend) {
    const Points3 jet = evaluate(t, 2);
    const Vector3d from = jet.row(0).transpose() - place;
    if (bend != nullptr) *bend = jet.row(1).squaredNorm() + from.dot(jet.row(2).transpose());
    return from.dot(jet.row(1).transpose());
  };
  if (slope_at(low, nullptr) >= 0.0) return low;
  // At the interval's upper end the span above would be asked: its slope is that of the point.
  if (slope_at(high, nullptr) <= 0.0) return high;
  double t = 0.5 * (low + high);
  for (int step = 0; step < kMostSteps; ++step) {
    double bend = 0.0;
    const double slope = slope_at(t, &bend);
    if (slope == 0.0) return t;
    (slope < 0.0 ? low : high) = t;
    // Where the slope falls Newton's step leads to a maximum: `low` is outside, so that it is
    // halved.
    double next = bend > 0.0 ? t - slope / bend : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == t || !(low < high)) return t;
    t = next;
  }
  return t;
}

}  // namespace hull::network
