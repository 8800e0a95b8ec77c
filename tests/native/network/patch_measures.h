// SPDX-License-Identifier: GPL-3.0-or-later
// Patches made of networks of test surfaces, their seams' angles and their distance from the
// surface.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "network/splines/network_patches.h"

namespace hull::testing {

using network::CurveNetwork;
using network::NetworkPatches;
using network::NetworkProblem;

inline constexpr double kDegree = std::numbers::pi / 180.0;

inline Vector3d ellipsoid(double u, double v) {
  const double a = 1.3 * u + 0.1, b = 1.2 * v - 0.6;
  return {9.0 * std::cos(b) * std::sin(a), 4.0 * std::cos(b) * std::cos(a), 2.5 * std::sin(b)};
}

inline NetworkPatches patches_of(const CurveNetwork& network, int spans = 4,
                                 double tolerance = 1e-7) {
  NetworkPatches made = network::network_patches(network, {spans, tolerance});
  for (const NetworkProblem& problem : made.problems) ADD_FAILURE() << problem.what;
  made.set.check();
  EXPECT_LE(made.set.largest_gap(), conversion::kLargestGap * made.set.size());
  return made;
}

inline Eigen::Vector2d on_side(int side, double t) {
  const Eigen::Vector2d places[] = {{t, 0.0}, {1.0, t}, {1.0 - t, 1.0}, {0.0, 1.0 - t}};
  return places[side];
}

inline Vector3d normal_of(const conversion::BSplinePatch& patch, const Eigen::Vector2d& at) {
  const auto jet = patch.evaluate(at.x(), at.y());
  return jet.du.cross(jet.dv).normalized();
}

struct SeamAngles {
  double at_knots = 0.0, anywhere = 0.0;  // degrees, of smooth seams
  double of_creases = 0.0;                // degrees, the furthest from an angle
};

// Of edges, at shares of 1 / 64, of which, of whole sides, those of 1 / spans are the inner knots.
inline SeamAngles seam_angles(const CurveNetwork& network, const NetworkPatches& made, int spans,
                              double crease_degrees = 0.0) {
  struct User {
    std::size_t patch;
    int side;
    double begin, end;
  };
  std::vector<std::vector<User>> users(made.edges.size());
  for (std::size_t p = 0; p < made.set.patches.size(); ++p) {
    for (int k = 0; k < 4; ++k) {
      for (const auto& part : made.set.sides[p][static_cast<std::size_t>(k)]) {
        users[static_cast<std::size_t>(part.edge)].push_back({p, k, part.begin, part.end});
      }
    }
  }
  SeamAngles found;
  for (std::size_t e = 0; e < users.size(); ++e) {
    if (users[e].size() != 2) continue;
    const int edge = made.edges[e];
    const auto is_whole = [](const User& user) { return user.begin == 0.0 && user.end == 1.0; };
    const bool has_knots = is_whole(users[e][0]) && is_whole(users[e][1]);
    const bool is_crease =
        edge >= 0 && network.frame().normals.is_crease[static_cast<std::size_t>(edge)];
    for (int i = 1; i < 64; ++i) {
      std::array<Vector3d, 2> normals;
      for (std::size_t s = 0; s < 2; ++s) {
        const User& user = users[e][s];
        const double share = s == 0 ? i / 64.0 : 1.0 - i / 64.0;
        normals[s] = normal_of(made.set.patches[user.patch],
                               on_side(user.side, user.begin + share * (user.end - user.begin)));
      }
      const double angle =
          std::atan2(normals[0].cross(normals[1]).norm(), normals[0].dot(normals[1])) / kDegree;
      if (is_crease) {
        found.of_creases = std::max(found.of_creases, std::abs(angle - crease_degrees));
        continue;
      }
      found.anywhere = std::max(found.anywhere, angle);
      if (has_knots && i % (64 / spans) == 0) found.at_knots = std::max(found.at_knots, angle);
    }
  }
  return found;
}

inline double furthest_off(const NetworkPatches& made,
                           const std::function<double(const Vector3d&)>& off) {
  double worst = 0.0;
  for (const conversion::BSplinePatch& patch : made.set.patches) {
    for (int i = 0; i <= 12; ++i) {
      for (int k = 0; k <= 12; ++k) {
        worst = std::max(worst, std::abs(off(patch.position(i / 12.0, k / 12.0))));
      }
    }
  }
  return worst;
}

}  // namespace hull::testing
