// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/blossom.h"

namespace hull::conversion {

surface::Basis blossom_weights(double a, double b, double c) {
  // De Boor's algorithm for the knots -2 ... 3, multiplied out: the first round at a, then b, then
  // c.
  const double a0 = (1.0 - a) / 3.0, a1 = 1.0 - a0, a2 = (2.0 - a) / 3.0, a3 = 1.0 - a2,
               a4 = (3.0 - a) / 3.0, a5 = 1.0 - a4;
  const double b0 = (1.0 - b) / 2.0, b1 = 1.0 - b0, b2 = (2.0 - b) / 2.0, b3 = 1.0 - b2;
  const double c0 = 1.0 - c, c1 = c;
  return {c0 * b0 * a0, c0 * (b0 * a1 + b1 * a2) + c1 * b2 * a2,
          c0 * b1 * a3 + c1 * (b2 * a3 + b3 * a4), c1 * b3 * a5};
}

Vector3d blossom(const surface::BicubicPoints& points, const surface::Basis& along_u,
                 const surface::Basis& along_v) {
  Vector3d sum = Vector3d::Zero();
  for (int b = 0; b < 4; ++b) {
    Vector3d row = Vector3d::Zero();
    for (int a = 0; a < 4; ++a) row += along_u[a] * points[4 * b + a];
    sum += along_v[b] * row;
  }
  return sum;
}

}  // namespace hull::conversion
