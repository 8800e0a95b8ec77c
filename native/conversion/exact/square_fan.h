// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/exact/corner_net.h"

namespace hull::conversion {

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
std::vector<int> half_edges_around(const mesh::Topology& cells, int vertex);

// REQUIRES: the vertex is irregular; of the grading what corner_net() does.
SquareFan square_fan(const surface::LimitSurface& surface, int vertex, const Grading& grading);

// The largest angle (radians) between the normals of neighbours at a smooth seam, at samples of it.
// Where one of them has no normal there is no angle.
double seam_angle(const SquareFan& fan);

}  // namespace hull::conversion
