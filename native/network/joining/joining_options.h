// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hull::network {

struct JoiningOptions {
  double tolerance;  // m, within which curves are joined
  double near_misses =
      10;  // times the tolerance: curves that are nearer, but not joined, are named
};

}  // namespace hull::network
