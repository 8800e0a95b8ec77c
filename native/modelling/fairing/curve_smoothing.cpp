// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/curve_smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "analysis/arithmetic/spline_basis.h"
#include "modelling/fairing/banded_least_squares.h"
#include "modelling/fairing/spline_ends.h"

namespace hull::modelling {
namespace {

using analysis::basis_at;
using analysis::span_of;
using Eigen::Index;

constexpr int kGreatestDegree = 5;
constexpr double kMet = 1e-9;  // of S
constexpr int kMostSteps = 200;
// Exact interpolation leaves rounding: squared, of the sum of squared coordinates.
constexpr double kInterpolated = 1e-24;

// The data, checked, and all that is fitted to them.
class Smoothing {
 public:
  Smoothing(const Eigen::MatrixXd& points, double deviation, const SmoothingOptions& options);
  SmoothCurve run();

 private:
  void check(const SmoothingOptions& options) const;
  void take_parameters(const SmoothingOptions& options);
  Index count() const { return points_.rows(); }
  int order() const { return degree_ + 1; }
  SplineEnds ends(const std::vector<double>& knots) const { return {start_, end_, degree_, knots}; }

  // The spline on the knots: by least squares alone, or with Σ jump² / p added.
  void fit(double p);
  double error_of(std::vector<double>* of_points = nullptr) const;
  bool add_knot();
  bool has_points_enough(const std::vector<double>& knots) const;
  void take_knots_at_points();
  void interpolate();
  void find_p();

  const Eigen::MatrixXd& points_;
  std::vector<double> t_, weights_;
  CurveEnd start_, end_;
  int degree_;
  bool knots_at_points_;
  double wanted_ = 0.0;  // S
  std::vector<double> knots_;
  Eigen::MatrixXd coefficients_;
  double p_ = std::numeric_limits<double>::infinity();
};

Smoothing::Smoothing(const Eigen::MatrixXd& points, double deviation,
                     const SmoothingOptions& options)
    : points_(points),
      weights_(options.weights),
      start_(options.start),
      end_(options.end),
      degree_(options.degree),
      knots_at_points_(options.knots_at_points) {
  check(options);
  take_parameters(options);
  if (weights_.empty()) weights_.assign(static_cast<std::size_t>(count()), 1.0);
  for (double weight : weights_) wanted_ += weight;
  wanted_ *= deviation * deviation;
  if (!(deviation >= 0.0) || !std::isfinite(wanted_)) {
    throw std::invalid_argument("The mean deviation must not be negative, nor infinite.");
  }
  knots_.assign(static_cast<std::size_t>(order()), t_.front());
  knots_.insert(knots_.end(), static_cast<std::size_t>(order()), t_.back());
}

void Smoothing::check(const SmoothingOptions& options) const {
  if (degree_ < 1 || degree_ > kGreatestDegree) {
    throw std::invalid_argument("A curve's degree is from 1 to 5, not " + std::to_string(degree_) +
                                ".");
  }
  const Index needed = order() - SplineEnds::extra(start_) - SplineEnds::extra(end_);
  for (const CurveEnd* end : {&start_, &end_}) {
    SplineEnds::check(*end, degree_, points_.cols(), count() == needed);
  }
  if (count() < std::max<Index>(needed, 2)) {
    throw std::invalid_argument("A curve of degree " + std::to_string(degree_) + " needs " +
                                std::to_string(std::max<Index>(needed, 2)) +
                                " points or more with these ends, not " + std::to_string(count()) +
                                ".");
  }
  if (points_.cols() < 1 || !points_.allFinite()) {
    throw std::invalid_argument("A point of the curve is no place.");
  }
  const auto check_count = [&](std::size_t have, const char* what) {
    if (have == 0 || have == static_cast<std::size_t>(count())) return;
    throw std::invalid_argument(std::string("There must be as many ") + what + " as points, " +
                                std::to_string(count()) + ", not " + std::to_string(have) + ".");
  };
  check_count(options.parameters.size(), "parameters");
  check_count(options.weights.size(), "weights");
  for (double weight : options.weights) {
    if (!(weight > 0.0) || !std::isfinite(weight)) {
      throw std::invalid_argument("A weight is " + std::to_string(weight) +
                                  "; it must be above zero.");
    }
  }
}

void Smoothing::take_parameters(const SmoothingOptions& options) {
  t_ = options.parameters;
  if (t_.empty()) {
    t_.push_back(0.0);
    for (Index i = 1; i < count(); ++i) {
      t_.push_back(t_.back() + (points_.row(i) - points_.row(i - 1)).norm());
    }
  }
  for (std::size_t i = 1; i < t_.size(); ++i) {
    if (std::isfinite(t_[i] - t_[i - 1]) && t_[i] > t_[i - 1]) continue;
    throw std::invalid_argument("Points " + std::to_string(i - 1) + " and " + std::to_string(i) +
                                " of the curve are at the same place, or out of order.");
  }
}

void Smoothing::fit(double p) {
  const SplineEnds at_ends = ends(knots_);
  if (at_ends.free_count() == 0) {
    coefficients_ = at_ends.complete({});
    return;
  }
  // A jump takes degree + 2 splines beside one another, one more than a place.
  BandedLeastSquares equations(at_ends.free_count(), order() + 1, points_.cols());
  Eigen::VectorXd reduced;
  const auto add = [&](Index begin, const Eigen::VectorXd& values, Eigen::RowVectorXd right) {
    const Index first = at_ends.reduce(begin, values, reduced, right);
    if (first >= 0) equations.add(first, reduced, right);
  };
  for (Index i = 0; i < count(); ++i) {
    const double root = std::sqrt(weights_[i]);
    const Index span = span_of(knots_, degree_, t_[i]);
    add(span - degree_, root * basis_at(knots_, degree_, t_[i], span, 0), root * points_.row(i));
  }
  if (std::isfinite(p)) {
    const Eigen::RowVectorXd none = Eigen::RowVectorXd::Zero(points_.cols());
    // Of inner knots.
    for (Index span = order(); knots_[span] < knots_.back(); ++span) {
      Eigen::VectorXd jump = Eigen::VectorXd::Zero(order() + 1);
      // The degree's derivative is constant in each span: that after the knot, less that before it.
      jump.tail(order()) += basis_at(knots_, degree_, knots_[span], span, degree_);
      jump.head(order()) -= basis_at(knots_, degree_, knots_[span], span - 1, degree_);
      // E + Σ jump² / p has its least where Σ jump² + p E has, and stays finite for a large p.
      add(span - order(), jump / std::sqrt(p), none);
    }
  }
  coefficients_ = at_ends.complete(equations.solve());
}

double Smoothing::error_of(std::vector<double>* of_points) const {
  double sum = 0.0;
  for (Index i = 0; i < count(); ++i) {
    const Index span = span_of(knots_, degree_, t_[i]);
    const Eigen::RowVectorXd at = basis_at(knots_, degree_, t_[i], span, 0).transpose() *
                                  coefficients_.middleRows(span - degree_, order());
    const double error = weights_[i] * (at - points_.row(i)).squaredNorm();
    if (of_points != nullptr) of_points->push_back(error);
    sum += error;
  }
  return sum;
}

// Schoenberg and Whitney's condition (1953): each coefficient has a point of its own inside its
// support. Those that are not free need none, and take none.
bool Smoothing::has_points_enough(const std::vector<double>& knots) const {
  const SplineEnds at_ends = ends(knots);
  const Index unknowns = static_cast<Index>(knots.size()) - order();
  std::size_t next = 0;
  for (Index i = 0; i < unknowns; ++i) {
    if (!at_ends.is_free(i)) continue;
    const bool is_first = i == 0, is_last = i == unknowns - 1;
    // Greedily from the left: the first point of the support that none before has taken.
    while (next < t_.size() && !(t_[next] > knots[i] || (is_first && t_[next] == knots[i]))) ++next;
    if (next == t_.size()) return false;
    const double end = knots[i + order()];
    if (!(t_[next] < end || (is_last && t_[next] == end))) return false;
    ++next;
  }
  return true;
}

bool Smoothing::add_knot() {
  std::vector<double> errors;
  error_of(&errors);
  // Spans by their errors, the largest first.
  std::vector<std::pair<double, Index>> spans;
  for (Index span = degree_; span + order() < static_cast<Index>(knots_.size()); ++span) {
    double sum = 0.0;
    for (std::size_t i = 0; i < t_.size(); ++i) {
      if (t_[i] > knots_[span] && t_[i] < knots_[span + 1]) sum += errors[i];
    }
    spans.emplace_back(-sum, span);
  }
  std::ranges::sort(spans);
  for (const auto& [error, span] : spans) {
    std::vector<double> inside;
    for (double t : t_) {
      if (t > knots_[span] && t < knots_[span + 1]) inside.push_back(t);
    }
    if (inside.empty()) continue;
    // The middle point where a knot in the middle leaves some coefficient without a point.
    for (double place : {0.5 * (knots_[span] + knots_[span + 1]), inside[inside.size() / 2]}) {
      std::vector<double> knots = knots_;
      knots.insert(knots.begin() + span + 1, place);
      if (!has_points_enough(knots)) continue;
      knots_ = std::move(knots);
      return true;
    }
  }
  return false;
}

void Smoothing::take_knots_at_points() {
  const auto ends_knots = static_cast<std::size_t>(order());
  // A knot at each point between, but for the first and last of them where nothing else holds the
  // ends; of an even degree's odd number the end lacks one more.
  const int at_start = SplineEnds::extra(start_), all = at_start + SplineEnds::extra(end_);
  const int first = std::max(0, (degree_ - 1) / 2 - at_start);
  const int last = std::max(0, degree_ - 1 - all - first);
  const std::size_t to = t_.size() - 1 - std::min(t_.size() - 1, std::size_t(last));
  knots_.assign(ends_knots, t_.front());
  for (std::size_t i = std::size_t(1 + first); i < to; ++i) knots_.push_back(t_[i]);
  knots_.insert(knots_.end(), ends_knots, t_.back());
}

void Smoothing::interpolate() {
  take_knots_at_points();
  fit(std::numeric_limits<double>::infinity());
}

// F(p) falls from the error of the cubic to less than S: its logarithm by that of p is a smooth
// step.
void Smoothing::find_p() {
  // Where Σ jump² and E weigh the same.
  const double span = (t_.back() - t_.front()) / static_cast<double>(t_.size());
  double p = std::pow(span, -2.0 * degree_);
  double low = 0.0, high = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostSteps; ++step) {
    fit(p);
    const double error = error_of();
    p_ = p;
    if (std::abs(error - wanted_) <= kMet * wanted_) return;
    // A bisection in logarithms, as p may lie many powers of ten away from where it begins.
    (error > wanted_ ? low : high) = p;
    p = high == std::numeric_limits<double>::infinity() ? 100.0 * p
        : low == 0.0                                    ? 0.01 * p
                                                        : std::sqrt(low * high);
  }
}

SmoothCurve Smoothing::run() {
  const double scale = points_.squaredNorm();
  const auto is_met = [&] { return error_of() <= wanted_ + kInterpolated * scale; };
  // Knots come, by least squares alone, until E is within S; only then it is let up to S, for the
  // sake of fairness.
  bool is_short = false;
  fit(p_);
  const bool is_polynomial = is_met();
  if (!is_polynomial && wanted_ <= kInterpolated * scale) {
    interpolate();
    is_short = start_.given.rows() + end_.given.rows() > 0 && error_of() > wanted_ + 1e-20 * scale;
  } else if (!is_polynomial && knots_at_points_) {
    interpolate();
    is_short = !is_met();
    if (!is_short) find_p();
  } else if (!is_polynomial) {
    while (!is_met() && !is_short) {
      if (add_knot()) {
        fit(p_);
      } else {
        interpolate();
        is_short = !is_met();
        break;
      }
    }
    if (!is_short) find_p();
  }
  ends(knots_).check_agreement();
  return {degree_, knots_, coefficients_, error_of(), p_, is_short};
}

}  // namespace

SmoothCurve smooth_curve(const Eigen::MatrixXd& points, double deviation,
                         const SmoothingOptions& options) {
  return Smoothing(points, deviation, options).run();
}

}  // namespace hull::modelling
