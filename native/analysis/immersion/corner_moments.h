// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion/piece_moments.h"
#include "surface/corner_basis.h"

namespace hull {

// The oriented area ∫ n dS of a square with one irregular corner as a quadratic form of its control
// points, ∑ G_ij q_i x q_j, exact. The square is its outer ring and the square that is left, whose
// points are A q: G = G_ring + Aᵀ G A, a Stein equation (compare Hakenberg & Reif 2016, volumes of
// sets bounded by subdivision surfaces).
class AreaForm {
 public:
  explicit AreaForm(const CornerBasis& basis);
  Vector3d operator()(const std::vector<Vector3d>& points) const;

 private:
  Eigen::MatrixXd G_;
};

// What is known beforehand of the moments of the rings around a corner: they are sums of geometric
// series, whose ratios are products of the local matrix's eigenvalues.
struct CornerSeries {
  explicit CornerSeries(const CornerBasis& basis);

  AreaForm area_form;
  std::vector<double> area_ratios;    // the largest of areas (products of two), falling
  std::vector<double> first_ratios;   // … of first moments (of three) …
  std::vector<double> second_ratios;  // … and of second moments (of four)
};

// How much the moments of what lies around a corner may be off: m³ for the first, m² for the area.
struct CornerTolerance {
  double first, area;
};

// Moments of all that `ring` has still to pass, positions counted from `origin`. Rings are summed,
// and the sums extrapolated by their known ratios (Richardson), until that settles; ∫ n dS is
// exact. The ring is left where that was.
ShellMoments corner_moments(CornerRing& ring, const CornerBasis& basis, const CornerSeries& series,
                            const Vector3d& origin, const CornerTolerance& tolerance);

}  // namespace hull
