// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/limit_surface.h"
#include "test_meshes.h"

namespace hull::morphing {

// A half hull over a profile (x, z), from aft to the stem head: three strips from there to a deck
// edge 12 m off the centre plane.
inline surface::LimitSurface half_hull(const std::vector<Eigen::Vector2d>& profile) {
  const int m = static_cast<int>(profile.size()) - 1;
  mesh::MeshArrays mesh = testing::grid(m, 3);
  for (Eigen::Vector3d& p : mesh.points) {
    const Eigen::Vector2d& at = profile[static_cast<std::size_t>(p.x())];
    const double rise = p.y() / 3.0;
    p = {at.x(), 4.0 * p.y(), at.y() + rise * (14.0 - at.y())};
  }
  return surface::LimitSurface(mesh::ControlMesh(mesh));
}

inline std::vector<Eigen::Vector2d> plain_profile() {
  return {{0, 8},  {2, 4},  {8, 0},  {20, 0},  {40, 0},  {60, 0},
          {80, 0}, {90, 0}, {98, 1}, {101, 5}, {103, 9}, {104, 12}};
}

// The same with a bulb at the bow, whose nose is about `nose`, m, in front of its neck.
inline std::vector<Eigen::Vector2d> bulb_profile(double nose) {
  return {{0, 8},  {2, 4},         {8, 0},         {20, 0}, {40, 0}, {60, 0},   {80, 0},  {90, 0},
          {96, 0}, {98 + nose, 1}, {98 + nose, 5}, {97, 7}, {97, 8}, {101, 10}, {104, 12}};
}

}  // namespace hull::morphing
