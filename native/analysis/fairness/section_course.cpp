// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/section_course.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "analysis/fairness/cell_places.h"

namespace hull::analysis {
namespace {

constexpr int kMostSteps = 20;
constexpr double kConverged = 1e-14;  // of the mesh's size
constexpr double kLastStep = 1e-6;    // in (u, v): what Newton's method still misses is its square
constexpr double kOnCurve = 1e-10;

// Length of an arc by its chord and the curvatures at its ends.
double arc_length(double chord, double k0, double k1) {
  // Chord (1 + k^2 chord^2 / 24): of a curvature k that changes evenly k^2 is
  // (k0^2 + k0 k1 + k1^2) / 3 in the mean.
  const double bend = chord * chord * (k0 * k0 + k0 * k1 + k1 * k1) / 72.0;
  // The series holds for arcs of less than about a radian.
  return chord * (1.0 + std::min(bend, 0.1));
}

template <class Vector>
Vector hermite(const Vector& p0, const Vector& d0, const Vector& p1, const Vector& d1, double t) {
  const double r = 1.0 - t;
  return r * r * (1.0 + 2.0 * t) * p0 + r * r * t * d0 - r * t * t * d1 +
         t * t * (1.0 + 2.0 * r) * p1;
}

std::vector<double> lengths_along(const SectionCurve& curve, const SmoothStretch& stretch) {
  std::vector<double> lengths;
  for (int i = stretch.first; i < stretch.last; ++i) {
    const double chord = (curve.points[i + 1] - curve.points[i]).norm();
    const double k0 = i == stretch.first ? stretch.first_curvature : curve.curvatures[i];
    lengths.push_back(arc_length(chord, k0, curve.curvatures[i + 1]));
  }
  return lengths;
}

// Direction and curvature of a curve in a plane, from its first and second derivative.
struct Course {
  Vector3d tangent = Vector3d::Zero();
  double curvature = 0.0;
};
Course course_of(const Vector3d& d1, const Vector3d& d2, const Vector3d& normal) {
  const double speed = d1.norm();
  if (!(speed > 0.0)) return {};
  return {d1 / speed, normal.dot(d1.cross(d2)) / (speed * speed * speed)};
}

// Where the height above a plane stays the same.
Course level_course(const surface::SurfaceJet& jet, const Vector3d& normal) {
  const double gu = normal.dot(jet.du), gv = normal.dot(jet.dv);
  const double slope2 = gu * gu + gv * gv;
  if (!(slope2 > 0.0)) return {};
  // Along w = (gv, -gu) the height is constant to first order; across it, to second order.
  const double wu = gv, wv = -gu;
  const Vector3d bend = wu * wu * jet.duu + 2.0 * wu * wv * jet.duv + wv * wv * jet.dvv;
  const double across = -normal.dot(bend) / slope2;
  return course_of(wu * jet.du + wv * jet.dv, bend + across * (gu * jet.du + gv * jet.dv), normal);
}

}  // namespace

SectionCourse::SectionCourse(const surface::LimitSurface& surface, const Plane& plane,
                             const SectionCurve& curve, const SmoothStretch& stretch,
                             CourseMemory* memory)
    : MeasuredCurve({0.0}, curve.closed && curve.knuckles.empty()),
      surface_(surface),
      plane_(plane),
      curve_(curve),
      stretch_(stretch),
      memory_(memory),
      lengths_(lengths_along(curve, stretch)) {
  segments_.reserve(lengths_.size());
  for (const double length : lengths_) {
    const int i = stretch.first + static_cast<int>(segments_.size());
    segments_.push_back(segment_between(i, i + 1));
    breaks_.push_back(breaks_.back() + length);
  }
  part();
  for (const Run& run : runs_) {
    const auto own = std::span(segments_).subspan(run.first, run.last - run.first);
    if (memory && can_be_kept(run) && memory->recall(points_of(run), own)) continue;
    for (int k = run.first; k < run.last; ++k) lead(k);
  }
}

// Into runs, and the points that a memory knows them by.
void SectionCourse::part() {
  for (int k = 0; k < static_cast<int>(segments_.size()); ++k) {
    if (k == 0 || segments_[k].cell != segments_[k - 1].cell) runs_.push_back({k, k});
    runs_.back().last = k + 1;
  }
  if (!memory_) return;
  points_.reserve(segments_.size() + 1);
  for (int i = stretch_.first; i <= stretch_.last; ++i) {
    const CurveSample at = known(i);
    points_.push_back({curve_.cells[i], curve_.uv[i], at.point, at.tangent, at.signed_curvature});
  }
}

bool SectionCourse::can_be_kept(const Run& run) const {
  return std::all_of(segments_.begin() + run.first, segments_.begin() + run.last,
                     [](const CourseSegment& s) { return s.cell >= 0 && !s.is_compared; });
}

std::span<const CoursePoint> SectionCourse::points_of(const Run& run) const {
  return std::span(points_).subspan(run.first, run.last - run.first + 1);
}

void SectionCourse::keep() const {
  if (!memory_) return;
  for (const Run& run : runs_) {
    const auto own = std::span(segments_).subspan(run.first, run.last - run.first);
    if (can_be_kept(run)) memory_->keep(points_of(run), own);
  }
}

double SectionCourse::middle_height(const CourseSegment& segment) const {
  const Eigen::Vector2d middle = 0.5 * (segment.from + segment.to);
  return std::abs(plane_.height(surface_.position(segment.cell, middle.x(), middle.y())));
}

CourseSegment SectionCourse::segment_between(int a, int b) const {
  CourseSegment segment = in_common_cell(a, b);
  if (segment.along_side) {
    segment.along_side = middle_height(segment) <= kOnCurve * surface_.mesh().size();
  }
  return segment;
}

CourseSegment SectionCourse::in_common_cell(int a, int b) const {
  const auto straight = [](int cell, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const bool along_side = from.x() == to.x() || from.y() == to.y();
    return CourseSegment{cell, from, to, along_side, false, to - from, to - from};
  };
  const int cell = curve_.cells[a];
  const Eigen::Vector2d &uv_a = curve_.uv[a], &uv_b = curve_.uv[b];
  // Most points are inside a cell, which is the only one then.
  if (curve_.cells[b] == cell && (is_inside_cell(uv_a) || is_inside_cell(uv_b))) {
    return straight(cell, uv_a, uv_b);
  }
  const CellPlaces from = cell_places(surface_.cells(), cell, uv_a);
  const CellPlaces to = cell_places(surface_.cells(), curve_.cells[b], uv_b);
  CourseSegment best{-1, {}, {}, false, false, {}, {}};
  std::optional<double> best_height;
  // Places on sides and at corners are in several cells; if two points have more than one in
  // common, the curve is taken to be in that where the way between them stays nearer to the plane.
  for (const surface::CellPlace& q : to) {
    for (const surface::CellPlace& p : from) {
      if (p.cell != q.cell) continue;
      const CourseSegment segment = straight(p.cell, {p.u, p.v}, {q.u, q.v});
      if (best.cell < 0) {
        best = segment;  // as a rule the only one
        continue;
      }
      if (!best_height) best_height = middle_height(best);
      const double height = middle_height(segment);
      if (height >= *best_height) continue;
      best = segment;
      best_height = height;
    }
  }
  best.is_compared = best_height.has_value();
  return best;
}

// A cubic in (u, v) with the curve's own directions is where Newton's method begins: as a rule one
// step is enough from there.
void SectionCourse::lead(int k) {
  CourseSegment& segment = segments_[k];
  if (segment.cell < 0 || segment.along_side) return;
  const CourseSegment* before = k > 0 ? &segments_[k - 1] : nullptr;
  if (before && before->cell == segment.cell && before->to == segment.from &&
      lengths_[k - 1] > 0.0) {
    // The same direction, of a parameter over another length.
    segment.leaving = lengths_[k] / lengths_[k - 1] * before->reaching;
  } else {
    segment.leaving = slope_at(segment, k, false);
  }
  segment.reaching = slope_at(segment, k, true);
}

Eigen::Vector2d SectionCourse::slope_at(const CourseSegment& segment, int k, bool at_end) const {
  const Eigen::Vector2d& uv = at_end ? segment.to : segment.from;
  const Eigen::Vector2d chord = segment.to - segment.from;
  const Vector3d d1 = lengths_[k] * known(stretch_.first + k + (at_end ? 1 : 0)).tangent;
  surface::SurfaceJet jet;
  surface_.evaluate(segment.cell, uv.x(), uv.y(), 1, jet);
  // The (u, v) whose step along the surface comes nearest to d1: two normal equations.
  const double uu = jet.du.squaredNorm(), mixed = jet.du.dot(jet.dv), vv = jet.dv.squaredNorm();
  const double determinant = uu * vv - mixed * mixed;
  const double along_u = jet.du.dot(d1), along_v = jet.dv.dot(d1);
  const Eigen::Vector2d slope =
      Eigen::Vector2d(vv * along_u - mixed * along_v, uu * along_v - mixed * along_u) / determinant;
  // At an irregular knot there may be none.
  constexpr double kMostTurned = 2.0;  // of the chord
  return slope.allFinite() && slope.norm() <= kMostTurned * chord.norm() ? slope : chord;
}

CurveSample SectionCourse::sample(const Vector3d& tangent, const Vector3d& point,
                                  double curvature) const {
  return {point, tangent, curvature * plane_.normal.cross(tangent), curvature};
}

CurveSample SectionCourse::known(int index) const {
  if (index == stretch_.first) {
    return sample(stretch_.first_tangent, curve_.points[index], stretch_.first_curvature);
  }
  return sample(curve_.tangents[index], curve_.points[index], curve_.curvatures[index]);
}

bool SectionCourse::on_line(const CourseSegment& segment, double fraction,
                            CurveSample& result) const {
  const Eigen::Vector2d step = segment.to - segment.from;
  const Eigen::Vector2d uv = segment.from + fraction * step;
  const surface::SurfaceJet jet = surface_.evaluate(segment.cell, uv.x(), uv.y(), 2);
  const Vector3d d1 = step.x() * jet.du + step.y() * jet.dv;
  // On such a line the mixed derivative has no part.
  const Vector3d d2 = step.x() * step.x() * jet.duu + step.y() * step.y() * jet.dvv;
  const Course course = course_of(d1, d2, plane_.normal);
  result = sample(course.tangent, jet.point, course.curvature);
  return true;
}

bool SectionCourse::on_plane(const CourseSegment& segment, double fraction, const Vector3d& near,
                             const Vector3d& along, CurveSample& result) const {
  const double size = surface_.mesh().size();
  Eigen::Vector2d uv =
      hermite(segment.from, segment.leaving, segment.to, segment.reaching, fraction)
          .cwiseMax(0.0)
          .cwiseMin(1.0);
  surface::SurfaceJet jet;
  double off = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kMostSteps && off > kConverged * size; ++step) {
    surface_.evaluate(segment.cell, uv.x(), uv.y(), 1, jet);
    // Newton's method for the place that is in the plane and square to the chord beside `near`.
    const Eigen::Vector2d missed(plane_.height(jet.point), along.dot(jet.point - near));
    off = missed.norm();
    Eigen::Matrix2d slopes;
    slopes << plane_.normal.dot(jet.du), plane_.normal.dot(jet.dv), along.dot(jet.du),
        along.dot(jet.dv);
    const double determinant = slopes.determinant();
    if (determinant == 0.0) break;
    const Eigen::Vector2d moved = (uv - slopes.inverse() * missed).cwiseMax(0.0).cwiseMin(1.0) - uv;
    if (!moved.allFinite()) break;
    uv += moved;
    if (moved.cwiseAbs().maxCoeff() < kLastStep) break;
  }
  jet = surface_.evaluate(segment.cell, uv.x(), uv.y(), 2);
  if (!(std::abs(plane_.height(jet.point)) <= kOnCurve * size)) return false;
  if (!(std::abs(along.dot(jet.point - near)) <= kOnCurve * size)) return false;
  Course course = level_course(jet, plane_.normal);
  if (course.tangent.isZero(0.0)) return false;
  // A level course has no direction of its own: it runs as the points do.
  if (course.tangent.dot(along) < 0.0) course = {-course.tangent, -course.curvature};
  result = sample(course.tangent, jet.point, course.curvature);
  return true;
}

CurveSample SectionCourse::at(double s) const {
  // Without the first and the last break: the curve's ends are in its first and last segment.
  const auto next = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, s);
  const int k = static_cast<int>(next - breaks_.begin()) - 1;
  const double length = breaks_[k + 1] - breaks_[k];
  if (s <= breaks_[k] || !(length > 0.0)) return known(stretch_.first + k);
  if (s >= breaks_[k + 1]) return known(stretch_.first + k + 1);
  return between(k, (s - breaks_[k]) / length);
}

double SectionCourse::curvature_between(int k, int part, int parts) {
  CourseSegment& segment = segments_[k];
  if (segment.parts != parts) {
    for (int i = 1; i < parts; ++i) {
      segment.part_curvatures[i - 1] = between(k, static_cast<double>(i) / parts).signed_curvature;
    }
    segment.parts = parts;
  }
  return segment.part_curvatures[part - 1];
}

CurveSample SectionCourse::between(int k, double fraction) const {
  const CurveSample a = known(stretch_.first + k), b = known(stretch_.first + k + 1);
  const Vector3d leaving = lengths_[k] * a.tangent, reaching = lengths_[k] * b.tangent;
  const Vector3d near = hermite(a.point, leaving, b.point, reaching, fraction);
  const CourseSegment& segment = segments_[k];
  CurveSample result;
  if (segment.cell >= 0) {
    if (segment.along_side && on_line(segment, fraction, result)) return result;
    const Vector3d along = (b.point - a.point).normalized();
    if (on_plane(segment, fraction, near, along, result)) return result;
  }
  // Across a place at an irregular knot that the section was not followed into.
  const Vector3d tangent = ((1.0 - fraction) * a.tangent + fraction * b.tangent).normalized();
  return sample(tangent, near,
                (1.0 - fraction) * a.signed_curvature + fraction * b.signed_curvature);
}

}  // namespace hull::analysis
