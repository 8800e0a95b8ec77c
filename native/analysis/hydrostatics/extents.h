// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "analysis/sections/cell_boxes.h"
#include "analysis/sections/plane_cut.h"
#include "surface/limit_surface.h"

namespace hull::analysis {

// The point of a surface that is farthest in some direction.
struct FarthestPoint {
  bool found = false;  // false where there is no such part of the surface
  double value = -std::numeric_limits<double>::infinity();  // direction·point, m
  Vector3d point = Vector3d::Zero();
  int cell = -1;
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
};

// Extremes of a surface in water: of its part below the plane, or of the curve in which it meets
// the plane, to 1e-10 of the mesh's size. Bounds from control points exclude what can't be farther
// than what is known; of what is left, immersed places where the coordinate is stationary are found
// by bounds on its slopes, and extremes along sides of pieces and along the waterline where its
// derivative vanishes. Two extremes within an eighth of a simply cut square of the waterline may be
// missed. Where several points are equally far, the one nearest to the centre plane among those
// that were looked at.
class ExtentSearch {
 public:
  enum class Part { kImmersed, kWaterline };

  // `surface` and its boxes must outlive the search.
  ExtentSearch(const surface::LimitSurface& surface, const CellBoxes& boxes, const Plane& water);

  FarthestPoint farthest(const Vector3d& direction, Part part) const;

 private:
  // The cells that may have such a part.
  const std::vector<int>& cells(Part part) const {
    return part == Part::kImmersed ? immersed_ : waterline_;
  }

  const surface::LimitSurface* surface_;
  const CellBoxes* boxes_;
  Plane water_;
  double size_;
  std::vector<int> immersed_, waterline_;
};

}  // namespace hull::analysis
