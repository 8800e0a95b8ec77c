// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of triangles, dot by dot: pictures of surfaces by their own points and normals.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace hull::drawing {

// Triangles with numbers at their corners, `count` of them by point.
struct ValuedTriangles {
  std::vector<Eigen::Vector3d> points;  // in dots: x to the right, y down, z towards the eye
  std::vector<float> values;            // count by point
  int count;
  std::vector<std::array<int, 3>> triangles;
};

struct SeenValues {
  std::vector<int> dots;      // those that show a triangle, row by row from above
  std::vector<float> values;  // count by dot
};

// The numbers at the middles of width times height dots, each of the triangle that is nearest to
// the eye there, linear between its corners. Triangles are seen from either side.
//
// REQUIRES: triangles of points that there are, count values for each point, all finite, and no
// more dots than an int counts.
SeenValues seen_values(const ValuedTriangles& given, int width, int height);

}  // namespace hull::drawing
