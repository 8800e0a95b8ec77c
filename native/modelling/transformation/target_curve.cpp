// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/target_curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hull::modelling {
namespace {

void check(const std::vector<double>& positions, const std::vector<double>& areas) {
  if (positions.size() != areas.size() || positions.size() < 3) {
    throw std::invalid_argument(
        "A sectional area curve needs three points or more, as many areas as places.");
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!std::isfinite(positions[i]) || !std::isfinite(areas[i]) || areas[i] < 0.0) {
      throw std::invalid_argument("Point " + std::to_string(i + 1) +
                                  " of the sectional area curve is no place with an area of 0 or "
                                  "more.");
    }
    if (i > 0 && !(positions[i] > positions[i - 1])) {
      throw std::invalid_argument("Places of the sectional area curve must rise: point " +
                                  std::to_string(i + 1) + " does not lie ahead of the one before.");
    }
  }
  if (!(*std::ranges::max_element(areas) > 0.0)) {
    throw std::invalid_argument("The sectional area curve has no area at all.");
  }
}

// Slopes by the harmonic means of neighbouring ones: zero at extremes.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> secants(n - 1), slopes(n);
  for (std::size_t i = 0; i + 1 < n; ++i) secants[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double a = secants[i - 1], b = secants[i];
    const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
    const double wa = 2.0 * after + before, wb = after + 2.0 * before;
    slopes[i] = a * b > 0.0 ? (wa + wb) / (wa / a + wb / b) : 0.0;
  }
  // At the ends the parabola's, as far as it keeps the secant's sign and three times its size.
  const auto end = [](double near, double next, double h, double h_next) {
    const double slope = ((2.0 * h + h_next) * near - h * next) / (h + h_next);
    if (slope * near <= 0.0) return 0.0;
    return std::abs(slope) > 3.0 * std::abs(near) ? 3.0 * near : slope;
  };
  slopes[0] = end(secants[0], secants[1], x[1] - x[0], x[2] - x[1]);
  slopes[n - 1] = end(secants[n - 2], secants[n - 3], x[n - 1] - x[n - 2], x[n - 2] - x[n - 3]);
  return slopes;
}

}  // namespace

TargetCurve::TargetCurve(std::vector<double> positions, std::vector<double> areas)
    : positions_(std::move(positions)), areas_(std::move(areas)) {
  check(positions_, areas_);
  slopes_ = monotone_slopes(positions_, areas_);
  // The curve rises and falls as its points do, so the largest is one of them.
  const auto largest = std::ranges::max_element(areas_);
  largest_ = *largest;
  const auto first = largest - areas_.begin();
  auto last = first;
  // Of a parallel middle body the middle.
  while (last + 1 < std::ssize(areas_) && areas_[last + 1] == largest_) ++last;
  largest_at_ = 0.5 * (positions_[first] + positions_[last]);
}

double TargetCurve::at(double x) const {
  if (x < aft() || x > forward()) return 0.0;
  const auto next = std::ranges::upper_bound(positions_, x);
  // The forward end is of the last span.
  const std::size_t i =
      std::clamp<std::ptrdiff_t>(next - positions_.begin() - 1, 0, std::ssize(positions_) - 2);
  const double h = positions_[i + 1] - positions_[i], t = (x - positions_[i]) / h, s = 1.0 - t;
  return s * s * (1.0 + 2.0 * t) * areas_[i] + t * t * (1.0 + 2.0 * s) * areas_[i + 1] +
         s * t * h * (s * slopes_[i] - t * slopes_[i + 1]);
}

double TargetCurve::position_of(double area, bool is_fore) const {
  const double end = is_fore ? forward() : aft();
  constexpr int kSteps = 200, kBisections = 45;
  double inside = largest_at_;
  // Outwards step by step: areas may rise again further out, and the nearest place is meant.
  for (int i = 1; i <= kSteps; ++i) {
    double outside = largest_at_ + (end - largest_at_) * i / kSteps;
    if (at(outside) >= area) {
      inside = outside;
      continue;
    }
    for (int k = 0; k < kBisections; ++k) {
      const double middle = 0.5 * (inside + outside);
      (at(middle) >= area ? inside : outside) = middle;
    }
    return inside;
  }
  return end;
}

}  // namespace hull::modelling
