// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "network/patches/transfinite_patch.h"
#include "network/splines/merged_regions.h"
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
  double spoke_error = 0.0;              // m, of splines along spokes
  std::vector<double> reference_errors;  // m, of the patch from each of the region's references
  bool has_short_sides = true;           // else they are of with_short_sides_joined()
  bool has_normals = true;  // else it has not, everywhere, the network's tangent planes

  bool is_single() const { return patches.size() == 1; }
  void add(FittedQuad fitted);
};

// Of its patches. `sides`: sides_of_one_curve(), short ones joined where its patches are of such.
std::vector<std::array<QuadBorder, 4>> quad_borders(const NetworkFrame& frame,
                                                    const std::vector<RegionSide>& sides,
                                                    bool is_single);

struct RegionInput {
  std::shared_ptr<const NetworkFrame> frame;
  const EdgeSplines& edges;
  double tolerance;  // m, of splines along spokes
  int spans;
};

// Of a region with four sides, none of which goes on in another curve, the target is its
// TransfinitePatch, and there is a single patch, unless it is folded. Of others it is a
// BorderPlate's surface, where the border is a graph over a plane and quads around its centroid
// cover it without folds; where that is steep inside a BorderPlate's without normals; and a
// TransfinitePatch where there is none. With reference curves the single patch is
// fitted_to_curves(), free along the network's border.
RegionQuads region_quads(const RegionInput& input, const MergedRegion& region);

}  // namespace hull::network
