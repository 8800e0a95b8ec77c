// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "surface/pieces/bicubic_basis.h"

namespace hull::analysis {

// A place of a span with what the span's points count for there.
struct SpanNode {
  using Weights = Eigen::Matrix<double, 16, 1>;
  Weights at, du, dv;
  Vector3d point, along_u, along_v, normal;  // the normal is S_u x S_v

  SpanNode(const surface::BicubicPoints& points, double u, double v) {
    const surface::Basis a = surface::cubic_basis(u), b = surface::cubic_basis(v);
    at = surface::bicubic_basis(a, b);
    du = surface::bicubic_basis(surface::cubic_basis_d1(u), b);
    dv = surface::bicubic_basis(a, surface::cubic_basis_d1(v));
    point = along_u = along_v = Vector3d::Zero();
    for (int k = 0; k < 16; ++k) {
      point += at[k] * points[k];
      along_u += du[k] * points[k];
      along_v += dv[k] * points[k];
    }
    normal = along_u.cross(along_v);
  }
};

}  // namespace hull::analysis
