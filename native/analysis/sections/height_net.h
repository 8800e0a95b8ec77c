// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "analysis/arithmetic/bezier_net.h"
#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// Heights below `zero` are rounding; those up to `flat` (at least `zero`) may be: a span or a side
// that lies as near to the plane as that lies in it. m.
struct HeightTolerances {
  double zero, flat;

  bool operator==(const HeightTolerances&) const = default;
};

// The height of a piece above a plane, h = u^a (1-u)^b v^c (1-v)^d g: the sides of the piece that
// lie in the plane are divided out, each as often as the height vanishes there. What is left, g,
// has the section's other arcs for zeros, and they cross the sides at an angle again.
struct HeightNet {
  BezierNet net;                 // g; coefficients of rounding size are zero
  std::array<bool, 4> in_plane;  // the sides v = 0, u = 1, v = 1, u = 0
  bool divided;                  // some side is in the plane; else g is the height itself
  bool flat;                     //  all of it lies in the plane; then nothing is divided out

  // g along a side, in the direction of rising u or v.
  BezierCubic along(int side) const;
};

// `may_lie` tells which sides may be taken for lying in the plane; the whole piece if all may.
using SideFlags = std::array<bool, 4>;
inline constexpr SideFlags kAllSides{true, true, true, true};
HeightNet height_net(const surface::BicubicPoints& points, const Plane& plane,
                     const HeightTolerances& tolerances, const SideFlags& may_lie);

// Value and derivatives up to the second of a net on [0, 1]^2.
struct HeightJet {
  double u, v, uu, uv, vv;  // derivatives
};
HeightJet height_jet(const BezierNet& net, double u, double v);

}  // namespace hull::analysis
