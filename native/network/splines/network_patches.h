// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "conversion/patches/patch_set.h"
#include "network/model/curve_network.h"
#include "network/splines/region_quads.h"

namespace hull::network {

struct PatchOptions {
  int spans = 4;           // the least number of a patch's spans each way
  double tolerance = 0.0;  // m, of splines along curves; 0: a tenth of the network's
};

// The surface of a network as B-spline patches that share their borders: one patch in each region
// of four sides, N around a centre in regions of other numbers N. Regions that only reference
// curves part are one, where that has four sides (merged_regions()). Curves are met within the
// tolerance, borders of neighbours are the same curves, and their tangent planes are the same at
// the inner knots that both have. See fitted_quad() and region_quads().
struct NetworkPatches {
  conversion::PatchSet set;
  std::vector<int> regions;              // of patches; of merged ones the first
  std::vector<int> edges;                // of edges of the set the network's; -1: within a region
  std::vector<NetworkProblem> problems;  // regions that are left open, and curves not met
  // m, of each curve: how far it is, as it is given, from the surface at most; along borders from
  // these. Parts that the network leaves out do not count.
  std::vector<double> curve_errors;
  double spoke_error = 0.0;  // m, of borders around centres of regions from what they stand for

  double largest_curve_error() const;

  // What regions of the same sides and normals are made of again.
  using Known = std::map<std::vector<double>, RegionQuads>;
  std::shared_ptr<const Known> known;
};

// `before`: patches of another state of the network; regions that are as they were there are taken
// from it. Throws std::invalid_argument for spans that are not from 1 to 64, and for a tolerance
// below zero.
NetworkPatches network_patches(const CurveNetwork& network, const PatchOptions& options,
                               const NetworkPatches* before = nullptr);

}  // namespace hull::network
