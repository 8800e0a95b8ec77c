// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hull::drawing {

// Frames of whatever spacing: where those from number `first` on stand, x in m, rising or falling;
// names as they are drawn, one for each.
struct PlanFrames {
  int first = 0;
  std::vector<double> positions;
  std::vector<std::string> names;
};

// Throws std::invalid_argument unless they are two or more that follow one another, with names.
void check_frames(const PlanFrames& frames);

// What is at x: the name of a frame, between two of them the number as far as it is from one to the
// next. Throws std::invalid_argument beyond the frames.
std::string frame_name(double x, const PlanFrames& frames);

}  // namespace hull::drawing
