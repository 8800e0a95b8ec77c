// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/pieces/surface_squares.h"

namespace hull::modelling {

// The 16 B-spline points of the pieces of a square, by its points: of a leaf, or, ring by ring, of
// the kPlainRings rings around an irregular knot.
std::vector<Eigen::MatrixXd> square_pieces(const surface::SurfaceSquares::Kind& kind);

}  // namespace hull::modelling
