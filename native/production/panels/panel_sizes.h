// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/sections/plane_cut.h"
#include "production/grid/side_points.h"

namespace hull::production {

// How large panels are. At the water's surface and at the ends of the immersed hull their sides are
// `grading` times `size`; from there on they grow by kPanelGrowth of the distance.
struct PanelSizes {
  double size;           // m
  double grading = 0.5;  // in (0, 1]
};

inline constexpr double kPanelGrowth = 0.3;
inline constexpr double kMostPanels = 1 << 20;

// What is asked for at places of a hull that lies in `water`.
class PanelSizeField {
 public:
  // both_sides: the surface's mirror image is in the water, too. Throws std::invalid_argument for
  // sizes that are none, and where nothing of the surface is below the water.
  PanelSizeField(const surface::LimitSurface& surface, const analysis::Plane& water,
                 bool both_sides, const PanelSizes& sizes);

  double at(const Vector3d& p) const;

  // Whether a cell has a side, and a strip of cells one with it, that is at least partly wet.
  bool is_wet(int cell) const { return wet_[cell] != 0; }

 private:
  double height(const Vector3d& p) const;

  analysis::Plane water_;
  bool both_sides_;
  PanelSizes sizes_;
  Vector3d along_;  // in the water's surface
  double aft_ = 0.0, forward_ = 0.0;
  std::vector<char> wet_;  // by cell
};

// The sides of cells divided so that no part of one that is wet is longer than asked for, all parts
// of a side in the same proportion to that. Throws std::invalid_argument, naming a size that would
// do, where that takes more than kMostPanels.
SidePoints panel_sides(const surface::LimitSurface& surface, const PanelSizeField& field,
                       const PanelSizes& sizes);

}  // namespace hull::production
