// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/girth_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/arithmetic/gauss.h"
#include "analysis/sections/sections.h"

namespace hull::production {

namespace {

// Of the cubic between two points with unit tangents whose parameter has the speed `scale`.
double cubic_length(const Vector3d& a, const Vector3d& ta, const Vector3d& b, const Vector3d& tb,
                    double scale) {
  static const analysis::GaussRule rule = analysis::gauss_rule(5);
  const Vector3d chord = b - a;
  double length = 0.0;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double t = rule.nodes[k];
    const Vector3d slope = 6.0 * t * (1.0 - t) * chord +
                           scale * ((1.0 - t) * (1.0 - 3.0 * t) * ta + t * (3.0 * t - 2.0) * tb);
    length += rule.weights[k] * slope.norm();
  }
  return length;
}

// The speed is that of the arc length itself.
double arc_length(const Vector3d& a, const Vector3d& ta, const Vector3d& b, const Vector3d& tb) {
  // The length hardly depends on the speed as long as tangents are near the chord.
  double length = (b - a).norm();
  for (int i = 0; i < 4; ++i) length = cubic_length(a, ta, b, tb, length);
  return length;
}

struct Start {
  const analysis::SectionCurve* curve = nullptr;
  int chord = 0;
  double distance = std::numeric_limits<double>::infinity();
};

Start nearest_chord(const std::vector<analysis::SectionCurve>& curves, const Vector3d& p) {
  Start best;
  for (const auto& curve : curves) {
    for (int k = 0; k + 1 < static_cast<int>(curve.points.size()); ++k) {
      const Vector3d a = curve.points[k], chord = curve.points[k + 1] - a;
      const double t = std::clamp((p - a).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
      const double off = (a + t * chord - p).norm();
      if (off < best.distance) best = {&curve, k, off};
    }
  }
  return best;
}

class Walk {
 public:
  Walk(const surface::LimitSurface& surface, const Vector3d& normal)
      : surface_(surface), normal_(normal) {}

  // Tangent of the section at a place, with a part along `way`.
  Vector3d tangent_at(int cell, const Vector2d& uv, const Vector3d& way) const {
    const Vector3d t = normal_.cross(surface_.normal(cell, uv.x(), uv.y())).normalized();
    return t.dot(way) < 0.0 ? Vector3d(-t) : t;
  }

  // On the way from place a along chord k, `length` from a: the step from a to the chord's other
  // end is followed by the section's exact points.
  CellPlace along(const CellPlace& a, const CellPlace& b, double length) const;

 private:
  const surface::LimitSurface& surface_;
  Vector3d normal_;
};

// Newton's method in (u, v): in the plane, and so far along the chord that the arc has the length.
CellPlace Walk::along(const CellPlace& a, const CellPlace& b, double length) const {
  const Vector2d from(a.u, a.v), to(b.u, b.v);
  const Vector3d p = surface_.position(a.cell, a.u, a.v);
  const Vector3d q = surface_.position(b.cell, b.u, b.v);
  const Vector3d chord = (q - p).normalized();
  const double whole = (q - p).norm();
  double wanted = std::min(length, whole);
  Vector2d uv = from + wanted / whole * (to - from);
  // A little within the step, as the surface may have no normal at its end.
  const Vector3d t_a = tangent_at(a.cell, from + 1e-9 * (to - from), chord);
  for (int i = 0; i < 30; ++i) {
    const auto jet = surface_.evaluate(a.cell, uv.x(), uv.y(), 1);
    Eigen::Matrix2d m;
    // The chord's direction stands for the arc's: not quite Newton's matrix, but what it ends at is
    // exact.
    m << normal_.dot(jet.du), normal_.dot(jet.dv), chord.dot(jet.du), chord.dot(jet.dv);
    const double gone = arc_length(p, t_a, jet.point, tangent_at(a.cell, uv, chord));
    const Vector2d off(normal_.dot(jet.point - p), gone - length);
    const Vector2d step = m.fullPivLu().solve(off);
    // A step may lead out of the cell, though the end is within it.
    uv = (uv - step).cwiseMax(0.0).cwiseMin(1.0);
    if (step.norm() <= 1e-14) break;
  }
  return {a.cell, uv.x(), uv.y()};
}

// b's place in a cell that a has, too.
std::optional<std::pair<CellPlace, CellPlace>> in_one_cell(const mesh::Topology& cells,
                                                           const CellPlace& a, const CellPlace& b) {
  for (const CellPlace& one : places_of(cells, a)) {
    for (const CellPlace& other : places_of(cells, b)) {
      if (one.cell == other.cell) return std::pair{one, other};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<CellPlace> girth_point(const surface::LimitSurface& surface, const CellPlace& base,
                                     const Vector3d& normal, const Vector3d& towards, double girth,
                                     double chord_tolerance) {
  const Vector3d p = surface.position(base.cell, base.u, base.v);
  const auto curves = analysis::section(surface, {normal, normal.dot(p)}, chord_tolerance);
  const Start start = nearest_chord(curves, p);
  // The base is on the section, not on its chords.
  if (!start.curve || start.distance > 10.0 * chord_tolerance) return std::nullopt;
  const auto& curve = *start.curve;
  const Walk walk(surface, normal);
  const auto count = static_cast<int>(curve.points.size());
  const auto place = [&curve](int i) {
    return CellPlace{curve.cells[i], curve.uv[i].x(), curve.uv[i].y()};
  };
  const int k = start.chord;
  const Vector3d run = curve.points[k + 1] - curve.points[k];
  // The end of the chord on the wanted side; a base in the section's end has one side only.
  const double near = 1e-9 * run.norm() + 1e-12;
  int step = run.dot(towards) >= 0.0 ? 1 : -1;
  if (curve.closed == false && std::abs(run.normalized().dot(towards)) < 1e-6) {
    if ((p - curve.points.front()).norm() <= near) step = 1;
    if ((p - curve.points.back()).norm() <= near) step = -1;
  }
  int next = step > 0 ? k + 1 : k;
  CellPlace at = base;
  Vector3d from = p;
  double left = girth;
  // Once around a closed section at most.
  for (int passed = 0; passed <= count; ++passed) {
    const Vector3d to = curve.points[next];
    if ((to - from).norm() > near) {
      const Vector3d way = to - from;
      const auto pair = in_one_cell(surface.cells(), at, place(next));
      if (!pair) return std::nullopt;
      const auto& [a, b] = *pair;
      const Vector2d ua(a.u, a.v), ub(b.u, b.v);
      const double length = arc_length(from, walk.tangent_at(a.cell, ua + 1e-9 * (ub - ua), way),
                                       to, walk.tangent_at(b.cell, ub - 1e-9 * (ub - ua), way));
      if (length >= left) return walk.along(a, b, left);
      left -= length;
    }
    at = place(next);
    from = to;
    if (next + step < 0 || next + step >= count) {
      if (!curve.closed) return std::nullopt;
      // A closed section has its first point again at the end, which is passed over.
      next = step > 0 ? 0 : count - 1;
    }
    next += step;
  }
  return std::nullopt;
}

}  // namespace hull::production
