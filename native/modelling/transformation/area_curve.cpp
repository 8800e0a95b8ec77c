// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/area_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/dense_solvers.h"

namespace hull::modelling {
namespace {

constexpr int kSamplesPerSpan = 5;
constexpr double kFade = 0.1;
constexpr int kBisections = 24;  // the ends of the parallel body to some 1e-9 of the length

// The four cubic B-splines of a span at t in [0, 1].
std::array<double, 4> basis(double t) {
  const double s = 1.0 - t;
  return {s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0,
          (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0, t * t * t / 6.0};
}

struct SpanPlace {
  int span;
  double t;
};

SpanPlace place_of(double share) {
  const double along = AreaCurve::kSpans * std::clamp(share, 0.0, 1.0);
  const int span = std::min(static_cast<int>(along), AreaCurve::kSpans - 1);
  return {span, along - span};
}

}  // namespace

std::vector<double> spread(double from, double to, int count) {
  std::vector<double> result(count);
  for (int i = 0; i < count; ++i) result[i] = from + (to - from) * i / (count - 1);
  return result;
}

AreaCurve::AreaCurve(const WorkingHull& hull)
    : aft_(hull.immersed_range().first), forward_(hull.immersed_range().second) {
  const double length = forward_ - aft_;
  const std::vector<double> positions =
      spread(aft_ + kInside * length, forward_ - kInside * length, kSpans * kSamplesPerSpan + 1);
  const auto sections = hull.sections(positions);
  const auto largest = std::ranges::max_element(sections, {}, &analysis::SectionArea::area);
  largest_ = largest->area;
  largest_at_ = largest->position;
  Eigen::MatrixXd rows =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(sections.size()), kSpans + 3);
  Eigen::VectorXd areas(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const SpanPlace place = place_of((positions[i] - aft_) / length);
    const std::array<double, 4> weights = basis(place.t);
    for (int k = 0; k < 4; ++k) rows(i, place.span + k) = weights[k];
    areas[i] = sections[i].area / largest_;
  }
  // Some four samples to a coefficient: a jump of the areas is smoothed, not followed.
  coefficients_ = mesh::least_norm_solution(rows, areas);
  const double step = 1e-4 * length;
  // From within: beyond its ends spline() is constant.
  slope_aft_ = (spline(aft_ + step) - spline(aft_)) / step;
  slope_forward_ = (spline(forward_) - spline(forward_ - step)) / step;
}

double AreaCurve::spline(double x) const {
  const SpanPlace place = place_of((x - aft_) / (forward_ - aft_));
  const std::array<double, 4> weights = basis(place.t);
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) sum += weights[k] * coefficients_[place.span + k];
  return sum;
}

double AreaCurve::at(double x) const {
  const double fade = kFade * (forward_ - aft_);
  // On along the tangent, whose slope fades to none.
  const auto beyond = [fade](double distance) {
    const double d = std::min(distance, fade);
    // The integral of a slope that falls from 1 to 0 in a straight line.
    return d * (1.0 - 0.5 * d / fade);
  };
  if (x < aft_) return spline(aft_) - slope_aft_ * beyond(aft_ - x);
  if (x > forward_) return spline(forward_) + slope_forward_ * beyond(x - forward_);
  return spline(x);
}

HullRange parallel_body(const WorkingHull& hull) {
  const auto [aft, forward] = hull.immersed_range();
  const double length = forward - aft;
  const auto sections = hull.sections(
      spread(aft + AreaCurve::kInside * length, forward - AreaCurve::kInside * length, 81));
  const auto largest = std::ranges::max_element(sections, {}, &analysis::SectionArea::area);
  const auto is_same = [&](const analysis::SectionArea& section) {
    return section.area >= (1.0 - kSameArea) * largest->area;
  };
  auto first = largest, last = largest;
  // From the largest outwards: one as large behind a smaller one is of another part.
  while (first != sections.begin() && is_same(*(first - 1))) --first;
  while (last + 1 != sections.end() && is_same(*(last + 1))) ++last;
  // Between a section that is the same and its neighbour that is not.
  const auto end = [&](double inside, double outside) {
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (inside + outside);
      (is_same(hull.sections({middle}).front()) ? inside : outside) = middle;
    }
    return inside;
  };
  HullRange range{first->position, last->position};
  if (first != sections.begin()) range.aft = end(range.aft, (first - 1)->position);
  if (last + 1 != sections.end()) range.forward = end(range.forward, (last + 1)->position);
  // Shorter ones are the tops of curved ones.
  if (range.forward - range.aft > 1e-3 * length) return range;
  return {largest->position, largest->position};
}

}  // namespace hull::modelling
