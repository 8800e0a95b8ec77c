// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/square_pieces.h"

namespace hull::modelling {

std::vector<Eigen::MatrixXd> square_pieces(const surface::SurfaceSquares::Kind& kind) {
  if (!kind.basis) return {kind.spread};
  std::vector<Eigen::MatrixXd> pieces;
  Eigen::MatrixXd square =
      Eigen::MatrixXd::Identity(kind.basis->point_count(), kind.basis->point_count());
  for (int ring = 0; ring < surface::kPlainRings; ++ring) {
    for (const surface::RingSegment& segment : kind.basis->segments()) {
      pieces.push_back(segment.rows * square);
    }
    // The points of the square that is half as large, once subdivided, by those of the first.
    square = kind.basis->matrix() * square;
  }
  return pieces;
}

}  // namespace hull::modelling
