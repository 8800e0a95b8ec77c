// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "morphing/parametrisation/triangle_disc.h"

namespace hull::morphing {

// What an inner point of a parametrised disc is to its neighbours: their mean with weights.
enum class WeightKind {
  kShapePreserving,  // Floater 1997: plane meshes keep their shape
  kMeanValue,        // Floater 2003: the same, and smooth in the points
  kUniform           // Tutte 1963: for comparison; no regard to shape
};

struct NeighbourWeight {
  int point;
  double weight;
};

// The neighbours of an inner point, in order around it, with weights that are not negative and add
// up to 1.
//
// Shape-preserving: the triangles around the point are laid flat, edges with their lengths and
// angles scaled to 2 pi together (Floater 1997; Kang & Lee 2012, equations 1 and 2), where each
// neighbour with the two opposite to it has barycentric weights (4, 7), of which the mean is taken
// (12). Triangles without area may be among them.
// Mean values: (tan(a / 2) + tan(b / 2)) / r with the angles on both sides of an edge of length r.
//
// Throws std::invalid_argument for a point all of whose triangles are without area, and for mean
// values beside a triangle whose angle at the point is pi.
//
// REQUIRES: the point is no border point.
std::vector<NeighbourWeight> neighbour_weights(const TriangleDisc& disc, int point,
                                               WeightKind kind);

}  // namespace hull::morphing
