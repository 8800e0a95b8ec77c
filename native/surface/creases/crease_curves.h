// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/creases/crease_chains.h"
#include "surface/creases/cubic_spline.h"
#include "surface/limit_surface.h"

namespace hull::surface {

// A place of a surface; cell -1 is none.
struct CellPlace {
  int cell = -1;
  double u = 0.0, v = 0.0;
};

// A chain of crease or border edges of the control mesh as the curve that the surface has there: a
// cubic B-spline over t from 0 to edge_count(), one a control edge. It is a function of the chain's
// control points alone (Greshake 2021, 5.9), but for ends at darts.
//
// - Between, and all around closed chains, the curve is the uniform cubic B-spline of the chain's
//   control points, with knots at whole t. A closed one has its first three points again at the
//   end.
// - At corners, cone tips and where three or more creases meet the curve ends in the control point.
//   It goes on as a uniform B-spline with the point 2 p - q beyond.
// - A dart follows the smooth rule, so the control edge there is no cubic: it is one on each of the
//   intervals 2^-(k+1) … 2^-k from the dart, with two continuous derivatives between. The spline
//   has these knots, and ends in four knots at the dart, where it is the surface's point. Only the
//   last interval is not the surface's own curve; it departs from it by dart_error() at most.
//   Chains of fewer than four edges that end at a dart have knots at halves or quarters of edges.
class CreaseCurve {
 public:
  // The two half-edges of a control edge, as seen along the curve; -1 beyond a border.
  struct Edge {
    int left, after_left;  // the half-edge along the curve, and the next of its face
    int right, after_right;
  };

  CreaseCurve(CreaseKind kind, bool closed, std::vector<int> vertices, std::vector<Edge> edges,
              CubicSpline spline, double dart_error);

  CreaseKind kind() const { return kind_; }
  bool closed() const { return closed_; }
  // The chain's control vertices, in order; a closed chain's first is not repeated.
  const std::vector<int>& vertices() const { return vertices_; }
  int edge_count() const { return static_cast<int>(edges_.size()); }
  const CubicSpline& spline() const { return spline_; }
  // Bound on the distance from the surface's curve near darts, m; 0 without darts. It is below
  // 1e-14 of the mesh's size, or what the last few numbers t before the chain's end can tell.
  double dart_error() const { return dart_error_; }

  // Position and derivatives by t up to `order` (0, 1, 2). At a dart, where derivatives of the
  // surface's curve do not exist, they are those of the last interval; near it their relative
  // errors are those of positions over the distance. REQUIRES: 0 <= t <= edge_count().
  CurveJet evaluate(double t, int order) const { return spline_.evaluate(t, order); }

  // Where the surface has the curve's point t: in the faces to the left of the curve, and to the
  // right, as seen from outside. No place where a border has no face. REQUIRES: as evaluate().
  CellPlace left(double t) const;
  CellPlace right(double t) const;

 private:
  CreaseKind kind_;
  bool closed_;
  std::vector<int> vertices_;
  std::vector<Edge> edges_;
  CubicSpline spline_;
  double dart_error_;
};

// All chains of the surface: from corner to corner, dart ends, closed ones. A chain with a dart at
// one end starts there.
std::vector<CreaseCurve> crease_curves(const LimitSurface& surface);

}  // namespace hull::surface
