// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <limits>

#include "surface/pieces/bicubic.h"

namespace hull::surface {

// A bicubic span by its Bézier points, whose convex hull holds it: coordinate k of point (i, j), i
// along u, is x[k][4 j + i]. Laid out for sums over all sixteen at once.
struct BezierPatch {
  alignas(32) double x[3][16];

  static BezierPatch from_bspline(const BicubicPoints& points);

  Vector3d point(int index) const { return {x[0][index], x[1][index], x[2][index]}; }
  Eigen::AlignedBox3d box() const;
  // Halves along u (axis 0) or v (axis 1): [0, ½] and [½, 1].
  void split(int axis, BezierPatch& low, BezierPatch& high) const;
};

// Position and all derivatives up to the second at (u, v) in [0, 1]^2.
SurfaceJet evaluate(const BezierPatch& patch, double u, double v);
// Position and first derivatives only; the others are left as they are.
void evaluate_first(const BezierPatch& patch, double u, double v, SurfaceJet& jet);

// What is known of a patch S without a query. Parameters are here scaled to unit speed in the mean:
// U = su u, V = sv v.
struct PatchShape {
  Vector3d centre;  // mean of the control points
  double su = 0.0, sv = 0.0;
  // |S(x) - S(y)|² >= stretch |x - y|² for any two places x, y; zero where no such bound was found.
  double stretch = 0.0;
  // |r · (second derivative of S in any direction)| <= bend |r|, 1/m.
  double bend = 0.0;
};

PatchShape shape_of(const BezierPatch& patch);

// Whether no point of the patch is nearer to p than the foot F = p - r, a local minimum of the
// distance over the unit square (at its sides, derivatives point outwards). For any other point S,
// |S - p|² - |F - p|² = |S - F|² - 2 r · (S - F); the last term is no more than the second
// derivatives allow, as the first ones do not let it grow. False says nothing.
bool is_least(const BezierPatch& patch, const PatchShape& shape, const Vector3d& r);

// A rectangle [u, u + du] x [v, v + dv] of a patch's domain.
struct PatchPart {
  double u = 0.0, v = 0.0, du = 1.0, dv = 1.0;

  // The lower (i = 0) or upper (1) half across u (axis = 0) or v (1), as BezierPatch::split() cuts.
  PatchPart half(int axis, int i) const {
    PatchPart part = *this;
    if (axis == 0) {
      part.du *= 0.5;
      part.u += i * part.du;
    } else {
      part.dv *= 0.5;
      part.v += i * part.dv;
    }
    return part;
  }
};

}  // namespace hull::surface
