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

// Of its patches.
std::vector<std::array<QuadBorder, 4>> quad_borders(const NetworkFrame& frame,
                                                    const std::vector<RegionSide>& sides);

struct RegionInput {
  std::shared_ptr<const NetworkFrame> frame;
  const EdgeSplines& edges;
  double tolerance;  // m, of splines along spokes
  int spans;
};

// Within sides of a region that has a TransfinitePatch, `patch`. With four sides the target of the
// patch is that. With others it is a BorderPlate's surface, where the border is a graph over a
// plane and quads around its centroid cover it without folds, and the TransfinitePatch where not.
// Throws std::invalid_argument for two sides where it is not.
RegionQuads region_quads(const RegionInput& input, const std::vector<RegionSide>& sides,
                         const TransfinitePatch& patch);

}  // namespace hull::network
