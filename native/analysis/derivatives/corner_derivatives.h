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
  using PointRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const surface::SparseRows& refinement = basis.refinement();
  std::vector<PointRows> rings;  // by the points of one subdivision
  PointColumns by_span(16, columns);
  for (surface::CornerRing ring(basis, points); goes_on(ring.points()); ring.advance()) {
    PointRows& by_refined = rings.emplace_back(PointRows::Zero(refinement.count(), columns));
    for (int s = 0; s < basis.segment_count(); ++s) {
      by_span.setZero();
      add_span(ring.segment_points(s), by_span);
      const std::array<int, 16>& rows = basis.segment_rows(s);
      for (int i = 0; i < 16; ++i) by_refined.row(rows[i]) += by_span.row(i);
    }
  }
  PointRows total = PointRows::Zero(basis.point_count(), columns);
  for (auto ring = rings.rbegin(); ring != rings.rend(); ++ring) {
    for (int i = 0; i < basis.point_count(); ++i) ring->row(basis.next_square()[i]) += total.row(i);
    total.setZero();
    refinement.add_back(ring->data(), static_cast<int>(columns), total.data());
  }
  return total;
}

}  // namespace hull::analysis
