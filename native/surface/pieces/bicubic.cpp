// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/bicubic.h"

#include <Eigen/Geometry>

#include "surface/wide_code.h"

namespace hull::surface {

Vector3d unit_normal(const Vector3d& du, const Vector3d& dv) {
  // Cross products shorter than this times the lengths of their factors have no direction.
  constexpr double kParallel = 1e-12;
  const Vector3d normal = du.cross(dv);
  const double length = normal.norm();
  if (!(length > kParallel * du.norm() * dv.norm())) return Vector3d::Zero();
  return normal / length;
}

void scale_derivatives(SurfaceJet& jet, double factor, int order) {
  if (order < 1 || factor == 1.0) return;
  jet.du *= factor;
  jet.dv *= factor;
  if (order < 2) return;
  const double square = factor * factor;
  jet.duu *= square;
  jet.duv *= square;
  jet.dvv *= square;
}

namespace {

// Four points, x y z after one another, and a number to let four of them be loaded at any.
struct PaddedColumn {
  double lane[13];
};

// Sum over the rows of the grid: what is left is a cubic along u.
inline PaddedColumn along_v(const double* p, const Basis& w) {
  PaddedColumn sum;
  for (int k = 0; k < 12; ++k) {
    sum.lane[k] = w[0] * p[k] + w[1] * p[12 + k] + w[2] * p[24 + k] + w[3] * p[36 + k];
  }
  sum.lane[12] = 0.0;
  return sum;
}

inline void along_u(const PaddedColumn& c, const Basis& w, Vector3d& out) {
  double sum[4];  // a whole vector; the last number has no meaning
  for (int k = 0; k < 4; ++k) {
    sum[k] =
        (w[0] * c.lane[k] + w[1] * c.lane[3 + k]) + (w[2] * c.lane[6 + k] + w[3] * c.lane[9 + k]);
  }
  out = Vector3d(sum[0], sum[1], sum[2]);
}

template <int kOrder>
HULL_WIDE void evaluate_order(const double* points, double u, double v, SurfaceJet& jet) {
  const Basis bu = cubic_basis(u);
  const PaddedColumn c = along_v(points, cubic_basis(v));
  along_u(c, bu, jet.point);
  if constexpr (kOrder > 0) {
    const Basis du = cubic_basis_d1(u);
    const PaddedColumn c_v = along_v(points, cubic_basis_d1(v));
    along_u(c, du, jet.du);
    along_u(c_v, bu, jet.dv);
    if constexpr (kOrder > 1) {
      const PaddedColumn c_vv = along_v(points, cubic_basis_d2(v));
      along_u(c, cubic_basis_d2(u), jet.duu);
      along_u(c_v, du, jet.duv);
      along_u(c_vv, bu, jet.dvv);
    }
  }
}

}  // namespace

void evaluate_bicubic(const BicubicPoints& points, double u, double v, int order, SurfaceJet& jet) {
  const double* numbers = points[0].data();
  if (order == 0) {
    evaluate_order<0>(numbers, u, v, jet);
  } else if (order == 1) {
    evaluate_order<1>(numbers, u, v, jet);
  } else {
    evaluate_order<2>(numbers, u, v, jet);
  }
}

}  // namespace hull::surface
