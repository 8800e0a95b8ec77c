// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/patch_set.h"
#include "surface/limit_surface.h"

namespace hull {

// Measures patches of one knot vector in both directions against a surface; see FitReport for what
// the distance is.
//
// Samples are the same for every patch: (intervals + 1)^2 points, borders included, that crowd
// towards the borders and corners, where the surface is least like a polynomial.
class PatchGauge {
 public:
  // The surface must outlive the gauge. REQUIRES: clamped cubic knots, intervals >= 1.
  PatchGauge(const LimitSurface& surface, const std::vector<double>& knots, int intervals);

  // Adds a patch to a report that holds what the former calls of this gauge put there.
  // REQUIRES: the patch has the gauge's knots, and patch.cell is a cell of the surface.
  void measure(const BSplinePatch& patch, FitReport& report);

 private:
  const LimitSurface& surface_;
  double negligible_;  // metres; below this no closer point is looked for
  std::vector<double> nodes_;
  Eigen::MatrixXd basis_;  // (nodes, control points)
  double sum_of_squares_ = 0.0;
};

}  // namespace hull
