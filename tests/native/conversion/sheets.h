// SPDX-License-Identifier: GPL-3.0-or-later
// Hand-made patch sets for the tests of conversion and exchange.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <tuple>
#include <vector>

#include "conversion/patches/patch_set.h"

namespace hull::testing {

// Patches whose sides agree point by point share the edge, whose corners agree the vertex. Sides of
// no length are never shared.
inline conversion::PatchSet joined(std::vector<conversion::BSplinePatch> patches) {
  using Key = std::vector<std::tuple<double, double, double>>;
  const auto key_of = [](const std::vector<Vector3d>& points) {
    Key key;
    for (const Vector3d& p : points) key.emplace_back(p.x(), p.y(), p.z());
    return std::min(key, Key(key.rbegin(), key.rend()));
  };
  conversion::PatchSet set;
  std::map<Key, int> vertices, edges;
  for (const conversion::BSplinePatch& patch : patches) {
    std::array<int, 4> corners{};
    std::array<conversion::PatchSide, 4> sides;
    for (int k = 0; k < 4; ++k) {
      const int next_vertex = static_cast<int>(vertices.size());
      const auto key = key_of({patch.side_points(k).front()});
      corners[k] = vertices.try_emplace(key, next_vertex).first->second;
    }
    for (int k = 0; k < 4; ++k) {
      const auto points = patch.side_points(k);
      const auto whole = [&](int edge) {
        return conversion::whole_side(edge, corners[k], corners[(k + 1) % 4]);
      };
      const bool collapsed = std::ranges::all_of(points, [&](auto& p) { return p == points[0]; });
      if (collapsed) {
        sides[k] = whole(set.edge_count++);
        continue;
      }
      const auto [found, fresh] = edges.try_emplace(key_of(points), set.edge_count);
      if (fresh) ++set.edge_count;
      sides[k] = whole(found->second);
    }
    set.corners.push_back(corners);
    set.sides.push_back(sides);
  }
  set.vertex_count = static_cast<int>(vertices.size());
  set.patches = std::move(patches);
  return set;
}

// nu x nv patches of 5 x 5 control points: place(i, j, a, b) of the point (a, b) of patch (i, j).
template <class Place>
conversion::PatchSet sheet_by_places(int nu, int nv, const Place& place) {
  std::vector<conversion::BSplinePatch> patches;
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) {
      conversion::BSplinePatch patch{3,
                                     3,
                                     conversion::open_uniform_knots(3, 5),
                                     conversion::open_uniform_knots(3, 5),
                                     5,
                                     5,
                                     {},
                                     j * nu + i};
      for (int k = 0; k < 25; ++k) patch.control_points.push_back(place(i, j, k / 5, k % 5));
      patches.push_back(std::move(patch));
    }
  }
  return joined(std::move(patches));
}

// nu x nv patches of 5 x 5 control points taken from a function of (s, t) in [0, 1]^2.
inline conversion::PatchSet sheet(int nu, int nv,
                                  const std::function<Vector3d(double, double)>& point) {
  return sheet_by_places(nu, nv, [&](int i, int j, int a, int b) {
    return point((4 * i + a) / (4.0 * nu), (4 * j + b) / (4.0 * nv));
  });
}

// A flat rectangle of a x b metres in the plane z = 0, its normal up, of nu x nv patches. The
// control points are spaced so that (u, v) is proportional to (x, y).
inline conversion::PatchSet rectangle(double a, double b, int nu = 1, int nv = 1) {
  constexpr double kGreville[5] = {0.0, 1.0 / 6, 0.5, 5.0 / 6, 1.0};
  // Ends are computed the same way from both sides of a joint.
  const auto at = [&](int number, int k, int count, double length) {
    if (k == 4) return length * (number + 1) / count;
    return length * number / count + length / count * kGreville[k];
  };
  return sheet_by_places(nu, nv, [&](int i, int j, int k, int l) {
    return Vector3d(at(i, k, nu, a), at(j, l, nv, b), 0.0);
  });
}

// How many edges are one patch's alone.
inline int free_edges(const conversion::PatchSet& set) {
  std::vector<int> uses(set.edge_count, 0);
  for (const auto& sides : set.sides) {
    for (const conversion::PatchSide& side : sides) {
      for (const conversion::SideEdge& part : side) ++uses[part.edge];
    }
  }
  return static_cast<int>(std::ranges::count(uses, 1));
}

}  // namespace hull::testing
