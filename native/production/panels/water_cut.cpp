// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/panels/water_cut.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "analysis/arithmetic/bracketed_root.h"
#include "mesh/tolerances.h"

namespace hull::production {
namespace {

// Points of the grid are moved to the water's surface over at most this part of a side …
constexpr double kNearWater = 0.3;
// … or this, where they would leave a knuckle.
constexpr double kAtWater = 1e-3;
// Twice the area, of the longer diagonal's square, of what is a line.
constexpr double kNoPanel = 1e-10;

std::uint64_t side_key(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<unsigned>(std::max(a, b));
}

// Which points may be moved along which sides: those on a knuckle along it only, and those where
// knuckles end or meet not at all.
class MovablePoints {
 public:
  explicit MovablePoints(const HullGrid& grid) : count_(grid.points.size(), 0) {
    for (const auto& [a, b] : grid.knuckles) {
      sides_[side_key(a, b)] = 1;
      ++count_[a];
      ++count_[b];
    }
  }

  bool may_move(int point, int along) const {
    // A point inside a knuckle has two of its sides, an end one, a crossing more.
    if (count_[point] == 0) return true;
    return count_[point] == 2 && sides_.count(side_key(point, along)) > 0;
  }

 private:
  std::vector<int> count_;
  std::unordered_map<std::uint64_t, char> sides_;
};

}  // namespace

WaterCut::WaterCut(const surface::LimitSurface& surface, const HullGrid& grid,
                   const analysis::Plane& water, const surface::Progress& progress)
    : surface_(surface), grid_(grid), water_(water), points_(grid.points) {
  find_labels();
  const double quads = static_cast<double>(grid.quads.size());
  find_crossings(surface::part_of(progress, 0.0, 0.5));
  move_to_water();
  for (std::size_t quad = 0; quad < grid.quads.size(); ++quad) {
    if (quad % 1024 == 0) surface::tell(progress, 0.5 * (quads + quad), quads);
    cut_quad(static_cast<int>(quad));
  }
}

void WaterCut::find_labels() {
  // The rounding of a few sums.
  const double zero = 10.0 * kZeroHeight * surface_.mesh().size();
  for (const Vector3d& p : points_) {
    const double height = water_.height(p);
    label_.push_back(std::abs(height) <= zero ? 0 : (height < 0.0 ? -1 : 1));
  }
}

// Exact on the surface; closings are straight between their points.
Vector3d WaterCut::on_side(int quad, int side, double t) const {
  const int next = (side + 1) % 4;
  const QuadPlace& place = grid_.places[quad];
  if (place.cell < 0) {
    const Vector3d &a = grid_.points[grid_.quads[quad][side]],
                   &b = grid_.points[grid_.quads[quad][next]];
    return a + t * (b - a);
  }
  const Eigen::Vector2d uv = (1.0 - t) * place.uv[side] + t * place.uv[next];
  Vector3d p =
      surface_.position(place.cell, std::clamp(uv.x(), 0.0, 1.0), std::clamp(uv.y(), 0.0, 1.0));
  if (place.image) p.y() = -p.y();
  return p;
}

void WaterCut::find_crossings(const surface::Progress& progress) {
  for (std::size_t quad = 0; quad < grid_.quads.size(); ++quad) {
    if (quad % 1024 == 0) surface::tell(progress, static_cast<double>(quad), grid_.quads.size());
    for (int side = 0; side < 4; ++side) {
      const int a = grid_.quads[quad][side], b = grid_.quads[quad][(side + 1) % 4];
      // A side belongs to two quadrilaterals: the first of them makes its point.
      if (label_[a] * label_[b] >= 0) continue;
      const auto [place, is_new] = crossings_.try_emplace(side_key(a, b));
      if (!is_new) continue;
      const int q = static_cast<int>(quad);
      const double t = analysis::bracketed_root(
          [&](double s) { return water_.height(on_side(q, side, s)); }, 0.0,
          water_.height(grid_.points[a]), 1.0, water_.height(grid_.points[b]), 1e-15);
      Vector3d p = on_side(q, side, t);
      // The root is to 1e-15 of the side; what is left is taken off, so that the height is 0 to
      // rounding.
      p -= water_.height(p) * water_.normal;
      // Sides in the centre plane stay there.
      if (grid_.points[a].y() == 0.0 && grid_.points[b].y() == 0.0 && water_.normal.y() == 0.0) {
        p.y() = 0.0;
      }
      place->second = {static_cast<int>(points_.size()), a < b ? t : 1.0 - t};
      points_.push_back(p);
      label_.push_back(0);
    }
  }
}

// Panels that are cut near a corner would be slivers.
void WaterCut::move_to_water() {
  const MovablePoints movable(grid_);
  // The nearest of the crossings that a point may be moved to.
  struct Move {
    double length;
    int to;
  };
  std::unordered_map<int, Move> moves;
  for (const auto& [key, crossing] : crossings_) {
    const int low = static_cast<int>(key >> 32), high = static_cast<int>(key & 0xffffffffu);
    for (const auto& [point, other, part] :
         {std::tuple(low, high, crossing.part), std::tuple(high, low, 1.0 - crossing.part)}) {
      // Knuckles in the centre plane never leave it: both halves meet there.
      const bool keeps = grid_.points[point].y() != 0.0;
      const bool free = movable.may_move(point, other);
      if (part > (free ? kNearWater : keeps ? kAtWater : 0.0)) continue;
      const double length = (points_[crossing.point] - grid_.points[point]).norm();
      const auto [place, is_new] = moves.try_emplace(point, Move{length, crossing.point});
      const Move& known = place->second;
      // The order in which crossings come must not matter.
      const bool better =
          length < known.length || (length == known.length && crossing.point < known.to);
      if (!is_new && better) place->second = {length, crossing.point};
    }
  }
  for (const auto& [point, move] : moves) {
    points_[point] = points_[move.to];
    // Its crossings are void by that: sides that end at label 0 have none.
    label_[point] = 0;
  }
  for (std::size_t p = 0; p < grid_.points.size(); ++p) {
    if (label_[p] == 0) points_[p] -= water_.height(points_[p]) * water_.normal;
  }
}

const WaterCut::Crossing* WaterCut::crossing(int a, int b) const {
  if (label_[a] * label_[b] >= 0) return nullptr;
  return &crossings_.at(side_key(a, b));
}

void WaterCut::cut_quad(int quad) {
  Polygon polygon;
  bool is_wet = false;
  const double none = kNoLength * surface_.mesh().size();
  // Corners that were moved to one place are one, so that polygons have no side without length.
  const auto same = [&](int p, int q) { return (points_[p] - points_[q]).norm() <= none; };
  const auto add = [&](int p) {
    if (polygon.empty() || !same(polygon.back(), p)) polygon.push_back(p);
  };
  for (int side = 0; side < 4; ++side) {
    const int a = grid_.quads[quad][side], b = grid_.quads[quad][(side + 1) % 4];
    if (label_[a] <= 0) add(a);
    is_wet = is_wet || label_[a] < 0;
    if (const Crossing* found = crossing(a, b)) add(found->point);
  }
  if (polygon.size() > 1 && same(polygon.front(), polygon.back())) polygon.pop_back();
  if (!is_wet || polygon.size() < 3) return;
  // Six corners are two wet ones, opposite each other, with all four sides passed.
  polygon.size() == 6 ? cut_across(quad, polygon) : add_polygon(std::move(polygon));
}

// Two corners that face each other are wet: by the middle, whether what lies between them is.
// Either one panel across the middle, or a triangle at each of the two corners.
void WaterCut::cut_across(int quad, const Polygon& polygon) {
  const QuadPlace& place = grid_.places[quad];
  Vector3d middle = Vector3d::Zero();
  if (place.cell < 0) {
    for (int p : grid_.quads[quad]) middle += 0.25 * grid_.points[p];
  } else {
    const Eigen::Vector2d uv = 0.25 * (place.uv[0] + place.uv[1] + place.uv[2] + place.uv[3]);
    middle = surface_.position(place.cell, uv.x(), uv.y());
    if (place.image) middle.y() = -middle.y();
  }
  if (water_.height(middle) < 0.0) return add_polygon(polygon);
  for (int k = 0; k < 6; ++k) {
    if (label_[polygon[k]] < 0)
      add_polygon({polygon[(k + 5) % 6], polygon[k], polygon[(k + 1) % 6]});
  }
}

double WaterCut::least_angle(const Polygon& polygon) const {
  const int n = static_cast<int>(polygon.size());
  // Twice the vector area; it says which way the polygon turns.
  Vector3d normal = Vector3d::Zero();
  for (int k = 1; k + 1 < n; ++k) {
    const Vector3d& a = points_[polygon[0]];
    normal += (points_[polygon[k]] - a).cross(points_[polygon[k + 1]] - a);
  }
  double least = std::numbers::pi;
  for (int k = 0; k < n; ++k) {
    const Vector3d& p = points_[polygon[k]];
    const Vector3d out = points_[polygon[(k + 1) % n]] - p,
                   in = points_[polygon[(k + n - 1) % n]] - p;
    const double sine = out.cross(in).dot(normal) / std::max(normal.norm(), 1e-300);
    const double angle = std::atan2(sine, out.dot(in));
    // Beyond 180° it is negative: worse the more it is.
    least = std::min({least, angle, std::numbers::pi - angle});
  }
  return least;
}

// Cut in two along the diagonal that leaves the largest least angle, until pieces are panels.
void WaterCut::add_polygon(Polygon polygon) {
  const int n = static_cast<int>(polygon.size());
  const auto wets =
      std::count_if(polygon.begin(), polygon.end(), [&](int p) { return label_[p] < 0; });
  if (wets == 0) return;
  // A triangle of which a corner is wet can lie in the water's surface with two corners at most.
  if (n == 3) return add_panel(polygon);
  // With corners in the water's surface a quadrilateral must be convex, and three of them are too
  // many.
  if (n == 4 && n - wets < 3 && (n - wets == 0 || least_angle(polygon) > 0.0)) {
    return add_panel(polygon);
  }
  double best = -10.0;
  Polygon first, second;
  for (int i = 0; i < n; ++i) {
    for (int j = i + 2; j < std::min(n, n + i - 1); ++j) {  // each diagonal once, no sides
      // A diagonal in the water's surface would leave a piece that lies in it, or above.
      if (label_[polygon[i]] == 0 && label_[polygon[j]] == 0) continue;
      const Polygon one(polygon.begin() + i, polygon.begin() + j + 1);
      Polygon other(polygon.begin() + j, polygon.end());
      other.insert(other.end(), polygon.begin(), polygon.begin() + i + 1);
      const double angle = std::min(least_angle(one), least_angle(other));
      if (angle <= best) continue;
      best = angle;
      first = one;
      second = other;
    }
  }
  assert(!first.empty());  // from a wet corner there is a diagonal
  add_polygon(std::move(first));
  add_polygon(std::move(second));
}

void WaterCut::add_panel(const Polygon& polygon) {
  const Vector3d &a = points_[polygon[0]], &b = points_[polygon[1]], &c = points_[polygon[2]],
                 &d = points_[polygon.back()];
  // Where closing lines run along the border itself nothing lies between them.
  const double longest = std::max((c - a).squaredNorm(), (d - b).squaredNorm());
  if ((c - a).cross(d - b).norm() <= kNoPanel * longest) return;
  panels_.push_back({polygon[0], polygon[1], polygon[2], polygon.back()});
}

}  // namespace hull::production
