// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "production/models/closed_model.h"
#include "production/segments/segment_rules.h"
#include "surface/progress.h"

namespace hull::production {

struct ModelSegment {
  ClosedModel model;
  SegmentVerdict verdict;
  std::array<Vector3d, 2> box;  // between the planes of its cuts
};

struct Dowels {
  double radius = 0.0;  // none unless it is positive
  double depth = 0.0;   // of the hole on either side of a joint
};

struct ModelSegments {
  std::vector<ModelSegment> segments;
  int holes = 0;              // for dowels: two for each
  double holes_volume = 0.0;  // of all
  int bare_joints = 0;        // where no dowel has room
};

inline constexpr int kDowelCorners = 32;

// A model in segments that a machine takes, between planes across the axes (Koelman 1999, 5.5):
// each is milled from one side with all of its faces reached, lying on a plane on the other side,
// or made of thick layers, and within the machine's sizes. Planes are those of an even grid. Of all
// ways to cut, and to cut the parts again, the best is taken, not one by chance: with the least sum
// of penalties; of these with the fewest segments; of these with the largest sum of roots of
// volumes, which is that of the most equal ones. What can be made is not cut any further. Where
// a penalty is left the segment's verdict tells why.
//
// Segments' volumes sum to the model's but for rounding and the dowels' holes: up to two for each
// pair of segments with a common joint, as far apart as there is room for, with as much of the
// segments around them as their radius, so that both sides agree.
//
// Throws std::invalid_argument as SegmentGrid and cut(), and for dowels without depth.
ModelSegments segmented(const ClosedModel& model, const SegmentRules& rules, const Dowels& dowels,
                        const surface::Progress& progress = {});

}  // namespace hull::production
