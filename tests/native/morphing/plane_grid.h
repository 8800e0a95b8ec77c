// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "morphing/parametrisation/triangle_disc.h"

namespace hull::morphing {

// Points of whole numbers from 0 to n, row by row, each square cut by a rising diagonal, but every
// third one by a falling one.
inline TriangleDisc plane_grid(int n) {
  std::vector<Vector3d> points;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) points.emplace_back(x, y, 0.0);
  }
  std::vector<Triangle> triangles;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
      if ((x + 2 * y) % 3 == 0) {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      } else {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      }
    }
  }
  return {points, triangles};
}

}  // namespace hull::morphing
