// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "production/plates/surface_curve.h"
#include "surface/progress.h"

namespace hull::production {

// A triangle of (u, v) in a cell, and what the surface makes of it: nothing is flat.
struct ShellTriangle {
  int cell;
  std::array<int, 3> points;  // counter-clockwise, seen from the water
  std::array<Eigen::Vector2d, 3> uv;
};

// The surface in triangles that share their points, with curves along their sides. Together they
// are the surface, without gaps or overlaps.
struct ShellMesh {
  std::vector<Vector3d> points;  // of the surface, m
  std::vector<ShellTriangle> triangles;
  // By pair_key() of a side's two points: the number of the curve there, and the angle of the
  // knuckle.
  std::unordered_map<std::uint64_t, int> seams;
  std::unordered_map<std::uint64_t, double> knuckles;

  static std::uint64_t pair_key(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    return (static_cast<std::uint64_t>(high) << 32) | static_cast<std::uint32_t>(low);
  }
};

// `size`: about the length of triangles' sides, m; cells are cut in no more than 64 by 64 parts.
// REQUIRES: size > 0.
ShellMesh shell_mesh(const surface::LimitSurface& surface, const std::vector<SurfaceCurve>& curves,
                     double size, const surface::Progress& progress = {});

}  // namespace hull::production
