// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/pieces.h"

#include <Eigen/Geometry>

namespace hull::surface {

double CornerSquare::extent() const {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points()) box.extend(p);
  return box.diagonal().norm();
}

namespace pieces_internal {

// The reverse of turned() in place_in_cell.h, of the square's corner that is lower left afterwards.
DomainSquare turned_square(int turn, const DomainSquare& s) {
  switch (turn) {
    case 0:
      return s;
    case 1:
      return {1.0 - s.v - s.size, s.u, s.size};
    case 2:
      return {1.0 - s.u - s.size, 1.0 - s.v - s.size, s.size};
    default:
      return {s.v, 1.0 - s.u - s.size, s.size};
  }
}

BicubicPoints turned_points(int turn, const BicubicPoints& seen) {
  if (turn == 0) return seen;
  BicubicPoints points;
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) {
      // Point (a, b) of the square's own grid is (i, j) of the one as seen: turned() on the grid.
      const int i = turn == 1 ? b : turn == 2 ? 3 - a : 3 - b;
      const int j = turn == 1 ? 3 - a : turn == 2 ? 3 - b : a;
      points[4 * b + a] = seen[4 * j + i];
    }
  }
  return points;
}

DomainSquare within(const DomainSquare& outer, const DomainSquare& inner) {
  return {outer.u + outer.size * inner.u, outer.v + outer.size * inner.v, outer.size * inner.size};
}

}  // namespace pieces_internal
}  // namespace hull::surface
