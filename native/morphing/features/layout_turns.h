// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/reshape/surface_places.h"
#include "surface/limit_surface.h"
#include "surface/queries/closest_point.h"
#include "surface/queries/surface_tree.h"

namespace hull::morphing {

// Where a layout that lies on another hull is turned over against it: places whose normal is turned
// by a right angle or more against that at the foot on the hull. Beside a knuckle or border of the
// hull the faces of both of its sides are asked, for the foot may be on the one face where the
// layout has the other one.
class LayoutTurns {
 public:
  // `hull` must outlive it.
  explicit LayoutTurns(const surface::LimitSurface& hull);

  const surface::LimitSurface& hull() const { return hull_; }

  // The feet of a layout's places on the hull.
  std::vector<surface::ClosestPoint> feet(const modelling::SurfacePlaces& layout) const;

  // Such places of a layout, of which these are the feet(), rising; those farther than kNearHull of
  // the hull's size from it tell nothing.
  std::vector<int> turned(const modelling::SurfacePlaces& layout,
                          const std::vector<surface::ClosestPoint>& feet) const;
  std::vector<int> turned(const modelling::SurfacePlaces& layout) const {
    return turned(layout, feet(layout));
  }
  static constexpr double kNearHull = 5e-3;

 private:
  // A piece of a crease or border, straight, with the normals of the faces on its sides; zero where
  // a border has no face.
  struct Piece {
    Vector3d begin, end, left, right;
  };
  bool is_beside_its_face(const Vector3d& place, const Vector3d& normal, double distance) const;

  const surface::LimitSurface& hull_;
  surface::SurfaceTree tree_;
  std::vector<Piece> pieces_;
};

}  // namespace hull::morphing
