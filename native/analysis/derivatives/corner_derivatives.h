// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/derivatives/gradient.h"
#include "surface/eigenbasis/corner_basis.h"

namespace hull::analysis {

// Derivatives by the outer points of a square with one irregular corner. goes_on(points) is asked
// of each square that is left around the corner, from the whole one on, by its control points,
// whether the next ring is wanted; add_span(points, columns) adds the derivatives by the 16 points
// of a span. Square k has the points Aᵏ q, so what is known by them comes back by Aᵀ.
template <class GoesOn, class AddSpan>
PointColumns corner_derivatives(const surface::CornerBasis& basis,
                                const surface::CornerPoints& points, Eigen::Index columns,
                                const GoesOn& goes_on, const AddSpan& add_span) {
  std::vector<PointColumns> rings;
  for (surface::CornerRing ring(basis, points); goes_on(ring.points()); ring.advance()) {
    PointColumns sum = PointColumns::Zero(basis.point_count(), columns);
    for (int s = 0; s < basis.segment_count(); ++s) {
      PointColumns by_points = PointColumns::Zero(16, columns);
      add_span(ring.segment_points(s), by_points);
      sum += basis.segments()[s].rows.transpose() * by_points;
    }
    rings.push_back(std::move(sum));
  }
  PointColumns total = PointColumns::Zero(basis.point_count(), columns);
  for (auto ring = rings.rbegin(); ring != rings.rend(); ++ring) {
    total = (basis.matrix().transpose() * total + *ring).eval();
  }
  return total;
}

}  // namespace hull::analysis
