// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/freedom.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "modelling/complement.h"

namespace hull::modelling {
namespace {

Freedom freedom_across(const std::vector<Vector3d>& normals) {
  // Across all that is held: space, a plane, a line or nothing.
  const std::vector<Vector3d> free = complement(normals, 3);
  Freedom freedom{{}, static_cast<int>(free.size())};
  std::ranges::copy(free, freedom.directions.begin());
  return freedom;
}

}  // namespace

void check_point(int point, int count, const char* what) {
  if (point >= 0 && point < count) return;
  throw std::invalid_argument(std::string("A ") + what + " point is " + std::to_string(point) +
                              ", but the control points are 0 to " + std::to_string(count - 1) +
                              ".");
}

std::vector<Freedom> freedoms_within(const MoveLimits& limits, int point_count) {
  std::vector<std::vector<Vector3d>> held(point_count);
  for (const HeldDirection& h : limits.held) {
    check_point(h.point, point_count, "held");
    if (!h.normal.allFinite() || h.normal.squaredNorm() == 0.0) {
      throw std::invalid_argument("The held direction of point " + std::to_string(h.point) +
                                  " has no length.");
    }
    held[h.point].push_back(h.normal);
  }
  std::vector<Freedom> freedoms;
  freedoms.reserve(point_count);
  for (const std::vector<Vector3d>& normals : held) freedoms.push_back(freedom_across(normals));
  // Whatever holds a locked point besides.
  for (int point : limits.locked) {
    check_point(point, point_count, "locked");
    freedoms[point].count = 0;
  }
  return freedoms;
}

}  // namespace hull::modelling
