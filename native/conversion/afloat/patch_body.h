// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/immersion/immersion.h"
#include "conversion/afloat/patch_pieces.h"

namespace hull::conversion {

// A set of patches as the shell of a floating body, closed from its borders by straight
// athwartships lines to the centre plane, as a deck and a transom close it. Volume, its moments and
// the waterplane are exact but for rounding where the water does not cut, and to about 1e-13 of
// the whole where it does; the wetted surface to about 1e-9.
class PatchBody {
 public:
  // `mirrored`: the set is the port half (y >= 0) and counts twice. `pieces` must outlive the body.
  // Throws std::invalid_argument where a border is not closed by such lines (one that on a half
  // hull nowhere meets the centre plane, and on a whole one is not as far to port as to
  // starboard), telling where; and where patches are turned inwards.
  PatchBody(const PatchPieces& pieces, bool mirrored);

  // Of both sides; the wetted surface without closings. Throws std::invalid_argument if the plane
  // is not finite.
  analysis::Immersion immersion(const analysis::Plane& water) const;

 private:
  struct Part {
    surface::BicubicPoints points;
    bool is_cap;
    analysis::ShellMoments moments;
    Vector3d middle, half;  // the box around the points, from the centre
  };

  void add(const surface::BicubicPoints& points, bool is_cap);
  void close(const std::vector<EdgeUse>& loop);
  analysis::ShellMoments wet(const analysis::Plane& water) const;

  const PatchPieces& pieces_;
  bool mirrored_;
  Vector3d centre_;
  double size_;
  std::vector<Part> parts_;
};

}  // namespace hull::conversion
