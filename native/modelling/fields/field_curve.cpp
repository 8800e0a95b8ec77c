// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/field_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/arithmetic/gauss.h"
#include "analysis/arithmetic/tridiagonal.h"
#include "modelling/fields/arc_foot.h"

namespace hull::modelling {
namespace {

using Arc = FieldCurve::Arc;

// Of the length of what both join: ends of arcs that meet.
constexpr double kMeet = 1e-9;
// An arc's length between two of its points is that of this many parts by Gauss's rule.
constexpr int kParts = 4;
constexpr int kLengthSteps = 60;
// Cosine of the angle between the curve and the line to its foot: at ends of arcs that join
// smoothly the foot moves on, at knuckles it stays.
constexpr double kSquare = 1e-9;

double polygon_length(const Arc& arc) {
  return (arc[1] - arc[0]).norm() + (arc[2] - arc[1]).norm() + (arc[3] - arc[2]).norm();
}

double length_between(const Arc& arc, double begin, double end) {
  // Made once, by whichever thread comes first.
  static const analysis::GaussRule rule = analysis::gauss_rule(16);
  const double part = (end - begin) / kParts;
  double sum = 0.0;
  for (int k = 0; k < kParts; ++k) {
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double t = begin + part * (k + rule.nodes[i]);
      sum += rule.weights[i] * arc_jet(arc, t).d1.norm();
    }
  }
  return part * sum;
}

void check(const std::vector<Arc>& arcs) {
  if (arcs.empty()) throw std::invalid_argument("A curve needs two points at least.");
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const std::string name = "Arc " + std::to_string(i) + " of the curve";
    for (const Vector3d& point : arcs[i]) {
      if (!point.allFinite()) throw std::invalid_argument(name + " has a point that is no number.");
    }
    const double length = polygon_length(arcs[i]);
    if (!(length > 0.0)) throw std::invalid_argument(name + " has no length.");
    if (i > 0 && (arcs[i][0] - arcs[i - 1][3]).norm() > kMeet * length) {
      throw std::invalid_argument(name + " does not begin where the one before ends.");
    }
  }
}

Arc hermite_arc(const Vector3d& a, const Vector3d& da, const Vector3d& b, const Vector3d& db,
                double step) {
  return {a, a + step / 3.0 * da, b - step / 3.0 * db, b};
}

// Derivatives at the points of the cubic spline through them that has two continuous derivatives,
// and none of second order at its ends; or of the closed one. `steps`: of the parameter, as many as
// points of a closed one.
std::vector<Vector3d> spline_tangents(const std::vector<Vector3d>& points,
                                      const std::vector<double>& steps, bool closed) {
  const std::size_t n = points.size();
  const auto chord = [&](std::size_t i) -> Vector3d {
    return (points[(i + 1) % n] - points[i]) / steps[i];
  };
  analysis::Tridiagonal rows{std::vector<double>(n, 0.0), std::vector<double>(n, 2.0),
                             std::vector<double>(n, 0.0)};
  std::vector<Vector3d> right(n);
  // The second derivatives of the Hermite arcs before and after a point are equal.
  for (std::size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    rows.below[i] = steps[i];
    rows.above[i] = steps[before];
    rows.diagonal[i] = 2.0 * (steps[before] + steps[i]);
    right[i] = 3.0 * (steps[i] * chord(before) + steps[before] * chord(i));
  }
  if (closed) return rows.solve_cyclic(std::move(right));
  // That of the first arc is zero at its beginning: 2 m0 + m1 = 3 chord; likewise at the end.
  rows.above[0] = rows.below[n - 1] = 1.0;
  right[0] = 3.0 * chord(0);
  right[n - 1] = 3.0 * chord(n - 2);
  return rows.solve(std::move(right));
}

std::vector<double> chords(const std::vector<Vector3d>& points, bool closed) {
  std::vector<double> steps;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
    steps.push_back((points[(i + 1) % points.size()] - points[i]).norm());
  }
  return steps;
}

void add_smooth_part(const std::vector<Vector3d>& points, bool closed, std::vector<Arc>& arcs) {
  const std::vector<double> steps = chords(points, closed);
  const std::vector<Vector3d> tangents = spline_tangents(points, steps, closed);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::size_t next = (i + 1) % points.size();
    arcs.push_back(hermite_arc(points[i], tangents[i], points[next], tangents[next], steps[i]));
  }
}

void check_points(const std::vector<Vector3d>& points, bool closed) {
  if (points.size() < (closed ? 3u : 2u)) {
    throw std::invalid_argument(closed ? "A closed curve needs three points at least."
                                       : "A curve needs two points at least.");
  }
  const std::vector<double> steps = chords(points, closed);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!(steps[i] > 0.0) || !std::isfinite(steps[i])) {
      throw std::invalid_argument("Points " + std::to_string(i) + " and " +
                                  std::to_string((i + 1) % points.size()) +
                                  " of the curve are the same, or no numbers.");
    }
  }
}

}  // namespace

FieldCurve::FieldCurve(std::vector<Arc> arcs) : arcs_(std::move(arcs)) {
  check(arcs_);
  starts_.push_back(0.0);
  for (const Arc& arc : arcs_) starts_.push_back(starts_.back() + length_between(arc, 0.0, 1.0));
}

FieldCurve FieldCurve::of_spline(const surface::CubicSpline& spline) {
  const std::vector<double>& knots = spline.knots();
  std::vector<Arc> arcs;
  for (std::size_t i = 3; i + 4 < knots.size(); ++i) {
    // A span of the spline is one cubic, which its ends and their derivatives give.
    const double step = knots[i + 1] - knots[i];
    const surface::CurveJet a = spline.evaluate(knots[i], 1), b = spline.evaluate(knots[i + 1], 1);
    // Spans at darts shrink to nothing.
    const Arc arc = hermite_arc(a.point, a.d1, b.point, b.d1, step);
    if (step > 0.0 && polygon_length(arc) > 0.0) arcs.push_back(arc);
  }
  return FieldCurve(std::move(arcs));
}

FieldCurve FieldCurve::through(const std::vector<Vector3d>& points,
                               const std::vector<int>& knuckles, bool closed) {
  check_points(points, closed);
  const int count = static_cast<int>(points.size());
  std::vector<int> ends = knuckles;
  for (int knuckle : ends) {
    if (knuckle < 0 || knuckle >= count) {
      throw std::invalid_argument("Knuckle " + std::to_string(knuckle) +
                                  " of the curve is none of its " + std::to_string(count) +
                                  " points.");
    }
  }
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Arc> arcs;
  if (closed && ends.empty()) {
    add_smooth_part(points, true, arcs);
    return FieldCurve(std::move(arcs));
  }
  if (closed) {
    // Once around, from the first knuckle to itself: parts go over the seam.
    ends.push_back(ends.front() + count);
  } else {
    if (ends.empty() || ends.front() != 0) ends.insert(ends.begin(), 0);
    if (ends.back() != count - 1) ends.push_back(count - 1);
  }
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    std::vector<Vector3d> part;
    for (int i = ends[k]; i <= ends[k + 1]; ++i) part.push_back(points[i % count]);
    add_smooth_part(part, false, arcs);
  }
  return FieldCurve(std::move(arcs));
}

FieldCurve::Place FieldCurve::place_at(double length) const {
  const double wanted = std::clamp(length, 0.0, this->length());
  // Without the first start and the end of the whole, so that any length is on an arc.
  const auto after = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, wanted);
  const int arc = static_cast<int>(after - starts_.begin()) - 1;
  const double rest = wanted - starts_[arc], whole = starts_[arc + 1] - starts_[arc];
  // The length rises with t, so Newton's method in a bracket finds the one t.
  double low = 0.0, high = 1.0, t = rest / whole;
  for (int step = 0; step < kLengthSteps; ++step) {
    const double miss = length_between(arcs_[arc], 0.0, t) - rest;
    (miss > 0.0 ? high : low) = t;
    const double speed = arc_jet(arcs_[arc], t).d1.norm();
    double next = speed > 0.0 ? t - miss / speed : 0.5 * (low + high);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= 1e-16 || std::abs(miss) <= 1e-15 * whole) break;
    t = next;
  }
  return {arc, std::clamp(t, 0.0, 1.0)};
}

double FieldCurve::length_at(const Place& place) const {
  return starts_[place.arc] + length_between(arcs_[place.arc], 0.0, place.t);
}

Vector3d FieldCurve::point_at(double length) const {
  const Place place = place_at(length);
  return arc_jet(arcs_[place.arc], place.t).point;
}

Vector3d FieldCurve::tangent_at(double length) const {
  const Place place = place_at(length);
  return arc_jet(arcs_[place.arc], place.t).d1.normalized();
}

CurveFoot FieldCurve::foot(const Vector3d& p, bool with_length) const {
  // Arcs in the order of how near they may be, so that most are left out at once.
  std::vector<std::pair<double, int>> order;
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    order.emplace_back(least_distance(arcs_[i], p), static_cast<int>(i));
  }
  std::ranges::sort(order);
  Place best{0, 0.0};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [bound, arc] : order) {
    // All that follow are farther still.
    if (bound >= least) break;
    const ArcFoot found = arc_foot(arcs_[arc], p, least);
    if (found.distance < least) {
      least = found.distance;
      best = {arc, found.t};
    }
  }
  const surface::CurveJet jet = arc_jet(arcs_[best.arc], best.t);
  CurveFoot foot{jet.point, least, with_length ? length_at(best) : 0.0, Vector3d::Zero()};
  const Vector3d from = p - jet.point;
  const bool is_square = std::abs(from.dot(jet.d1)) <= kSquare * least * jet.d1.norm();
  if (is_square || (best.t > 0.0 && best.t < 1.0)) {
    // Of (p - c) · c' = 0; beyond the centre of curvature no foot is the nearest.
    const double below = jet.d1.squaredNorm() - from.dot(jet.d2);
    if (below > 0.0) foot.length_slope = jet.d1 * (jet.d1.norm() / below);
  }
  return foot;
}

}  // namespace hull::modelling
