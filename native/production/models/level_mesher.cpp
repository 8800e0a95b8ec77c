// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/models/level_mesher.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hull::production {
namespace {

// Of the distance: how exactly corners of triangles have it; after so many steps at most.
constexpr double kOnLevel = 1e-9;
constexpr int kMostSteps = 40;

using Node = std::array<int, 3>;

constexpr int kBits = 20;  // of a node's numbers

std::uint64_t node_key(const Node& at) {
  return (static_cast<std::uint64_t>(at[0]) << 2 * kBits) |
         (static_cast<std::uint64_t>(at[1]) << kBits) | static_cast<std::uint64_t>(at[2]);
}

// The corner of a unit cube as a number, bit by bit.
Node corner_of(const Node& at, int bits) {
  return {at[0] + (bits & 1), at[1] + (bits >> 1 & 1), at[2] + (bits >> 2 & 1)};
}

}  // namespace

LevelMesher::LevelMesher(const ClosedModel& model, const TriangleTree& tree, double distance,
                         double cell)
    : model_(model), tree_(tree), distance_(distance), cell_(cell) {}

Vector3d LevelMesher::place(const Node& at) const {
  return origin_ + cell_ * Vector3d(at[0], at[1], at[2]);
}

void LevelMesher::find_cells(const surface::Progress& progress) {
  const Vector3d sizes = tree_.box().sizes();
  // A power of two, to be halved down to single cubes, and no more than a node's bits can number.
  int count = 1;
  while (count * cell_ < sizes.maxCoeff() && count < 1 << (kBits - 1)) count *= 2;
  origin_ = tree_.box().center() - Vector3d::Constant(0.5 * cell_ * count);
  descend({0, 0, 0}, count, 2.0 * (sizes.norm() + cell_ * count), 0.0, 1.0, progress);
}

void LevelMesher::descend(const Node& at, int size, double near, double begin, double end,
                          const surface::Progress& progress) {
  const double reach = 0.5 * std::sqrt(3.0) * size * cell_;
  const Vector3d middle = place(at) + Vector3d::Constant(0.5 * size * cell_);
  const TriangleTree::Nearest found = tree_.nearest(middle, near);
  if (std::abs(found.distance - distance_) > reach) return;
  // The surface does not pass this cube: all of it is on the side of its middle. Inside a triangle
  // the normal tells which; at edges and corners it might not.
  if (found.distance > reach && found.within) {
    const auto& [a, b, c] = model_.triangles[found.triangle];
    const auto& p = model_.points;
    const Vector3d normal = (p[b] - p[a]).cross(p[c] - p[a]).normalized();
    // Wholly outside.
    if (normal.dot(middle - found.point) > 0.9 * found.distance) return;
  }
  if (size == 1) {
    cells_.push_back({at, found.distance + reach});
    return;
  }
  if (end - begin > 1e-3 && progress) progress(begin);
  const int half = size / 2;
  for (int k = 0; k < 8; ++k) {
    const Node corner = corner_of({0, 0, 0}, k);
    const double share = (end - begin) / 8.0;
    // A child's middle is half as far from this one as the corners are.
    descend({at[0] + half * corner[0], at[1] + half * corner[1], at[2] + half * corner[2]}, half,
            found.distance + 0.5 * reach, begin + k * share, begin + (k + 1) * share, progress);
  }
}

double LevelMesher::value_at(const Node& at, double near) {
  // A node has up to eight cubes and many more tetrahedra: it is asked for once.
  const auto [found, is_new] = values_.emplace(node_key(at), 0.0);
  if (is_new) found->second = tree_.nearest(place(at), near).distance - distance_;
  return found->second;
}

int LevelMesher::point_between(const Node& low, double low_value, int way, double high_value) {
  const auto [found, is_new] = between_.emplace(node_key(low) << 3 | static_cast<unsigned>(way),
                                                static_cast<int>(mesh_.points.size()));
  if (is_new) {
    ends_.push_back({place(low), place(corner_of(low, way)), low_value, high_value});
    mesh_.points.push_back(ends_.back().between(low_value / (low_value - high_value)));
  }
  return found->second;
}

// The tetrahedron from a cube's lowest corner to its highest one along three sides in this order.
void LevelMesher::add_tetrahedron(const Cell& cell, const std::array<int, 3>& order, bool even) {
  // Freudenthal's division: the corners' bits grow by one of the three each, and neighbouring cubes
  // divide their common face alike.
  std::array<int, 4> corner{0, 0, 0, 0};
  for (int k = 0; k < 3; ++k) corner[k + 1] = corner[k] | 1 << order[k];
  std::array<double, 4> value;
  std::array<int, 4> sorted;  // those below the level first
  int below = 0, swaps = 0;
  for (int k = 0; k < 4; ++k) value[k] = value_at(corner_of(cell.at, corner[k]), cell.near);
  for (int k = 0; k < 4; ++k) below += value[k] <= 0.0;
  int low = 0, high = below;
  // Sorting turns the tetrahedron over when it exchanges an odd number of pairs.
  for (int k = 0; k < 4; ++k) {
    if (value[k] <= 0.0) swaps += high - below;
    sorted[value[k] <= 0.0 ? low++ : high++] = k;
  }
  if (below == 0 || below == 4) return;
  const auto between = [&](int i, int j) {
    // The lower corner's bits are among the higher one's: what is left is their side's direction.
    const int a = std::min(sorted[i], sorted[j]), b = std::max(sorted[i], sorted[j]);
    return point_between(corner_of(cell.at, corner[a]), value[a], corner[b] ^ corner[a], value[b]);
  };
  const bool flip = even == (swaps % 2 != 0);
  const auto add = [&](int a, int b, int c) {
    if (flip) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  };
  if (below == 1) return add(between(0, 1), between(0, 2), between(0, 3));
  if (below == 3) return add(between(3, 0), between(3, 1), between(3, 2));
  // One after another around the four sides that are passed.
  const int a = between(0, 2), b = between(0, 3), c = between(1, 3), d = between(1, 2);
  add(a, b, c);
  add(a, c, d);
}

LevelMesh LevelMesher::mesh(const surface::Progress& progress) {
  std::array<int, 3> order{0, 1, 2};
  std::size_t done = 0;
  for (const Cell& cell : cells_) {
    if (done++ % 4096 == 0) surface::tell(progress, 0.5 * done, static_cast<double>(cells_.size()));
    do {
      // Orders of odd parity make mirror images of the tetrahedra that the others make.
      const int inversions = (order[0] > order[1]) + (order[0] > order[2]) + (order[1] > order[2]);
      add_tetrahedron(cell, order, inversions % 2 == 0);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  // Before corners are moved, which costs the most: outer parts need not be.
  keep_inner();
  move_onto_level(surface::part_of(progress, 0.5, 1.0));
  return std::move(mesh_);
}

// Parts outside the body are left out, which may have been found where their nearest point is on an
// edge.
void LevelMesher::keep_inner() {
  std::vector<int> root(mesh_.points.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int p) {
    while (root[p] != p) p = root[p] = root[root[p]];
    return p;
  };
  for (const auto& [a, b, c] : mesh_.triangles) {
    root[find(b)] = find(a);
    root[find(c)] = find(a);
  }
  std::vector<signed char> inside(mesh_.points.size(), -1);
  std::vector<std::array<int, 3>> kept;
  std::vector<int> number(mesh_.points.size(), -1);
  std::vector<Vector3d> points;
  std::vector<Ends> ends;
  for (std::array<int, 3> triangle : mesh_.triangles) {
    const int part = find(triangle[0]);
    if (inside[part] < 0) {
      // A part does not pass the body's surface: one point tells for all of it.
      inside[part] = tree_.encloses(mesh_.points[part]);
      mesh_.parts += inside[part];
    }
    if (!inside[part]) continue;
    for (int& corner : triangle) {
      if (number[corner] < 0) {
        number[corner] = static_cast<int>(points.size());
        points.push_back(mesh_.points[corner]);
        ends.push_back(ends_[corner]);
      }
      corner = number[corner];
    }
    kept.push_back(triangle);
  }
  mesh_.points = std::move(points);
  ends_ = std::move(ends);
  mesh_.triangles = std::move(kept);
}

// Along their sides of tetrahedra, so that triangles stay within these and never meet: regula falsi
// with halved values (Dowell & Jarratt 1971).
void LevelMesher::move_onto_level(const surface::Progress& progress) {
  // The side's end below the level is within the distance, and no point of it further away than a
  // cube's diagonal.
  const double near = distance_ + 2.0 * cell_;
  for (std::size_t i = 0; i < mesh_.points.size(); ++i) {
    if (i % 4096 == 0) {
      surface::tell(progress, static_cast<double>(i), static_cast<double>(mesh_.points.size()));
    }
    const Ends& ends = ends_[i];
    double low = 0.0, high = 1.0, low_value = ends.low_value, high_value = ends.high_value;
    double at = low_value / (low_value - high_value);
    int moved = 0;  // the end that was moved before: -1 the low one, 1 the high one
    for (int step = 0; step < kMostSteps; ++step) {
      const double value = tree_.nearest(ends.between(at), near).distance - distance_;
      if (std::abs(value) <= kOnLevel * distance_) break;
      if ((value <= 0.0) == (low_value <= 0.0)) {
        low = at, low_value = value;
        if (moved == -1) high_value *= 0.5;
        moved = -1;
      } else {
        high = at, high_value = value;
        if (moved == 1) low_value *= 0.5;
        moved = 1;
      }
      at = (low * high_value - high * low_value) / (high_value - low_value);
    }
    mesh_.points[i] = ends.between(at);
  }
}

}  // namespace hull::production
