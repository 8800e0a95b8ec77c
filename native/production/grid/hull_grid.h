// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "analysis/immersion/hull_body.h"
#include "production/grid/side_points.h"
#include "surface/progress.h"

namespace hull::production {

// Where a quadrilateral lies on the surface, or on its mirror image.
struct QuadPlace {
  int cell = -1;  // -1: on none, it is part of a closing
  bool image = false;
  std::array<Eigen::Vector2d, 4> uv;  // of its corners in the cell
};

// A hull's shell, and the surfaces that close it to a body, divided into quadrilaterals that share
// their points: where both sides are there every side of a quadrilateral belongs to two of them,
// run through in opposite directions. A corner may be there twice, one after the other: triangles.
struct HullGrid {
  std::vector<Vector3d> points;           // m
  std::vector<std::array<int, 4>> quads;  // counter-clockwise, seen from the water
  std::vector<QuadPlace> places;          // of each, if they were asked for
  // Sides along creases and borders, of the shell and its mirror image.
  std::vector<std::array<int, 2>> knuckles;
};

// The straight lines by which an opening is closed, from the border to where they end.
using ClosingLines = std::vector<std::array<Vector3d, 2>>;

struct GridOptions {
  bool both_sides = true;  // of a half hull: with its mirror image; else the port half, whose
                           // closings end in the centre plane
  bool places = false;
  // In how many parts closing lines are divided; one if it is not given.
  std::function<int(const ClosingLines&)> parts_across;
  surface::Progress progress;  // of the shell's cells
};

// The closings are those of the body (closings.h of analysis), made of the straight lines at the
// points of the border. Points of the border within kOnCentrePlane of the centre plane of a half
// hull are put on it, and both sides share them.
//
// Throws std::invalid_argument where an opening that is closed to a plane of its own crosses this
// more than twice.
HullGrid hull_grid(const analysis::HullBody& body, const SidePoints& sides,
                   const GridOptions& options);

}  // namespace hull::production
