// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "network/patches/transfinite_patch.h"
#include "network/splines/side_spline.h"

namespace hull::network {

// A side of one of a region's patches: along edges of the network, or along the region's spoke of a
// number, which goes from the middle of the region's side of that number to its centre.
struct QuadBorder {
  std::vector<EdgePiece> pieces;
  int spoke = -1;
  bool is_inwards = true;
};

// Patches of a region: one where it has four sides; else one at each corner, around a centre.
struct RegionQuads {
  std::vector<conversion::BSplinePatch> patches;
  double spoke_error = 0.0;  // m, of splines along spokes
};

// The sides between which a region's patches are: each of one curve, so that it has no kink.
struct RegionLayout {
  RegionLayout(const NetworkFrame& frame, const std::vector<RegionSide>& given);

  std::vector<RegionSide> sides;
  bool is_single;  // one patch, because the region has four sides, none of which was cut
};

// Of its patches.
std::vector<std::array<QuadBorder, 4>> quad_borders(const NetworkFrame& frame,
                                                    const RegionLayout& layout);

struct RegionInput {
  std::shared_ptr<const NetworkFrame> frame;
  const EdgeSplines& edges;
  double tolerance;  // m, of splines along spokes
  int spans;
};

// Of a single patch the target is the region's TransfinitePatch. Of others it is a BorderPlate's
// surface, where the border is a graph over a plane and quads around its centroid cover it without
// folds, and a TransfinitePatch where not. Throws std::invalid_argument for what then has none.
RegionQuads region_quads(const RegionInput& input, const RegionLayout& layout);

}  // namespace hull::network
