// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "analysis/arithmetic/bezier.h"
#include "surface/pieces/pieces.h"

namespace hull::analysis {

// The plane n·x = offset; n of unit length. A point is below where n·x < offset.
struct Plane {
  Vector3d normal;
  double offset;
  double height(const Vector3d& p) const { return normal.dot(p) - offset; }
};

// Height above the plane over a piece, heights below `tolerance` in absolute value taken for zero.
BezierBicubic heights(const surface::BicubicPoints& points, const Plane& plane, double tolerance);

// Bounds of the height over the square left at an irregular knot.
std::array<double, 2> height_range(const surface::CornerSquare& square, const Plane& plane);

// A square of a piece on one side of the plane, or cut so simply that for each u (or, if `swapped`,
// for each v) the surface meets the plane at most once, and not at a grazing angle.
struct CutSquare {
  enum class Side { kBelow, kAbove, kCut } side;
  double u, v, size;     // in the piece's square [0, 1]^2
  bool swapped;          // roles of u and v exchanged in `height`
  BezierBicubic height;  // over the square; what follows holds after the exchange
};

// Squares of 2^-deepest of the piece that are still not simple are given as cut all the same,
// `swapped` for the better of the two directions: there the surface touches the plane or has a
// saddle on it. Where it touches along a line there are 2^deepest of them.
inline constexpr int kDeepestCut = 12;

namespace plane_cut_internal {

enum class Shape { kBelow, kAbove, kSimple, kSimpleSwapped, kTangled };
Shape shape_of(const BezierBicubic& height, bool deepest);

template <class Visit>
void divide(const BezierBicubic& height, double u, double v, double size, int deepest,
            const Visit& visit) {
  using Side = CutSquare::Side;
  switch (shape_of(height, deepest == 0)) {
    case Shape::kBelow:
      return visit(CutSquare{Side::kBelow, u, v, size, false, height});
    case Shape::kAbove:
      return visit(CutSquare{Side::kAbove, u, v, size, false, height});
    case Shape::kSimple:
      return visit(CutSquare{Side::kCut, u, v, size, false, height});
    case Shape::kSimpleSwapped:
      return visit(CutSquare{Side::kCut, u, v, size, true, height.transposed()});
    case Shape::kTangled:
      break;
  }
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      divide(height.quarter(i, j), u + 0.5 * size * i, v + 0.5 * size * j, 0.5 * size, deepest - 1,
             visit);
    }
  }
}

}  // namespace plane_cut_internal

// Divides a piece into such squares and calls visit(const CutSquare&) for each.
template <class Visit>
void cut_piece(const BezierBicubic& height, const Visit& visit, int deepest = kDeepestCut) {
  plane_cut_internal::divide(height, 0.0, 0.0, 1.0, deepest, visit);
}

// Where, along the parameter v of a square, the surface meets the plane, by its height along v at
// one u, which is monotonic. Without a change of sign: the end nearer to the plane.
double crossing(const BezierCubic& column);

// The values of u at which the crossing enters or leaves the square, with 0 and 1 as first and
// last: between two of them the square either has a crossing for every u or for none.
using Breaks = SmallList<double, 8>;
Breaks crossing_breaks(const BezierBicubic& height);

}  // namespace hull::analysis
