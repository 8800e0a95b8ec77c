// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/section_splines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/arithmetic/tridiagonal.h"
#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

// Where splines through all points of a section are too far from it, four times finer ones are
// tried so often.
constexpr int kMostFiner = 3;
constexpr int kMostRounds = 24;
// Points nearer to each other than this part of the stretch are not both knots.
constexpr double kLeastSpacing = 1e-7;

// A stretch by its points and their parameters: lengths along it.
struct Course {
  std::vector<Vector3d> points, tangents;
  std::vector<double> at;
  bool closed;

  double length() const { return at.back(); }
  std::size_t last() const { return points.size() - 1; }
};

Course course_of(const SectionCurve& curve, const SmoothStretch& stretch, const Plane& plane) {
  Course course;
  course.closed = curve.closed && curve.knuckles.empty();
  double length = 0.0;
  for (int i = stretch.first + 1; i <= stretch.last; ++i) {
    length += (curve.points[i] - curve.points[i - 1]).norm();
  }
  // Points are off the plane by rounding or the flat tolerance; a spline's control points are not.
  const auto in_plane = [&](const Vector3d& p) {
    return Vector3d(p - plane.height(p) * plane.normal);
  };
  const auto along_plane = [&](const Vector3d& d) {
    return Vector3d(d - plane.normal.dot(d) * plane.normal);
  };
  double curvature = stretch.first_curvature;
  for (int i = stretch.first; i <= stretch.last; ++i) {
    const Vector3d p = in_plane(curve.points[i]);
    const Vector3d tangent =
        along_plane(i == stretch.first ? stretch.first_tangent : curve.tangents[i]);
    if (course.points.empty()) {
      course.points.push_back(p);
      course.tangents.push_back(tangent);
      course.at.push_back(0.0);
      continue;
    }
    const double chord = (p - course.points.back()).norm();
    if (chord < kLeastSpacing * length) {
      if (i < stretch.last) continue;
      // The last point has to stay: the one before it goes.
      if (course.points.size() > 1) {
        course.points.pop_back();
        course.tangents.pop_back();
        course.at.pop_back();
        --i;
        continue;
      }
    }
    // An arc's length from its chord, to fourth order.
    const double turn = 0.5 * (curvature + curve.curvatures[i]) * chord;
    course.at.push_back(course.at.back() + chord * (1.0 + std::min(turn * turn / 24.0, 0.1)));
    course.points.push_back(p);
    course.tangents.push_back(tangent);
    curvature = curve.curvatures[i];
  }
  return course;
}

// Derivatives at the nodes of the twice continuously differentiable cubic spline through some of
// the course's points: with the course's tangents at the ends, or periodic.
std::vector<Vector3d> slopes(const Course& course, const std::vector<std::size_t>& nodes) {
  const std::size_t n = nodes.size() - 1;
  const auto width = [&](std::size_t i) { return course.at[nodes[i + 1]] - course.at[nodes[i]]; };
  const auto rise = [&](std::size_t i) {
    const double h = width(i);
    return Vector3d(3.0 / (h * h) * (course.points[nodes[i + 1]] - course.points[nodes[i]]));
  };
  const std::size_t count = course.closed ? n : n + 1;
  Tridiagonal rows{std::vector<double>(count, 0.0), std::vector<double>(count, 1.0),
                   std::vector<double>(count, 0.0)};
  std::vector<Vector3d> right(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!course.closed && (i == 0 || i == n)) {
      right[i] = course.tangents[nodes[i]];
      continue;
    }
    // Second derivatives on both sides of a node agree: with slopes m and widths h, m_i-1 / h_i-1 +
    // 2 (1 / h_i-1 + 1 / h_i) m_i + m_i+1 / h_i = rise_i-1 + rise_i.
    const std::size_t before = i > 0 ? i - 1 : n - 1;
    rows.below[i] = 1.0 / width(before);
    rows.above[i] = 1.0 / width(i);
    rows.diagonal[i] = 2.0 * (rows.below[i] + rows.above[i]);
    right[i] = rise(before) + rise(i);
  }
  if (!course.closed) return rows.solve(std::move(right));
  std::vector<Vector3d> m = rows.solve_cyclic(std::move(right));
  m.push_back(m.front());
  return m;
}

surface::CubicSpline spline_through(const Course& course, const std::vector<std::size_t>& nodes) {
  const std::vector<Vector3d> m = slopes(course, nodes);
  const std::size_t n = nodes.size() - 1;
  const auto at = [&](std::size_t i) { return course.at[nodes[i]]; };
  const auto third = [&](std::size_t i) { return (at(i + 1) - at(i)) / 3.0; };
  // The inner Bézier points of span i.
  const auto first = [&](std::size_t i) {
    return Vector3d(course.points[nodes[i]] + third(i) * m[i]);
  };
  const auto second = [&](std::size_t i) {
    return Vector3d(course.points[nodes[i + 1]] - third(i) * m[i + 1]);
  };
  std::vector<double> knots(3, at(0));
  for (std::size_t i = 0; i <= n; ++i) knots.push_back(at(i));
  knots.insert(knots.end(), 3, at(n));
  std::vector<Vector3d> points{course.points[nodes[0]], first(0)};
  for (std::size_t i = 1; i < n; ++i) {
    // The blossom of the longer of the two spans at the nodes i - 1, i, i + 1.
    const double before = at(i) - at(i - 1), after = at(i + 1) - at(i);
    const std::size_t span = before > after ? i - 1 : i;
    const double x = before > after ? (before + after) / before : -before / after;
    points.push_back((1.0 - x) * first(span) + x * second(span));
  }
  points.push_back(second(n - 1));
  points.push_back(course.points[nodes[n]]);
  return {std::move(points), std::move(knots)};
}

// The distance from the spline near its parameter t.
double distance_to(const surface::CubicSpline& spline, const Vector3d& p, double t) {
  double nearest = std::numeric_limits<double>::infinity();
  // Steps of Gauss and Newton to the foot: each place on the way bounds the distance.
  for (int i = 0; i < 3; ++i) {
    const surface::CurveJet jet = spline.evaluate(t, 1);
    const Vector3d r = p - jet.point;
    nearest = std::min(nearest, r.norm());
    const double speed2 = jet.d1.squaredNorm();
    if (speed2 == 0.0) break;
    t = std::clamp(t + r.dot(jet.d1) / speed2, spline.begin(), spline.end());
  }
  return nearest;
}

// The largest distance of the course from the spline over the points from a to b.
double largest_distance(const Course& course, const surface::CubicSpline& spline, std::size_t a,
                        std::size_t b) {
  double largest = 0.0;
  for (std::size_t i = a; i < b; ++i) {
    const double width = course.at[i + 1] - course.at[i];
    // Of the cubic with the course's points and tangents.
    const Vector3d middle = 0.5 * (course.points[i] + course.points[i + 1]) +
                            0.125 * width * (course.tangents[i] - course.tangents[i + 1]);
    largest = std::max(largest, distance_to(spline, middle, course.at[i] + 0.5 * width));
    if (i > a) largest = std::max(largest, distance_to(spline, course.points[i], course.at[i]));
  }
  return largest;
}

// The point halfway between two, in length.
std::size_t middle_of(const Course& course, std::size_t a, std::size_t b) {
  const double half = 0.5 * (course.at[a] + course.at[b]);
  // Between the two, even where all points are in one half.
  const auto begin = course.at.begin() + static_cast<std::ptrdiff_t>(a) + 1;
  const auto end = course.at.begin() + static_cast<std::ptrdiff_t>(b) - 1;
  return static_cast<std::size_t>(std::lower_bound(begin, end, half) - course.at.begin());
}

SectionSpline fit(const Course& course, double tolerance) {
  std::vector<std::size_t> nodes{0, course.last()};
  // A periodic spline needs some.
  for (int i = 0; i < 2 && course.closed; ++i) {
    std::vector<std::size_t> more;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      if (nodes[k + 1] - nodes[k] > 1) more.push_back(middle_of(course, nodes[k], nodes[k + 1]));
    }
    nodes.insert(nodes.end(), more.begin(), more.end());
    std::sort(nodes.begin(), nodes.end());
  }
  for (int round = 0;; ++round) {
    SectionSpline result{spline_through(course, nodes), course.closed, 0.0};
    std::vector<std::size_t> more;
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      const double off = largest_distance(course, result.curve, nodes[k], nodes[k + 1]);
      result.largest_distance = std::max(result.largest_distance, off);
      if (off > tolerance && nodes[k + 1] - nodes[k] > 1) {
        more.push_back(middle_of(course, nodes[k], nodes[k + 1]));
      }
    }
    if (more.empty() || round == kMostRounds) return result;
    nodes.insert(nodes.end(), more.begin(), more.end());
    std::sort(nodes.begin(), nodes.end());
  }
}

}  // namespace

std::vector<SectionSplines> section_splines(const surface::LimitSurface& surface,
                                            const Plane& plane, double tolerance,
                                            std::optional<double> flat_tolerance) {
  std::vector<SectionSplines> result;
  // Between the points the course is known to a part of their chords' distances from it.
  double chord_tolerance = 0.25 * tolerance;
  const double no_length = kNoLength * surface.mesh().size();
  for (int finer = 0; finer <= kMostFiner; ++finer, chord_tolerance *= 0.25) {
    result.clear();
    double largest = 0.0;
    for (const SectionCurve& curve : section(surface, plane, {chord_tolerance, flat_tolerance})) {
      SectionSplines& branch = result.emplace_back();
      branch.closed = curve.closed;
      for (const SmoothStretch& stretch : smooth_stretches(curve)) {
        const Course course = course_of(curve, stretch, plane);
        // Edges without length on the plane, and points in which it touches the surface.
        if (course.length() <= no_length) continue;
        branch.splines.push_back(fit(course, tolerance));
        largest = std::max(largest, branch.splines.back().largest_distance);
      }
    }
    if (largest <= tolerance) break;
  }
  return result;
}

}  // namespace hull::analysis
