// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/models/model_cut.h"

#include <Eigen/Geometry>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include "production/models/cap_filling.h"
#include "production/models/directed_side.h"
#include "production/models/slivers.h"

namespace hull::production {
namespace {

// Of triangles in the cut, over their longest sides.
constexpr double kNoCapHeight = 1e-3;

using CornerNumbers = std::array<int, 3>;

// Sides of triangles that none runs through the other way.
std::vector<std::pair<int, int>> unmatched(const std::vector<CornerNumbers>& triangles) {
  std::unordered_map<std::uint64_t, int> uses;
  uses.reserve(3 * triangles.size());
  for (const CornerNumbers& t : triangles) {
    for (int k = 0; k < 3; ++k) ++uses[directed_key(t[k], t[(k + 1) % 3])];
  }
  std::vector<std::pair<int, int>> sides;
  // In the order of triangles, not of the hash table, so that a cut is the same everywhere.
  for (const CornerNumbers& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (!uses.count(directed_key(b, a))) sides.emplace_back(a, b);
    }
  }
  return sides;
}

// Coordinates in a plane across `axis`, as it is seen from the side to which it faces.
std::vector<Vector2d> seen_places(const std::vector<Vector3d>& points, int axis, bool upward) {
  // u, v and the axis are right-handed: from below, it is v and u that are.
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<Vector2d> places;
  places.reserve(points.size());
  for (const Vector3d& p : points) places.emplace_back(p[upward ? u : v], p[upward ? v : u]);
  return places;
}

// Closes open sides in a plane, with `holes` left in it (clockwise loops).
void close_in_plane(ClosedModel& model, int axis, bool upward,
                    std::vector<std::pair<int, int>> sides,
                    const std::vector<PointLoop>& holes = {}) {
  // What closes the body runs through open sides the other way.
  for (auto& [from, to] : sides) std::swap(from, to);
  const std::vector<Vector2d> places = seen_places(model.points, axis, upward);
  std::vector<PointLoop> loops = chained(sides, places);
  loops.insert(loops.end(), holes.begin(), holes.end());
  std::vector<CornerNumbers> cap = filled(loops, places);
  flip_slivers(model.points, cap, kNoCapHeight);
  model.triangles.insert(model.triangles.end(), cap.begin(), cap.end());
}

// What lies on one side of the plane.
class HalfCutter {
 public:
  HalfCutter(const ClosedModel& model, int axis, double at, bool above)
      : model_(model), axis_(axis), at_(at), above_(above) {}

  ClosedModel part() {
    part_.points = model_.points;
    for (const CornerNumbers& triangle : model_.triangles) add(triangle);
    close_in_plane(part_, axis_, !above_, unmatched(part_.triangles));
    drop_unused_points(part_);
    return std::move(part_);
  }

 private:
  int side(int point) const {
    const double height = model_.points[point][axis_];
    if (height == at_) return 0;
    return (height > at_) == above_ ? 1 : -1;
  }

  // Corners in the plane count for both parts; a triangle that has none beyond it is left out here,
  // those in the plane from both parts.
  void add(const CornerNumbers& triangle) {
    std::vector<int> kept;
    bool is_inside = false;
    for (int k = 0; k < 3; ++k) {
      const int a = triangle[k], b = triangle[(k + 1) % 3];
      if (side(a) >= 0) kept.push_back(a);
      if (side(a) > 0) is_inside = true;
      if (side(a) * side(b) < 0) kept.push_back(crossing(a, b));
    }
    if (!is_inside) return;
    for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
      part_.triangles.push_back({kept[0], kept[k], kept[k + 1]});
    }
  }

  // The same for both triangles of a side, and for both parts.
  int crossing(int a, int b) {
    // From the lower number on, so that both triangles round alike.
    if (a > b) std::swap(a, b);
    const auto [found, is_new] =
        crossings_.emplace(directed_key(a, b), static_cast<int>(part_.points.size()));
    if (is_new) {
      const Vector3d &p = model_.points[a], &q = model_.points[b];
      Vector3d point = p + (at_ - p[axis_]) / (q[axis_] - p[axis_]) * (q - p);
      point[axis_] = at_;  // rounding must not lift it off the plane
      part_.points.push_back(point);
    }
    return found->second;
  }

  const ClosedModel& model_;
  int axis_;
  double at_;
  bool above_;
  ClosedModel part_;
  std::unordered_map<std::uint64_t, int> crossings_;
};

}  // namespace

CutModel cut(const ClosedModel& model, int axis, double at) {
  if (axis < 0 || axis > 2 || !std::isfinite(at)) {
    throw std::invalid_argument("A model is cut across x, y or z at a finite place.");
  }
  CutModel parts{HalfCutter(model, axis, at, false).part(),
                 HalfCutter(model, axis, at, true).part()};
  if (open_sides(parts.below) + open_sides(parts.above) > 0) {
    std::ostringstream words;
    words << "The model touches itself where it would be cut, at "
          << "xyz"[axis] << " = " << at << "; cut it a little beside that.";
    throw std::invalid_argument(words.str());
  }
  return parts;
}

ClosedModel drilled(const ClosedModel& model, int axis, double at, bool upward,
                    const std::vector<Vector2d>& centres, double radius, double depth,
                    int corners) {
  ClosedModel result;
  result.points = model.points;
  for (const CornerNumbers& t : model.triangles) {
    const Vector3d &a = model.points[t[0]], &b = model.points[t[1]], &c = model.points[t[2]];
    // Faces in the plane go, and are made anew around the holes.
    const bool in_plane = a[axis] == at && b[axis] == at && c[axis] == at;
    if (!in_plane || ((b - a).cross(c - a)[axis] > 0.0) != upward) result.triangles.push_back(t);
  }
  std::vector<PointLoop> holes;
  const double bottom = at + (upward ? -depth : depth);
  for (const Vector2d& centre : centres) {
    PointLoop hole(corners);  // clockwise, with the rims of the hole
    const int first = static_cast<int>(result.points.size());
    for (int k = 0; k < corners; ++k) {
      // Counter-clockwise as the plane is seen.
      const double angle = 2.0 * M_PI * (upward ? k : -k) / corners;
      Vector3d rim;
      rim[axis] = at;
      rim[(axis + 1) % 3] = centre.x() + radius * std::cos(angle);
      rim[(axis + 2) % 3] = centre.y() + radius * std::sin(angle);
      result.points.push_back(rim);
      rim[axis] = bottom;
      result.points.push_back(rim);
      hole[corners - 1 - k] = first + 2 * k;
    }
    // The wall faces the hole's axis; the bottom is a fan from its first corner.
    for (int k = 0; k < corners; ++k) {
      const int a = first + 2 * k, b = first + 2 * ((k + 1) % corners);
      result.triangles.push_back({a, b, b + 1});
      result.triangles.push_back({a, b + 1, a + 1});
      if (k > 1) result.triangles.push_back({first + 1, first + 2 * (k - 1) + 1, a + 1});
    }
    holes.push_back(std::move(hole));
  }
  // Sides around the holes are open, too; these are those of the holes.
  std::vector<std::pair<int, int>> sides;
  for (const auto& side : unmatched(result.triangles)) {
    if (side.first < static_cast<int>(model.points.size())) sides.push_back(side);
  }
  close_in_plane(result, axis, upward, std::move(sides), holes);
  drop_unused_points(result);
  return result;
}

}  // namespace hull::production
