// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion/piece_moments.h"
#include "surface/eigenbasis/corner_basis.h"

namespace hull::analysis {

// The oriented area ∫ n dS of a square with one irregular corner as a quadratic form of its control
// points, ∑ G_ij q_i x q_j, exact. The square is its outer ring and the square that is left, whose
// points are A q: G = G_ring + Aᵀ G A, a Stein equation (compare Hakenberg & Reif 2016, volumes of
// sets bounded by subdivision surfaces).
class AreaForm {
 public:
  explicit AreaForm(const surface::CornerBasis& basis);
  Vector3d operator()(const std::vector<Vector3d>& points) const;

 private:
  std::vector<double> above_;  // G's entries above the diagonal times two: G is antisymmetric
};

// What is known beforehand of the moments of the rings around a corner: they are sums of geometric
// series, whose ratios are products of the local matrix's eigenvalues. Of each kind the largest,
// falling: two positions make a normal, further factors come from the positions of moments; and of
// the area's excess over that of its projection along the corner's normal, which is quadratic in
// the normals' deviations.
struct CornerSeries {
  explicit CornerSeries(const surface::CornerBasis& basis);

  AreaForm area_form;
  std::vector<double> excess_ratios, first_ratios, second_ratios;
};

// How the moments of what lies around a corner are summed: how much they may be off, m³ for the
// first and m² for the area (infinite: it is not computed), and the rules for the outermost ring
// and for all others.
struct CornerRules {
  double first, area;
  SpanRule outer, inner;
};

// Moments of all that `ring`, which walks around a corner of `points`, has still to pass, positions
// counted from `origin`. Rings are summed, and the sums extrapolated by their known ratios
// (Richardson 1911), until that settles; ∫ n dS is exact. The ring is left at the last of them.
ShellMoments corner_moments(surface::CornerRing& ring, const surface::CornerBasis& basis,
                            const surface::CornerPoints& points, const CornerSeries& series,
                            const Vector3d& origin, const CornerRules& rules);

}  // namespace hull::analysis
