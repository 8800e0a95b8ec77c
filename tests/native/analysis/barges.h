// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "test_meshes.h"

// Barges with the same section from end to end, and what water does to such a section: an
// independent way to their righting levers.
namespace hull::testing {

// Of a barge that serves several tests, m.
inline constexpr double kBargeLength = 20.0, kBargeBeam = 8.0, kBargeDepth = 5.0, kBargeDraft = 2.0;

using Polygon = std::vector<Eigen::Vector2d>;  // (y, z), counter-clockwise seen from forward

// Of n points on a circle or ellipse around (0, z).
inline Polygon round_section(int n, double half_breadth, double half_height, double z,
                             double turn = 0.0) {
  Polygon polygon;
  for (int k = 0; k < n; ++k) {
    const double angle = turn + 2.0 * std::numbers::pi * k / n;
    polygon.emplace_back(half_breadth * std::cos(angle), z + half_height * std::sin(angle));
  }
  return polygon;
}

inline Polygon box_section(double beam, double depth) {
  return {{-0.5 * beam, 0.0}, {0.5 * beam, 0.0}, {0.5 * beam, depth}, {-0.5 * beam, depth}};
}

// From x = 0 to the length, all edges creases. Points k are aft, n + k forward.
inline mesh::MeshArrays barge(const Polygon& section, double length) {
  mesh::MeshArrays mesh;
  const int n = static_cast<int>(section.size());
  for (double x : {0.0, length}) {
    for (const auto& p : section) mesh.points.emplace_back(x, p.x(), p.y());
  }
  std::vector<int> aft, forward;
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    add_face(mesh, {k, next, n + next, n + k});
    mesh.creases.push_back({k, next});
    mesh.creases.push_back({n + k, n + next});
    mesh.creases.push_back({k, n + k});
    aft.push_back(n - 1 - k);
    forward.push_back(n + k);
  }
  add_face(mesh, aft);
  add_face(mesh, forward);
  return mesh;
}

struct WetSection {
  double area = 0.0;
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
};

// The part of the section below up·p = offset.
inline WetSection wet_section(const Polygon& section, const Eigen::Vector2d& up, double offset) {
  Polygon wet;
  for (std::size_t k = 0; k < section.size(); ++k) {
    const Eigen::Vector2d &a = section[k], &b = section[(k + 1) % section.size()];
    const double ha = up.dot(a) - offset, hb = up.dot(b) - offset;
    if (ha <= 0.0) wet.push_back(a);
    if ((ha < 0.0) != (hb < 0.0) && ha != hb) wet.push_back(a + ha / (ha - hb) * (b - a));
  }
  WetSection result;
  for (std::size_t k = 0; k < wet.size(); ++k) {
    const Eigen::Vector2d &a = wet[k], &b = wet[(k + 1) % wet.size()];
    const double twice = a.x() * b.y() - a.y() * b.x();
    result.area += 0.5 * twice;
    result.centroid += twice / 6.0 * (a + b);
  }
  if (result.area > 0.0) result.centroid /= result.area;
  return result;
}

// The same below the water in which the wet area is given.
inline WetSection section_afloat(const Polygon& section, const Eigen::Vector2d& up, double area) {
  double low = 1e9, high = -1e9;
  for (const auto& p : section) {
    low = std::min(low, up.dot(p));
    high = std::max(high, up.dot(p));
  }
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (wet_section(section, up, middle).area < area ? low : high) = middle;
  }
  return wet_section(section, up, low);
}

// GZ of a section with its centre of gravity, positive where it rights a heel to starboard (y < 0).
inline double section_lever(const Polygon& section, double area, const Eigen::Vector2d& gravity,
                            double heel) {
  const Eigen::Vector2d up(std::sin(heel), std::cos(heel));
  const Eigen::Vector2d starboard(-std::cos(heel), std::sin(heel));
  return (section_afloat(section, up, area).centroid - gravity).dot(starboard);
}

}  // namespace hull::testing
