// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/plates/plate_mesh.h"

namespace hull::production {

// How the search for the least energy ended.
struct LeastEnergy {
  std::vector<Eigen::Vector2d> nodes;
  double energy = 0.0;  // m²; of a sheet with E / (2 (1 - ν²)) t = 1
  int iterations = 0;
  bool converged = false;
};

// The energy of flat_plate.h made least, from these nodes on.
LeastEnergy least_energy(const PlateMesh& mesh, std::vector<Eigen::Vector2d> nodes, double poisson);

// Derivatives of the plane's point by lengths along two orthogonal unit tangents, one in a column.
Eigen::Matrix2d plane_slopes(const ElementPoint& point, const PlateMesh::Element& element,
                             const std::vector<Eigen::Vector2d>& nodes);

}  // namespace hull::production
