// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/patches/edge_uses.h"

namespace hull::conversion {

// A set of bicubic patches cut at all knots: what sections and volumes are computed of.
class PatchPieces {
 public:
  struct Piece {
    int patch;
    double u, v, width, height;     // [u, u + width] x [v, v + height] of the patch
    surface::BicubicPoints points;  // as one span of a uniform B-spline surface
  };

  // Throws std::invalid_argument as PatchSet::check() does, and naming a patch that is not bicubic.
  explicit PatchPieces(const PatchSet& set);
  PatchPieces(const PatchPieces&) = delete;
  PatchPieces& operator=(const PatchPieces&) = delete;

  const std::vector<Piece>& pieces() const { return pieces_; }
  // The pieces as patches, in the same order, and where their edges are.
  const PatchSet& set() const { return set_; }
  const EdgeUses& uses() const { return uses_; }
  double size() const { return size_; }

 private:
  PatchSet set_;
  EdgeUses uses_;
  double size_;
  std::vector<Piece> pieces_;
};

// A cubic's points from its Bézier points: those of a span of a uniform B-spline.
std::array<Vector3d, 4> uniform_points(const std::array<Vector3d, 4>& bezier);
surface::BicubicPoints uniform_points(const std::array<Vector3d, 16>& bezier);

}  // namespace hull::conversion
