// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "network/patches/ribboned_side.h"
#include "random_values.h"

namespace hull::testing {

using network::RibbonedSide;
using network::SideJet;

// A polynomial of degree 3 in Bézier points, with its derivative.
struct CubicWay {
  Vector3d a, b, c, d;

  Vector3d at(double u) const {
    const double w = 1.0 - u;
    return w * w * w * a + 3.0 * u * w * w * b + 3.0 * u * u * w * c + u * u * u * d;
  }
  Vector3d slope(double u) const {
    const double w = 1.0 - u;
    return 3.0 * (w * w * (b - a) + 2.0 * u * w * (c - b) + u * u * (d - c));
  }
  Vector3d bend(double u) const {
    return 6.0 * ((1.0 - u) * (a - 2.0 * b + c) + u * (b - 2.0 * c + d));
  }
};

inline RibbonedSide side_of(const CubicWay& way, const CubicWay& ribbon) {
  return [way, ribbon](double u) {
    return SideJet{way.at(u), way.slope(u), ribbon.at(u), ribbon.slope(u), way.bend(u)};
  };
}

// Around a bent polygon, with ribbons that meet the neighbours, and twists that do not agree.
inline std::vector<RibbonedSide> random_sides(std::mt19937& random, int count,
                                              double height = 0.3) {
  const auto n = static_cast<std::size_t>(count);
  const auto shaken = [&](double by) {
    Vector3d v = by * random_vector(random);
    v.z() *= height / 0.3;
    return v;
  };
  std::vector<Vector3d> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / count;
    corners.push_back(Vector3d(std::cos(angle), std::sin(angle), 0.0) + shaken(0.2));
  }
  std::vector<CubicWay> ways;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d &a = corners[i], &d = corners[(i + 1) % n];
    // Two sides bulge, or there would be nothing between them.
    const Vector3d out = count == 2 ? Vector3d(0.0, i == 0 ? 0.5 : -0.5, 0.0) : Vector3d::Zero();
    ways.push_back(
        {a, a + (d - a) / 3.0 + out + shaken(0.15), d - (d - a) / 3.0 + out + shaken(0.15), d});
  }
  std::vector<RibbonedSide> sides;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3d start = -ways[(i + n - 1) % n].slope(1.0);
    const Vector3d end = ways[(i + 1) % n].slope(0.0);
    sides.push_back(side_of(ways[i], {start, start + (end - start) / 3.0 + shaken(0.2),
                                      end - (end - start) / 3.0 + shaken(0.2), end}));
  }
  return sides;
}

}  // namespace hull::testing
