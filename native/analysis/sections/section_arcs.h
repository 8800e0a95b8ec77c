// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/sections/plane_cut.h"

namespace hull {

// A point of a section and where it lies.
struct SectionPoint {
  Vector3d point;
  int cell;
  Eigen::Vector2d uv;
};

// A part of a section within one simply cut square: both ends lie on the square's border.
using SectionArc = std::vector<SectionPoint>;

// The arcs of a piece, sampled so that no chord is further than `chord_tolerance` from the curve.
std::vector<SectionArc> section_arcs(const SurfacePiece& piece, const Plane& plane,
                                     double zero_tolerance, double chord_tolerance);

// Joins arcs end to end where ends lie within `tolerance` of each other, nearest first.
struct JoinedArcs {
  std::vector<SectionPoint> points;
  std::vector<int> joints;  // indices of points where two arcs met
  bool closed;              // the first point is repeated at the end
};
std::vector<JoinedArcs> join_arcs(const std::vector<SectionArc>& arcs, double tolerance);

}  // namespace hull
