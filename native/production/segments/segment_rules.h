// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/vectors.h"

namespace hull::production {

// Boxes of a grid that are looked at.
inline constexpr double kMostBoxes = 200000;

enum class SegmentMaking {
  kMilling,     // from one side, on three axes
  kThickLayers  // layers cut by a blade along their sides
};

// What a machine takes.
struct SegmentRules {
  SegmentMaking making = SegmentMaking::kMilling;
  // Largest sizes of a segment: the first two across the tool, either way round, the third along
  // it.
  Vector3d machine;
  double least = 0.0;  // of any size of a segment
  // About how many layers the grid has along the model's longest side; fewer where it would have
  // more than kMostBoxes boxes.
  int planes = 16;
};

// Of six directions +x, -x, +y, -y, +z, -z, or three of layers' normals: x, y, z.
struct SegmentVerdict {
  int direction = -1;         // the best; the tool is on this side
  double inaccessible = 0.0;  // area that the tool or blade does not reach
  bool has_back = false;      // a plane to lie on
  bool fits = false;          // within the sizes
  double penalty = 0.0;       // 0: it can be made
};

// 001, 5.5.1.2: what makes a segment worse.
inline constexpr double kNoBackPlane = 1000.0, kOutsideSizes = 250.0;
// Faces may be turned away by this, rad, as vertical walls are by the model's tolerance; the blade
// of thick layers leans over by 45° at most.
inline constexpr double kTurnedAway = 0.00873;  // 0.5°

}  // namespace hull::production
