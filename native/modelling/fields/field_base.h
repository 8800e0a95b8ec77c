// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "mesh/vectors.h"
#include "modelling/fields/field_curve.h"
#include "surface/limit_surface.h"
#include "surface/queries/infinity.h"

namespace hull::modelling {

// Where a field is based: what it is at a point of space.
struct BaseFoot {
  double distance;          // m, to the closest point of the base
  Vector3d distance_slope;  // by the point: a unit vector, or zero on the base itself
  double length;            // along the base, m; 0 where that is no curve
  Vector3d length_slope;    // by the point
};

// The base of a field: a point, a curve, a plane or a region of a surface. None need be on the
// hull.
//
// Where several points of a base are the closest the distance has a kink and what varies along the
// base may jump: keep the extent below the distance at which that begins.
class FieldBase {
 public:
  virtual ~FieldBase() = default;

  // Without the length, which takes longer than all else, it is 0. A foot farther than `within`, m,
  // need not be found: its distance is infinite then.
  virtual BaseFoot foot_within(const Vector3d& p, bool with_length, double within) const = 0;
  BaseFoot foot(const Vector3d& p, bool with_length) const {
    return foot_within(p, with_length, surface::kInfinity);
  }
  // Whether the other is the same set of points, given alike.
  virtual bool is_same(const FieldBase& other) const = 0;
  // Whether all of it is in the centre plane, within `near`, m.
  virtual bool is_in_centre_plane(double near) const = 0;
  // Whether it has a rim inside which the distance is 0 all over a surface: there the square of
  // the distance, smooth about a point or a curve, has a second derivative that jumps.
  virtual bool has_rim() const { return false; }
};

// Throws std::invalid_argument for what is no number.
std::shared_ptr<const FieldBase> point_base(const Vector3d& point);
// The plane through a point, square to a normal of any length but zero.
std::shared_ptr<const FieldBase> plane_base(const Vector3d& point, const Vector3d& normal);
std::shared_ptr<const FieldBase> curve_base(FieldCurve curve);
// Cells of a surface as it is now; see surface::SurfaceTree.
std::shared_ptr<const FieldBase> region_base(const surface::LimitSurface& surface,
                                             const std::vector<int>& cells);

}  // namespace hull::modelling
