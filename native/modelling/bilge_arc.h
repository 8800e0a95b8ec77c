// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull::modelling {

inline constexpr int kFewestBilgePoints = 3, kMostBilgePoints = 8;

// What the border of a flat is, at which the section's bilge begins or ends.
struct BilgeBorder {
  enum class Kind {
    kTouching,  // a crease where the circle touches the flat
    kBest,      // a crease where the section comes nearest to line and circle: a little further out
    kSmooth     // no crease; the next control point, in the flat, stays where it is
  };
  Kind kind = Kind::kTouching;
  double outer = 0.0;  // kSmooth: how far that point is from where the circle touches, in radii
};

// Control points of a section's bilge, from the border of the flat bottom to that of the flat side;
// for the circle of radius 1 around the origin. The section touches the bottom below the origin, at
// (0, -1), comes from (-1, -1), and turns left by `angle`. In between the curve is the cubic
// B-spline that sections of the surface are where the sections beside have the same control points.
struct BilgeArc {
  std::vector<Eigen::Vector2d> points;  // count + 2
  double deviation;                     // largest distance from the rounded section, in radii
  double least_curvature;               // of the middle half of the curve, in 1/radius
  double greatest_curvature;            // of the whole curve; at the borders it is 0
};

// The arc whose largest deviation is the least: `count` points between the borders, the first in
// the plane of the bottom and the last in that of the side, so that the section leaves these
// without a knuckle. A minimax fit by Lawson's weights (1961), to about 1e-3 of the deviation.
//
// Throws std::invalid_argument unless count is kFewestBilgePoints to kMostBilgePoints, the angle
// (radians) between 10 and 170 degrees, and outer points a twentieth of the radius away or more,
// but not so far (two radii and more, for six points) that control points would overtake one
// another.
BilgeArc bilge_arc(int count, double angle, const BilgeBorder& bottom = {},
                   const BilgeBorder& side = {});

}  // namespace hull::modelling
