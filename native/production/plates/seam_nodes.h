// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull::production {

// A straight piece of a curve in the (u, v) of a cell.
struct SeamPart {
  Eigen::Vector2d from, to;
  int curve;
};

// The same pieces, cut where they meet others: afterwards they share ends at most. An end within
// rounding of another piece is on it.
std::vector<SeamPart> noded(const std::vector<SeamPart>& parts);

// With u and v stretched by `lengths`.
double distance_to(const SeamPart& part, const Eigen::Vector2d& uv, const Eigen::Vector2d& lengths);

}  // namespace hull::production
