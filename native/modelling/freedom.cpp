// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/freedom.h"

#include <stdexcept>
#include <string>

namespace hull::modelling {
namespace {

// Two held directions of a point closer than this (sine of their angle) are one.
constexpr double kSameDirection = 1e-9;

Freedom freedom_across(const std::vector<Vector3d>& normals) {
  std::array<Vector3d, 3> held;
  int held_count = 0;
  const auto rest_of = [&](Vector3d v) {
    // Twice: once leaves rounding of what was nearly parallel.
    for (int pass = 0; pass < 2; ++pass) {
      for (int i = 0; i < held_count; ++i) v -= held[i].dot(v) * held[i];
    }
    return v;
  };
  for (const Vector3d& normal : normals) {
    const Vector3d rest = rest_of(normal.normalized());
    if (held_count < 3 && rest.norm() > kSameDirection) held[held_count++] = rest.normalized();
  }
  Freedom freedom{{}, 3 - held_count};
  for (int k = 0; k < freedom.count; ++k) {
    // Of the axes' rests the longest, so that axes stay axes where planes are square to them.
    Vector3d best = Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d rest = rest_of(Vector3d::Unit(axis));
      if (rest.norm() > best.norm() + 1e-12) best = rest;
    }
    freedom.directions[k] = held[held_count++] = best.normalized();
  }
  return freedom;
}

void check_point(int point, int count, const char* what) {
  if (point >= 0 && point < count) return;
  throw std::invalid_argument(std::string("A ") + what + " point is " + std::to_string(point) +
                              ", but the control points are 0 to " + std::to_string(count - 1) +
                              ".");
}

}  // namespace

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
  for (int point : limits.locked) {
    check_point(point, point_count, "locked");
    freedoms[point].count = 0;
  }
  return freedoms;
}

}  // namespace hull::modelling
