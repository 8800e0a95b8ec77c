// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/corner_net.h"

namespace hull {

// The corner squares around an irregular point, counter-clockwise.
//
// The side u = 0 of a square, its seam, is the side v = 0 of the next one; a fan on a border ends
// with a seam that has no next one.
struct SquareFan {
  std::vector<int> half_edges;    // of LimitSurface::cells(), leaving the point
  std::vector<char> graded;       // whether the surface is only C¹ there: else there is no square
  std::vector<CornerNet> nets;    // of these half-edges, where graded
  std::vector<char> seam_smooth;  // of each square's seam: between squares, and no crease

  int count() const { return static_cast<int>(nets.size()); }
  int after(int i) const { return i + 1 < count() ? i + 1 : 0; }
  int before(int i) const { return i > 0 ? i - 1 : count() - 1; }
};

// The half-edges around a vertex, counter-clockwise, the first at a border if there is one.
std::vector<int> half_edges_around(const Topology& cells, int vertex);

// REQUIRES: the vertex is irregular; of the grading what corner_net() does.
SquareFan square_fan(const LimitSurface& surface, int vertex, const Grading& grading);

// The largest angle (radians) between the normals of neighbours at a smooth seam, at samples of it.
// Where one of them has no normal there is no angle.
double seam_angle(const SquareFan& fan);

// Moves the points of the nets that may be chosen, within the corner squares and so that neighbours
// keep the same border curves, until the angles between normals at the smooth seams are least:
// least squares over samples (Levenberg-Marquardt), moves kept small, the less so the longer the
// angle stays above `enough` (radians). Sides on creases stay. Leaves the fan as it is where
// nothing is gained. Returns seam_angle() afterwards.
//
// `normal_stiffness`: what moves along the normal weigh more than the others, for they are what
// takes the squares off the surface.
double fit_seams(SquareFan& fan, double enough, double normal_stiffness);

}  // namespace hull
