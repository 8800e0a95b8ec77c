// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "surface/pieces/bicubic.h"

namespace hull::surface {

// How far a surface can be from the quadrilaterals that stand for it, however these are cut into
// two triangles each. Bounds are certain, from control points; they are meant to be sharp where the
// surface is smooth, whatever its parametrisation: points may slide along the quadrilateral.

// Bézier points (index 4 j + i, i along u) of the part [u0, u1] x [v0, v1] of a uniform span.
BicubicPoints bezier_points(const BicubicPoints& span, double u0, double u1, double v0, double v1);

// Of a bicubic patch by its Bézier points, cut into nu x nv equal parts: bound on the distance of
// any point of a part from the part's own quadrilateral, m. Along a line of length h in a
// parameter, sag is no more than h² / 8 times the second derivative's part across the chord; that
// along the chord only slides. The mixed derivative bends a quadrilateral by h k / 4 of its part
// along the normal. Where directions turn too much for this, nothing slides.
double smooth_bound(const BicubicPoints& bezier, int nu, int nv);

// Distances from one quadrilateral: a convex function of the point, so that its largest value over
// control points bounds it for the surface in their convex hull.
class QuadGauge {
 public:
  // Corners in order around it; they need not be in a plane, nor distinct.
  explicit QuadGauge(const std::array<Vector3d, 4>& corners);

  // At least the distance of p from the two triangles, for either diagonal.
  double bound(const Vector3d& p) const;

 private:
  double distance_in_plane(const Eigen::Vector2d& q) const;

  std::array<Vector3d, 4> corners_;
  bool flat_enough_ = false;  // has an outline in the plane of its diagonals' directions
  Vector3d centre_, e1_, e2_, normal_;
  double half_height_ = 0.0;              // of the corners over that plane
  std::vector<Eigen::Vector2d> outline_;  // in it, counter-clockwise, convex
  double dent_ = 0.0;                     // how deep the fourth corner lies within the outline
};

}  // namespace hull::surface
