// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/models/hollow.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include "production/models/level_mesher.h"
#include "production/models/triangle_tree.h"

namespace hull::production {
namespace {

// Inner surfaces pass fewer cubes than this times their area over a cube's side.
constexpr double kCellsOfArea = 1.6;

void check_lengths(double wall, double cell) {
  if (wall > 0.0 && cell > 0.0 && std::isfinite(wall) && std::isfinite(cell)) return;
  std::ostringstream words;
  words << "A wall and the cubes that it is found by need positive lengths, not " << wall << " and "
        << cell << ".";
  throw std::invalid_argument(words.str());
}

// Both ends of a tetrahedron's side, a cube's diagonal at most, are inside or in the wall then: of
// longer ones they could be further than the wall from the skin that passes between them.
void check_cell(double wall, double cell) {
  if (cell <= wall) return;
  std::ostringstream words;
  words << "Cubes of " << cell << " could miss a wall of " << wall
        << "; take them no larger than the wall.";
  throw std::invalid_argument(words.str());
}

void check_count(double area, double wall, double cell) {
  if (kCellsOfArea * area / (cell * cell) <= kMostWallCells) return;
  const double enough = 1.01 * std::sqrt(kCellsOfArea * area / kMostWallCells);
  std::ostringstream words;
  words << "Cubes of " << cell << " for the inner side of the wall would be more than "
        << kMostWallCells << "; ";
  if (enough <= wall) {
    words << enough << " would do.";
  } else {
    words << "take a wall of " << enough << " or more, and cubes as large, or a smaller model.";
  }
  throw std::invalid_argument(words.str());
}

double volume_of(const std::vector<Vector3d>& points,
                 const std::vector<std::array<int, 3>>& triangles) {
  ClosedModel part;
  part.points = points;
  part.triangles = triangles;
  return part.volume();
}

}  // namespace

HollowModel hollowed(const ClosedModel& model, double wall, double cell,
                     const surface::Progress& progress) {
  check_lengths(wall, cell);
  check_cell(wall, cell);
  check_count(model.area(), wall, cell);
  const TriangleTree tree(model);
  LevelMesher mesher(model, tree, wall, cell);
  mesher.find_cells(surface::part_of(progress, 0.0, 0.6));
  LevelMesh inner = mesher.mesh(surface::part_of(progress, 0.6, 1.0));
  if (inner.triangles.empty()) {
    std::ostringstream words;
    words << "A wall of " << wall << " leaves nothing hollow: the model is nowhere thicker than "
          << "twice that; take a thinner wall.";
    throw std::invalid_argument(words.str());
  }
  HollowModel result;
  result.hollows = inner.parts;
  // The triangles face into the hollow, and enclose it inside out.
  result.hollow_volume = -volume_of(inner.points, inner.triangles);
  result.model = model;
  result.model.cells.clear();  // the hollows' triangles are of none
  const int first = static_cast<int>(model.points.size());
  result.model.points.insert(result.model.points.end(), inner.points.begin(), inner.points.end());
  for (const auto& [a, b, c] : inner.triangles) {
    result.model.triangles.push_back({a + first, b + first, c + first});
  }
  return result;
}

double wall_volume(const ClosedModel& model, double wall) {
  check_lengths(wall, wall);
  struct Neighbour {
    Vector3d normal;
    int opposite;
    double doubled_area;
  };
  std::unordered_map<std::uint64_t, Neighbour> waiting;
  double bend = 0.0;
  for (const std::array<int, 3>& t : model.triangles) {
    const auto& p = model.points;
    const Vector3d across = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
    const double doubled_area = across.norm();
    // Without area it stays 0 in Eigen, so that the triangle's edges have no angle.
    const Vector3d normal = across.normalized();
    for (int k = 0; k < 3; ++k) {
      const int a = std::min(t[k], t[(k + 1) % 3]), b = std::max(t[k], t[(k + 1) % 3]);
      const auto key = static_cast<std::uint64_t>(a) << 32 | static_cast<unsigned>(b);
      // An edge counts once its second triangle comes.
      const auto found = waiting.find(key);
      if (found == waiting.end()) {
        waiting[key] = {normal, t[(k + 2) % 3], doubled_area};
        continue;
      }
      const Neighbour& other = found->second;
      const double theta = std::atan2(normal.cross(other.normal).norm(), normal.dot(other.normal));
      // The other triangle's third corner lies below this one's plane.
      const bool convex = normal.dot(p[other.opposite] - p[a]) <= 0.0;
      const double length = (p[b] - p[a]).norm();
      const double narrow = std::min(doubled_area, other.doubled_area);
      bend +=
          convex ? std::min(length * std::tan(0.5 * theta), narrow / wall) : -0.5 * theta * length;
    }
  }
  return wall * model.area() - wall * wall * bend;
}

}  // namespace hull::production
