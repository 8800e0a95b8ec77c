// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/curvature.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace hull::surface {

Curvature curvature_of(const SurfaceJet& jet) {
  Curvature result;
  const Vector3d normal = unit_normal(jet.du, jet.dv);
  if (normal.isZero(0.0)) return result;
  // In an orthonormal frame of the tangent plane, (du dv) = frame T, the second fundamental form is
  // T^-T (second derivatives along the normal) T^-1, a symmetric matrix whose eigenvalues are the
  // principal curvatures (do Carmo 1976, 3-3).
  const Vector3d e1 = jet.du.normalized(), e2 = normal.cross(e1);
  // T is upper triangular, as e1 lies along du; its determinant is |du x dv|, which is not zero
  // here.
  Eigen::Matrix2d T, second;
  T << e1.dot(jet.du), e1.dot(jet.dv), 0.0, e2.dot(jet.dv);
  // The normal points to the side that positive curvature bulges to.
  second << -normal.dot(jet.duu), -normal.dot(jet.duv), -normal.dot(jet.duv), -normal.dot(jet.dvv);
  const Eigen::Matrix2d inverse = T.inverse();
  const Eigen::Matrix2d shape = inverse.transpose() * second * inverse;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(shape);
  result.minimum = solver.eigenvalues()[0];
  result.maximum = solver.eigenvalues()[1];
  const auto in_space = [&](int i) -> Vector3d {
    return solver.eigenvectors()(0, i) * e1 + solver.eigenvectors()(1, i) * e2;
  };
  result.minimum_direction = in_space(0);
  result.maximum_direction = in_space(1);
  result.defined = true;
  return result;
}

Curvature curvature(const LimitSurface& surface, int cell, double u, double v) {
  const bool at_knot = surface.is_irregular_knot(cell, u, v);
  if (at_knot) {
    // Irregular knots are corners of cells: the offset leads inwards.
    u = u > 0.5 ? 1.0 - kKnotOffset : kKnotOffset;
    v = v > 0.5 ? 1.0 - kKnotOffset : kKnotOffset;
  }
  Curvature result = curvature_of(surface.evaluate(cell, u, v, 2));
  result.at_irregular_knot = at_knot;
  return result;
}

}  // namespace hull::surface
