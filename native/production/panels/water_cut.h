// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>

#include "production/grid/hull_grid.h"

namespace hull::production {

// The part of a grid below the water. Its points are the grid's, moved to the water's surface where
// they are near it, and the exact points at which sides of quadrilaterals pass it.
class WaterCut {
 public:
  // REQUIRES: the grid has places. `surface` and `grid` must outlive the cut.
  WaterCut(const surface::LimitSurface& surface, const HullGrid& grid, const analysis::Plane& water,
           const surface::Progress& progress = {});

  // The points that panels have, and whether each is in the water's surface.
  const std::vector<Vector3d>& points() const { return points_; }
  bool in_water_plane(int point) const { return label_[point] == 0; }

  // Counter-clockwise from the water; the last corner of a triangle is there twice. None has three
  // different corners in the water's surface, lies in it, or is a line.
  const std::vector<std::array<int, 4>>& panels() const { return panels_; }

 private:
  struct Crossing {
    int point;
    double part;  // of the side from its end of the lower number, in the parameters
  };
  using Polygon = std::vector<int>;

  Vector3d on_side(int quad, int side, double t) const;
  void find_labels();
  void find_crossings(const surface::Progress& progress);
  void move_to_water();
  void cut_quad(int quad);
  void cut_across(int quad, const Polygon& polygon);
  void add_polygon(Polygon polygon);
  void add_panel(const Polygon& polygon);
  double least_angle(const Polygon& polygon) const;
  const Crossing* crossing(int a, int b) const;

  const surface::LimitSurface& surface_;
  const HullGrid& grid_;
  analysis::Plane water_;
  std::vector<Vector3d> points_;
  std::vector<signed char> label_;  // of points: -1 in the water, 0 in its surface, 1 above
  std::unordered_map<std::uint64_t, Crossing> crossings_;  // by the side's two points
  std::vector<std::array<int, 4>> panels_;
};

}  // namespace hull::production
