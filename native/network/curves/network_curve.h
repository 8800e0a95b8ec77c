// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "network/curves/nurbs_curve.h"

namespace hull::network {

// Points n·x = d.
struct CarrierPlane {
  Vector3d normal;
  double distance;
};

// How a curve of a network begins or ends.
struct EndCondition {
  enum class Kind {
    kFree,
    kTangent,         // along a direction
    kStraight,        // without curvature
    kSlaveTangent,    // along the tangent of a master there
    kSlaveCurvature,  // and curved as it is
  };
  Kind kind = Kind::kFree;
  Vector3d direction = Vector3d::Zero();  // along the curve, at its start and at its end
  int master = -1;                        // the number of a curve
};

// What a curve of a network is said to be.
struct CurveDefinition {
  enum class Kind {
    kFree,
    kLine,   // two points
    kArc,    // three points, or two with a direction at the start
    kConic,  // two points with directions at both ends
  };
  std::string name;
  Kind kind = Kind::kFree;
  std::vector<Vector3d> points;  // two or more
  std::vector<double> weights;   // of the points; none: 1
  std::vector<int> knuckles;     // numbers of points between the ends, rising
  double deviation = 0.0;        // mean, m, of free curves from their points; 0 interpolates
  double fullness = 1.0;         // of conics
  EndCondition start, end;
  std::optional<CarrierPlane> plane;  // that it stays in
};

// What it is: from knuckle to knuckle a curve.
struct CurveShape {
  std::vector<NurbsCurve> pieces;
  double error = 0.0;  // E = Σ w |f(t) - q|², m²
};

// The shapes of curves, masters before their slaves. Free curves are smooth_curve() with knots at
// points, over chord lengths: cubic, quintic with a curvature given, a polynomial where there are
// fewer points; first and last points and knuckles are met. A master's tangent is taken where it is
// nearest to its slave's end, in the sense in which the slave leaves there; of curves in planes the
// part in the plane.
//
// Throws std::invalid_argument that names the curve: for slaves in a circle, for an end further
// than `tolerance`, m, from its master, for points as far off the plane, and for what the kind does
// not allow.
std::vector<CurveShape> network_curve_shapes(const std::vector<CurveDefinition>& definitions,
                                             double tolerance);

}  // namespace hull::network
