// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/edge_development.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "analysis/arithmetic/gauss.h"

namespace hull::production {

namespace {

constexpr int kNodes = 8;

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
    // Values at the nodes become coefficients of Legendre's polynomials, whose integrals are known.
    up_to = integrals * powers.inverse();
  }
};

const Collocation& collocation() {
  static const Collocation made;
  return made;
}

// The normal at an end, where derivatives may not exist.
Vector3d normal_at(const surface::LimitSurface& surface, int cell, const Vector2d& uv) {
  return surface.normal(cell, uv.x(), uv.y());
}

// The unit tangent nearest to a direction.
Vector3d tangent_along(const Vector3d& direction, const Vector3d& normal) {
  return (direction - direction.dot(normal) * normal).normalized();
}

}  // namespace

PlaneFrame first_frame(const surface::LimitSurface& surface, const CurveStep& step) {
  const Vector3d chord = surface.position(step.cell, step.to.x(), step.to.y()) -
                         surface.position(step.cell, step.from.x(), step.from.y());
  return {tangent_along(chord, normal_at(surface, step.cell, step.from)), 0.0, Vector2d::Zero()};
}

PlaneFrame rolled(const surface::LimitSurface& surface, const CurveStep& step,
                  const PlaneFrame& start) {
  const Collocation& c = collocation();
  const Vector2d way = step.to - step.from;
  Eigen::Matrix<double, kNodes, 1> turn;
  std::array<Vector3d, kNodes> speed, e1, e2;
  for (int i = 0; i < kNodes; ++i) {
    const Vector2d uv = step.from + c.rule.nodes[i] * way;
    const auto jet = surface.evaluate(step.cell, uv.x(), uv.y(), 2);
    const Vector3d across = jet.du.cross(jet.dv), n = across.normalized();
    const Vector3d du = jet.duu * way.x() + jet.duv * way.y();
    const Vector3d dv = jet.duv * way.x() + jet.dvv * way.y();
    // But for a part along n, which is of no account below.
    const Vector3d turning = (du.cross(jet.dv) + jet.du.cross(dv)) / across.norm();
    // e1 is a - (a n) n, normed, of the start's one tangent a: e1' e2 is -(a n) n' e2 over its
    // length. No frame goes on from node to node.
    const double off = start.along.dot(n);
    const Vector3d flat = start.along - off * n;
    e1[i] = flat.normalized();
    e2[i] = n.cross(e1[i]);
    turn[i] = -off * turning.dot(e2[i]) / flat.norm();
    speed[i] = jet.du * way.x() + jet.dv * way.y();
  }
  // At the nodes, from the start's angle; the rate does not depend on them.
  const Eigen::Matrix<double, kNodes, 1> angles = c.up_to * turn;
  PlaneFrame end{tangent_along(start.along, normal_at(surface, step.cell, step.to)), start.angle,
                 start.at};
  // Across lines where pieces of the surface meet the rule is not exact: what it lacks of the chord
  // is added.
  Vector3d lacking = surface.position(step.cell, step.to.x(), step.to.y()) -
                     surface.position(step.cell, step.from.x(), step.from.y());
  const auto laid = [&](int i, const Vector3d& v) {
    return Vector2d(Eigen::Rotation2Dd(start.angle + angles[i]) *
                    Vector2d(v.dot(e1[i]), v.dot(e2[i])));
  };
  for (int i = 0; i < kNodes; ++i) {
    const double weight = c.rule.weights[i];
    end.angle += weight * turn[i];
    end.at += weight * laid(i, speed[i]);
    lacking -= weight * speed[i];
  }
  end.at += laid(kNodes / 2, lacking);
  return end;
}

}  // namespace hull::production
