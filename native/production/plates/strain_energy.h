// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/plates/plate_chart.h"
#include "production/plates/plate_mesh.h"
#include "production/plates/sheet_splines.h"

namespace hull::production {

// A smooth map of the plate to the plane: cubic B-splines of the chart's coordinates.
struct SheetMap {
  PlateChart chart;
  SheetSplines splines;
  std::vector<Eigen::Vector2d> coefficients;

  Eigen::Vector2d place(const Vector3d& point) const;
  // Derivatives of the plane's point by lengths along the tangents, one in a column.
  Eigen::Matrix2d slopes(const PlatePoint& point) const;
};

// How the search for the least energy ended.
struct LeastEnergy {
  double energy = 0.0;  // m²; of a sheet with E / (2 (1 - ν²)) t = 1
  int iterations = 0;
  bool converged = false;
};

// The energy of flat_plate.h made least, from the map's coefficients on. The points are those by
// which the energy is integrated. `is_near`: the map has about the least energy already.
LeastEnergy make_energy_least(SheetMap& map, const std::vector<PlatePoint>& points, double poisson,
                              bool is_near);

}  // namespace hull::production
