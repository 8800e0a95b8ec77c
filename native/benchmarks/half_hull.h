// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "mesh/control_mesh.h"

namespace hull::benchmarks {

// A half hull of 14 stations by 10 points (140 points, 117 faces): flat bottom, bilge, flat side,
// knuckle and a fan of triangles at the stem, so that it has irregular points of several kinds.
// `refine` multiplies the number of faces in each direction. One in `halved_every` faces is two
// triangles: twelve make a foreign hull of it, with thousands of irregular corners where it is
// refined; 12 · refine² leave as many as there are on 140 points.
inline mesh::MeshArrays half_hull(int refine = 1, int halved_every = 12) {
  const int stations = 13 * refine, girth = 9 * refine;
  mesh::MeshArrays mesh;
  for (int i = 0; i <= stations; ++i) {
    const double s = static_cast<double>(i) / stations;
    // None at the stem, which is in the centre plane.
    const double fullness =
        i < stations ? std::pow(std::sin(3.14159265 * (0.12 + 0.88 * s)), 0.45) : 0.0;
    for (int j = 0; j <= girth; ++j) {
      const double t = static_cast<double>(j) / girth;
      const double y = 9.0 * fullness * std::pow(std::sin(1.5707963 * t), 0.6);
      mesh.points.emplace_back(100.0 * s, t > 0.0 ? y : 0.0, 10.0 * t * t);
    }
  }
  const auto at = [girth](int i, int j) { return i * (girth + 1) + j; };
  for (int i = 0; i < stations; ++i) {
    for (int j = 0; j < girth; ++j) {
      const int corners[] = {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)};
      // Some quadrilaterals are halved: points of valence 3, 5 and 6, and triangles.
      if ((i + 2 * j) % halved_every == 5) {
        mesh.face_sizes.insert(mesh.face_sizes.end(), {3, 3});
        mesh.face_vertices.insert(mesh.face_vertices.end(), {corners[0], corners[1], corners[2],
                                                             corners[0], corners[2], corners[3]});
        continue;
      }
      mesh.face_sizes.push_back(4);
      mesh.face_vertices.insert(mesh.face_vertices.end(), corners, corners + 4);
    }
  }
  for (int i = stations / 2; i < stations; ++i) {
    mesh.creases.push_back({at(i, 6 * refine), at(i + 1, 6 * refine)});
  }
  return mesh;
}

}  // namespace hull::benchmarks
