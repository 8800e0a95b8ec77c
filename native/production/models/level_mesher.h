// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "production/models/triangle_tree.h"
#include "surface/progress.h"

namespace hull::production {

struct LevelMesh {
  std::vector<Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
  int parts = 0;  // that are apart from one another
};

// The surface in which a body's inner points have a given distance from its triangles, on a grid of
// cubes (hollow.h).
class LevelMesher {
 public:
  LevelMesher(const ClosedModel& model, const TriangleTree& tree, double distance, double cell);

  // Cubes that the surface may pass: distances change no faster than places, so that a cube whose
  // middle is further from the level than its corners from the middle can't, and neither can its
  // parts.
  void find_cells(const surface::Progress& progress);

  // Triangles within tetrahedra, normals towards what is further from the body's surface.
  LevelMesh mesh(const surface::Progress& progress);

 private:
  struct Cell {
    std::array<int, 3> at;
    double near;  // a distance within which the cell's corners have the surface
  };

  // Of the side of a tetrahedron that has a point of the level: one end is on either side of it.
  struct Ends {
    Vector3d low, high;
    double low_value, high_value;
    Vector3d between(double share) const { return low + share * (high - low); }
  };

  void descend(const std::array<int, 3>& at, int size, double near, double begin, double end,
               const surface::Progress& progress);
  Vector3d place(const std::array<int, 3>& at) const;
  double value_at(const std::array<int, 3>& at, double near);
  int point_between(const std::array<int, 3>& low, double low_value, int way, double high_value);
  void add_tetrahedron(const Cell& cell, const std::array<int, 3>& order, bool even);
  void keep_inner();
  void move_onto_level(const surface::Progress& progress);

  const ClosedModel& model_;
  const TriangleTree& tree_;
  double distance_, cell_;
  Vector3d origin_;
  std::vector<Cell> cells_;
  std::unordered_map<std::uint64_t, double> values_;  // by node
  std::unordered_map<std::uint64_t, int> between_;    // points, by lower node and direction
  LevelMesh mesh_;
  std::vector<Ends> ends_;  // by point
};

}  // namespace hull::production
