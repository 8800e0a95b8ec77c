// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/curve_smoothing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "modelling/fairing/banded_least_squares.h"
#include "modelling/fairing/spline_basis.h"

namespace hull::modelling {
namespace {

using Eigen::Index;

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
  Index coefficient_count() const { return static_cast<Index>(knots_.size()) - kOrder; }
  Index count() const { return points_.rows(); }

  // The spline on the knots: by least squares alone, or with Σ jump² / p added.
  void fit(double p);
  void give_ends(Eigen::MatrixXd& coefficients) const;
  double error_of(std::vector<double>* of_points = nullptr) const;
  bool add_knot();
  bool has_points_enough(const std::vector<double>& knots) const;
  void interpolate();
  void find_p();

  const Eigen::MatrixXd& points_;
  std::vector<double> t_, weights_;
  Eigen::MatrixXd start_, end_;
  double wanted_ = 0.0;  // S
  std::vector<double> knots_;
  Eigen::MatrixXd coefficients_;
  double p_ = std::numeric_limits<double>::infinity();
};

Smoothing::Smoothing(const Eigen::MatrixXd& points, double deviation,
                     const SmoothingOptions& options)
    : points_(points), weights_(options.weights), start_(options.start), end_(options.end) {
  check(options);
  take_parameters(options);
  if (weights_.empty()) weights_.assign(static_cast<std::size_t>(count()), 1.0);
  for (double weight : weights_) wanted_ += weight;
  wanted_ *= deviation * deviation;
  if (!(deviation >= 0.0) || !std::isfinite(wanted_)) {
    throw std::invalid_argument("The mean deviation must not be negative, nor infinite.");
  }
  knots_.assign(kOrder, t_.front());
  knots_.insert(knots_.end(), kOrder, t_.back());
}

void Smoothing::check(const SmoothingOptions& options) const {
  if (count() < kOrder) {
    throw std::invalid_argument("A curve needs four points or more to be smoothed, not " +
                                std::to_string(count()) + ".");
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
  for (const Eigen::MatrixXd* given : {&options.start, &options.end}) {
    if (given->rows() == 0) continue;
    if (given->rows() > 2 || given->cols() != points_.cols() || !given->allFinite()) {
      throw std::invalid_argument(
          "At an end a curve may have a place and a first derivative, each with as many "
          "coordinates as the points.");
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

// With clamped knots the first coefficients are the end's place and a third of a span along its
// derivative.
void Smoothing::give_ends(Eigen::MatrixXd& c) const {
  const Index last = c.rows() - 1;
  const std::size_t n = knots_.size();
  if (start_.rows() > 0) c.row(0) = start_.row(0);
  if (start_.rows() > 1) c.row(1) = start_.row(0) + start_.row(1) * (knots_[4] - knots_[3]) / 3.0;
  if (end_.rows() > 0) c.row(last) = end_.row(0);
  if (end_.rows() > 1) {
    c.row(last - 1) = end_.row(0) - end_.row(1) * (knots_[n - 4] - knots_[n - 5]) / 3.0;
  }
}

void Smoothing::fit(double p) {
  const Index unknowns = coefficient_count(), first = start_.rows();
  const Index free = unknowns - first - end_.rows();
  coefficients_ = Eigen::MatrixXd::Zero(unknowns, points_.cols());
  give_ends(coefficients_);
  if (free <= 0) return;
  BandedLeastSquares equations(free, kOrder + 1, points_.cols());
  // A row over coefficients from `begin` on: those that are given go to the right side.
  const auto add = [&](Index begin, const Eigen::VectorXd& values, Eigen::RowVectorXd right) {
    const Index low = std::max(begin, first);
    const Index high = std::min(begin + values.size(), first + free);
    for (Index k = 0; k < values.size(); ++k) {
      if (begin + k < low || begin + k >= high) right -= values[k] * coefficients_.row(begin + k);
    }
    if (high > low) equations.add(low - first, values.segment(low - begin, high - low), right);
  };
  for (Index i = 0; i < count(); ++i) {
    const double root = std::sqrt(weights_[i]);
    const Index span = span_of(knots_, t_[i]);
    add(span - kDegree, root * basis_at(knots_, t_[i], span, 0), root * points_.row(i));
  }
  if (std::isfinite(p)) {
    const Eigen::RowVectorXd none = Eigen::RowVectorXd::Zero(points_.cols());
    for (Index span = kOrder; span < unknowns; ++span) {
      Eigen::VectorXd jump = Eigen::VectorXd::Zero(kOrder + 1);
      jump.tail(kOrder) += basis_at(knots_, knots_[span], span, kDegree);
      jump.head(kOrder) -= basis_at(knots_, knots_[span], span - 1, kDegree);
      add(span - kOrder, jump / std::sqrt(p), none);
    }
  }
  coefficients_.middleRows(first, free) = equations.solve();
}

double Smoothing::error_of(std::vector<double>* of_points) const {
  double sum = 0.0;
  for (Index i = 0; i < count(); ++i) {
    const Index span = span_of(knots_, t_[i]);
    const Eigen::RowVectorXd at = basis_at(knots_, t_[i], span, 0).transpose() *
                                  coefficients_.middleRows(span - kDegree, kOrder);
    const double error = weights_[i] * (at - points_.row(i)).squaredNorm();
    if (of_points != nullptr) of_points->push_back(error);
    sum += error;
  }
  return sum;
}

// Schoenberg and Whitney's condition: each coefficient has a point of its own inside its support.
// Those that ends give need none, and take none.
bool Smoothing::has_points_enough(const std::vector<double>& knots) const {
  const Index unknowns = static_cast<Index>(knots.size()) - kOrder;
  std::size_t next = 0;
  for (Index i = start_.rows(); i < unknowns - end_.rows(); ++i) {
    const bool is_first = i == 0, is_last = i == unknowns - 1;
    while (next < t_.size() && !(t_[next] > knots[i] || (is_first && t_[next] == knots[i]))) ++next;
    if (next == t_.size()) return false;
    const double end = knots[i + kOrder];
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
  for (Index span = kDegree; span + kOrder < static_cast<Index>(knots_.size()); ++span) {
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

void Smoothing::interpolate() {
  knots_.assign(kOrder, t_.front());
  // With an end's place given its point is met besides: one coefficient less is free, and with a
  // derivative one knot more is needed.
  const std::size_t from = start_.rows() > 1 ? 1 : 2, to = end_.rows() > 1 ? 1 : 2;
  knots_.insert(knots_.end(), t_.begin() + static_cast<std::ptrdiff_t>(from),
                t_.end() - static_cast<std::ptrdiff_t>(to));
  knots_.insert(knots_.end(), kOrder, t_.back());
  fit(std::numeric_limits<double>::infinity());
}

// F(p) falls from the error of the cubic to less than S: its logarithm by that of p is a smooth
// step.
void Smoothing::find_p() {
  // Where Σ jump² and E weigh the same.
  const double span = (t_.back() - t_.front()) / static_cast<double>(t_.size());
  double p = std::pow(span, -2.0 * kDegree);
  double low = 0.0, high = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostSteps; ++step) {
    fit(p);
    const double error = error_of();
    p_ = p;
    if (std::abs(error - wanted_) <= kMet * wanted_) return;
    (error > wanted_ ? low : high) = p;
    p = high == std::numeric_limits<double>::infinity() ? 100.0 * p
        : low == 0.0                                    ? 0.01 * p
                                                        : std::sqrt(low * high);
  }
}

SmoothCurve Smoothing::run() {
  const double scale = points_.squaredNorm();
  const auto is_met = [&] { return error_of() <= wanted_ + kInterpolated * scale; };
  bool is_short = false;
  fit(p_);
  const bool is_cubic = is_met();
  if (!is_cubic && wanted_ <= kInterpolated * scale) {
    interpolate();
    is_short = start_.rows() + end_.rows() > 0 && error_of() > wanted_ + 1e-20 * scale;
  } else if (!is_cubic) {
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
  return {knots_, coefficients_, error_of(), p_, is_short};
}

}  // namespace

Eigen::MatrixXd SmoothCurve::evaluate(const std::vector<double>& parameters, int order) const {
  if (order < 0 || order > kDegree) {
    throw std::invalid_argument("A derivative's order is from 0 to 3.");
  }
  Eigen::MatrixXd values(static_cast<Index>(parameters.size()), coefficients.cols());
  for (Index i = 0; i < values.rows(); ++i) {
    const double t = parameters[static_cast<std::size_t>(i)];
    if (!std::isfinite(t)) throw std::invalid_argument("A parameter is no number.");
    const Index span = span_of(knots, t);
    values.row(i) = basis_at(knots, t, span, order).transpose() *
                    coefficients.middleRows(span - kDegree, kOrder);
  }
  return values;
}

SmoothCurve smooth_curve(const Eigen::MatrixXd& points, double deviation,
                         const SmoothingOptions& options) {
  return Smoothing(points, deviation, options).run();
}

}  // namespace hull::modelling
