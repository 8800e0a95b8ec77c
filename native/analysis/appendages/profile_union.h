// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analysis/appendages/appendage.h"
#include "analysis/appendages/joined_shells.h"

namespace hull::analysis {

// What is seen of a body athwartships, by lines (x, z) that enclose it, in any order and run
// through the same way round. Lines upright are not needed.
struct ProfileOutline {
  MemberRole role;
  std::vector<std::array<Vector2d, 2>> lines;
};

// A trapezoid with upright sides at x[0] and x[1], from low to high there, m; `times` it counts
// more than the hull's bodies, each by itself, count it.
struct ProfilePart {
  std::array<double, 2> x, low, high;
  int times;
};

// The profile of an appendage. Of a foil or a cylinder it is the convex hull of points of its
// surface, 17 along each side of a patch; of a bulb its meridian, as of one whose axis lies in
// an upright plane along the ship. Of what is cut out only a cylinder across the ship is seen:
// the light falls through it.
ProfileOutline profile_outline(const Appendage& appendage);

// By what
//
//   (hull's bodies ∪ added bodies) ∖ what is cut out
//
// is more, seen athwartships, than the sum of the hull's bodies.
std::vector<ProfilePart> profile_union(const std::vector<ProfileOutline>& outlines);

}  // namespace hull::analysis
