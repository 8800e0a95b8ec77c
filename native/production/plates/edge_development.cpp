// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/edge_development.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "analysis/arithmetic/gauss.h"

namespace hull::production {

using Eigen::Vector2d;

namespace {

constexpr int kNodes = 8;
// At irregular corners there are no derivatives: tangents are taken so far beside them.
constexpr double kBeside = 1e-7;

// Nodes, weights, and the integrals of the nodes' Lagrange polynomials up to each node.
struct Collocation {
  analysis::GaussRule rule = analysis::gauss_rule(kNodes);
  Eigen::Matrix<double, kNodes, kNodes> up_to;
  Collocation() {
    Eigen::Matrix<double, kNodes, kNodes> powers, integrals;
    for (int i = 0; i < kNodes; ++i) {
      const double c = 2.0 * rule.nodes[i] - 1.0;
      double before = 0.0, p0 = 1.0, p1 = c;
      // Legendre's polynomials, whose integrals are differences of others.
      for (int k = 0; k < kNodes; ++k) {
        const double p2 = ((2.0 * k + 3.0) * c * p1 - (k + 1.0) * p0) / (k + 2.0);
        powers(i, k) = p0;
        integrals(i, k) = k == 0 ? 0.5 * (c + 1.0) : 0.5 * (p1 - before) / (2.0 * k + 1.0);
        before = p0;
        p0 = p1;
        p1 = p2;
      }
    }
    up_to = integrals * powers.inverse();
  }
};

const Collocation& collocation() {
  static const Collocation made;
  return made;
}

struct Tangents {
  Vector3d e1, e2, normal;
};

// e1 along S_u, or S_v where `by_v`.
Tangents tangents(const surface::SurfaceJet& jet, bool by_v) {
  Tangents t;
  t.normal = jet.du.cross(jet.dv).normalized();
  t.e1 = (by_v ? jet.dv : jet.du).normalized();
  t.e2 = t.normal.cross(t.e1);
  return t;
}

bool is_along_v(const surface::LimitSurface& surface, const CurveStep& step) {
  const Vector2d m = 0.5 * (step.from + step.to);
  const auto jet = surface.evaluate(step.cell, m.x(), m.y(), 1);
  return jet.dv.squaredNorm() > jet.du.squaredNorm();
}

Tangents at_end(const surface::LimitSurface& surface, const CurveStep& step, bool at_to,
                bool by_v) {
  Vector2d uv = at_to ? step.to : step.from;
  if (surface.is_irregular_knot(step.cell, uv.x(), uv.y())) {
    uv += kBeside * ((at_to ? step.from : step.to) - uv);
  }
  return tangents(surface.evaluate(step.cell, uv.x(), uv.y(), 1), by_v);
}

// Of b seen from a, both tangents, counter-clockwise.
double angle_from(const Vector3d& a, const Vector3d& b, const Vector3d& normal) {
  return std::atan2(normal.dot(a.cross(b)), a.dot(b));
}

}  // namespace

PlaneFrame first_frame(const surface::LimitSurface& surface, const CurveStep& step) {
  return {at_end(surface, step, false, is_along_v(surface, step)).e1, 0.0, Vector2d::Zero()};
}

PlaneFrame rolled(const surface::LimitSurface& surface, const CurveStep& step,
                  const PlaneFrame& start) {
  const Collocation& c = collocation();
  const bool by_v = is_along_v(surface, step);
  const Tangents begin = at_end(surface, step, false, by_v);
  const double angle = start.angle + angle_from(start.along, begin.e1, begin.normal);
  const Vector2d way = step.to - step.from;
  Eigen::Matrix<double, kNodes, 1> turn;
  std::array<Vector2d, kNodes> speed;
  for (int i = 0; i < kNodes; ++i) {
    const Vector2d uv = step.from + c.rule.nodes[i] * way;
    const auto jet = surface.evaluate(step.cell, uv.x(), uv.y(), 2);
    const Tangents t = tangents(jet, by_v);
    const Vector3d along = jet.du * way.x() + jet.dv * way.y();
    const Vector3d& side = by_v ? jet.dv : jet.du;
    const Vector3d change = by_v ? Vector3d(jet.duv * way.x() + jet.dvv * way.y())
                                 : Vector3d(jet.duu * way.x() + jet.duv * way.y());
    turn[i] = change.dot(t.e2) / side.norm();
    speed[i] = {along.dot(t.e1), along.dot(t.e2)};
  }
  const Eigen::Matrix<double, kNodes, 1> angles = c.up_to * turn;
  PlaneFrame end{at_end(surface, step, true, by_v).e1, angle, start.at};
  for (int i = 0; i < kNodes; ++i) {
    end.angle += c.rule.weights[i] * turn[i];
    end.at += c.rule.weights[i] * (Eigen::Rotation2Dd(angle + angles[i]) * speed[i]);
  }
  return end;
}

}  // namespace hull::production
