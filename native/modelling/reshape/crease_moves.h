// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/creases/crease_curves.h"
#include "surface/limit_surface.h"

namespace hull::modelling {

// How the control points of a chain of creases or borders move: as prescribed points of a Reshape
// they bring the crease where it is wanted, whatever the surface beside it does.
struct CreaseMoves {
  // Of the chain, in its order; a corner where it both begins and ends is there once.
  std::vector<int> points;
  std::vector<Vector3d> moves;  // m
  double distance;              // of the curve then from where it was wanted, at most, m …
  double t;                     // … and where
};

// The moves by which the curve's points at each of `t` shift by the `shifts`, m: with the least sum
// of squared distances, the shortest of several. As the curve is the cubic B-spline of its own
// control points, shifts that are one of its knots are met to rounding; of others the distance is
// told. The ends of an open chain are met in any case where t names them, as other creases begin
// there. `staying`: control points that do not move, if they are of the chain; the others do what
// they can.
//
// Throws std::invalid_argument where there is not a shift for each t, for a t that is not of the
// curve, for what is not finite, and for a chain that ends in a dart, which depends on points
// beside it.
CreaseMoves crease_moves(const surface::LimitSurface& surface, const surface::CreaseCurve& curve,
                         const std::vector<double>& t, const std::vector<Vector3d>& shifts,
                         const std::vector<int>& staying = {});

// How far the curve's points at each of `t` shift, m, where the control points of its chain, as
// of crease_moves(), move by `moves`, m: each by itself, whatever the surface beside it does.
// Throws as crease_moves(), and where there is not a move for each control point.
std::vector<Vector3d> crease_shifts(const surface::LimitSurface& surface,
                                    const surface::CreaseCurve& curve, const std::vector<double>& t,
                                    const std::vector<Vector3d>& moves);

}  // namespace hull::modelling
