// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/bicubic.h"

#include <Eigen/Geometry>

namespace hull {

Vector3d unit_normal(const Vector3d& du, const Vector3d& dv) {
  // Cross products shorter than this times the lengths of their factors have no direction.
  constexpr double kParallel = 1e-12;
  const Vector3d normal = du.cross(dv);
  const double length = normal.norm();
  if (!(length > kParallel * du.norm() * dv.norm())) return Vector3d::Zero();
  return normal / length;
}

void scale_derivatives(SurfaceJet& jet, double factor) {
  jet.du *= factor;
  jet.dv *= factor;
  const double square = factor * factor;
  jet.duu *= square;
  jet.duv *= square;
  jet.dvv *= square;
}

Basis cubic_basis(double t) {
  const double s = 1.0 - t;
  return {s * s * s / 6.0, 2.0 / 3.0 - t * t + t * t * t / 2.0, 2.0 / 3.0 - s * s + s * s * s / 2.0,
          t * t * t / 6.0};
}

Basis cubic_basis_d1(double t) {
  const double s = 1.0 - t;
  return {-s * s / 2.0, t * (1.5 * t - 2.0), -s * (1.5 * s - 2.0), t * t / 2.0};
}

Basis cubic_basis_d2(double t) {
  const double s = 1.0 - t;
  return {s, 3.0 * t - 2.0, 3.0 * s - 2.0, t};
}

SurfaceJet evaluate_bicubic(const BicubicPoints& points, double u, double v, int order) {
  const Basis bu = cubic_basis(u), bv = cubic_basis(v);
  const Basis du = order > 0 ? cubic_basis_d1(u) : Basis{};
  const Basis dv = order > 0 ? cubic_basis_d1(v) : Basis{};
  const Basis duu = order > 1 ? cubic_basis_d2(u) : Basis{};
  const Basis dvv = order > 1 ? cubic_basis_d2(v) : Basis{};
  SurfaceJet jet;
  for (int b = 0; b < 4; ++b) {
    const Vector3d* row = &points[4 * b];
    const auto along = [row](const Basis& w) -> Vector3d {
      return w[0] * row[0] + w[1] * row[1] + w[2] * row[2] + w[3] * row[3];
    };
    const Vector3d p = along(bu);
    jet.point += bv[b] * p;
    if (order < 1) continue;
    const Vector3d p_u = along(du);
    jet.du += bv[b] * p_u;
    jet.dv += dv[b] * p;
    if (order < 2) continue;
    jet.duu += bv[b] * along(duu);
    jet.duv += dv[b] * p_u;
    jet.dvv += dvv[b] * p;
  }
  return jet;
}

}  // namespace hull
