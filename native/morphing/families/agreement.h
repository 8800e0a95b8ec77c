// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "surface/limit_surface.h"

namespace hull::morphing {

// Whether the parents of a family are hulls of one topology, point for point: the same faces,
// creases, corners and scheme. A sentence for each that differs from the first, which names the
// first few elements; none where all agree.
std::vector<std::string> differences(const std::vector<surface::LimitSurface>& parents);

// A region of all parents that is to be flat in members, too, by its control points.
struct FamilyFlat {
  std::string name;
  std::vector<int> points;
};

// What keeps flats from being those of members: points of one that are not in a plane in a parent
// (kInPlane of its size), and planes that are turned against one another, between which members
// are flat nearly only. A sentence each. Throws std::invalid_argument for points that are none.
std::vector<std::string> flat_differences(const std::vector<surface::LimitSurface>& parents,
                                          const std::vector<FamilyFlat>& flats);

}  // namespace hull::morphing
