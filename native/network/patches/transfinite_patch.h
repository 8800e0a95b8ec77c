// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "network/patches/ribboned_side.h"

namespace hull::network {

// The surface within a ring of sides with their tangent ribbons (Koelman 1999, 2.3.1, 2.3.3.2 and
// 5.4.1.3):
//
// - four sides: Coons' bicubic patch (Coons 1967) with Gregory's twists (Gregory 1982), over the
//   unit square. It reproduces bicubic surfaces.
// - three, and five and more: corner patches u_j = d_(j-1) / (d_(j-1) + d_(j+1)), v_j = d_j /
//   (d_(j-2) + d_j), d the distances from the sides of a regular polygon in the unit circle,
//   weighted by the squared distances from the sides that are not at the corner, with Gregory's
//   twists. They meet sides and ribbons, but reproduce no more than planes.
// - two: three, the longer one being halved; at that place, where the two halves go on
//   in one line, the patch has no ribbon to meet.
//
// It is an affine function of its sides, and passes through them exactly; its tangent planes there
// are those of slope and ribbon. Immutable.
class TransfinitePatch {
 public:
  // Throws std::invalid_argument for fewer than two and more than ten sides, for sides whose ends
  // are further apart than 1e-9 of the patch's size, and for ribbons that differ as far, of their
  // length, from the neighbouring side's slope.
  explicit TransfinitePatch(std::vector<RibbonedSide> sides);

  // The corners of the domain, counterclockwise; side i goes from corner i to the next, by shares.
  // A patch of two sides has three.
  const std::vector<Vector2d>& domain() const { return domain_; }
  int side_count() const { return static_cast<int>(sides_.size()); }

  // REQUIRES: a place within the domain, or on its border. Derivatives at corners of patches
  // without four sides are those of the corner patch.
  PatchPoint at(const Vector2d& place) const;
  // The same at many places, in a fraction of the time where they are those of a grid: each side is
  // evaluated once at each of its parameters.
  std::vector<PatchPoint> at_all(const std::vector<Vector2d>& places) const;

 private:
  void check() const;

  std::vector<RibbonedSide> sides_;
  std::vector<Vector2d> domain_;
};

}  // namespace hull::network
