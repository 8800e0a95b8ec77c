// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/pieces/bicubic.h"

namespace hull::analysis {

// A point of a section, where it lies and how the section runs through it.
struct SectionPoint {
  Vector3d point = Vector3d::Zero();
  Vector3d tangent = Vector3d::Zero();  // unit
  double curvature = 0.0;               // in the plane, 1/m; positive where the section turns left
  int cell = -1;
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
};

// A stretch of a section: points first … last - 1 of those collected.
struct SectionArc {
  int first, last;
  enum class Sense {
    kDirected,   // runs with what is above the plane on its left, seen from the water
    kFollowing,  // where there is only a flat: as given, unless arcs that it is joined to want else
    kEither      // both sides of it are above the plane, or both below
  } sense;
  bool along_side = false;  // lies on sides of pieces instead of crossing them
};

// A place around an irregular knot that was not looked into: arcs that end in it meet there.
struct SectionSpot {
  SectionPoint knot;  // without tangent
  double radius;      // m
  double height;      // of the knot above the plane, m
};

// What is found of one section, in no order.
struct SectionParts {
  std::vector<SectionPoint> points;
  std::vector<SectionArc> arcs;
  std::vector<SectionSpot> spots;

  void clear() {
    points.clear();
    arcs.clear();
    spots.clear();
  }
};

}  // namespace hull::analysis
