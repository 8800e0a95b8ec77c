// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/fair_limits.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "modelling/complement.h"

namespace hull::modelling {
namespace {

// Of a unit normal's part across the ship: less has no direction.
constexpr double kNoNormal = 1e-6;
// Of a bound: less is beyond it by rounding alone.
constexpr double kFarther = 1e-8;

std::vector<int> unique_points(std::vector<int> points, int count) {
  if (points.empty()) throw std::invalid_argument("Choose the control points that are to move.");
  for (int point : points) check_point(point, count, "chosen");
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// What a chosen point may not move along.
void hold_across(const surface::LimitSurface& surface, const FairOptions& options, int point,
                 std::vector<HeldDirection>& held) {
  const mesh::Topology& t = surface.mesh().topology();
  if (options.keep_stations) held.push_back({point, Vector3d::UnitX()});
  if (!options.along_normals || t.kind(point) != mesh::VertexKind::kSmooth) return;
  // Cells begin at the corners of faces, in the order of half-edges.
  Vector3d normal = surface.normal(t.outgoing(point), 0.0, 0.0);
  // Its part across the ship: with x held the point has that one direction left.
  if (options.keep_stations) normal.x() = 0.0;
  if (!(normal.norm() > kNoNormal)) return;
  for (const Vector3d& across : complement<Vector3d>({normal}, 3)) held.push_back({point, across});
}

}  // namespace

ReshapeLimits fair_limits(const surface::LimitSurface& surface, const FairOptions& options) {
  if (!options.limits.prescribed.empty()) {
    throw std::invalid_argument("No moves can be prescribed where a region is faired.");
  }
  const mesh::Topology& t = surface.mesh().topology();
  const std::vector<int> chosen = unique_points(options.points, t.vertex_count());
  ReshapeLimits limits = options.limits;
  std::size_t next = 0;
  for (int point = 0; point < t.vertex_count(); ++point) {
    const bool is_chosen = next < chosen.size() && chosen[next] == point;
    if (is_chosen) ++next;
    const bool is_kept = options.keep_creases && t.kind(point) != mesh::VertexKind::kSmooth;
    if (!is_chosen || is_kept) {
      limits.limits.locked.push_back(point);
    } else {
      hold_across(surface, options, point, limits.limits.held);
    }
  }
  return limits;
}

void check_bounds(double deviation, double largest) {
  if (!(deviation >= 0.0) || !std::isfinite(deviation)) {
    throw std::invalid_argument("The deviation must not be negative, nor infinite.");
  }
  if (!(largest > 0.0)) throw std::invalid_argument("The largest shift must be above zero.");
}

void refuse_farther(const Faired& faired, double deviation, double largest) {
  std::ostringstream words;
  words.precision(3);
  if (faired.rms > deviation * (1.0 + kFarther)) {
    words << "What is to be kept needs shifts of " << faired.rms
          << " m RMS, which is more than the deviation";
  } else if (faired.largest > largest * (1.0 + kFarther)) {
    words << "What is to be kept was found with a shift of " << faired.largest
          << " m alone, which is more than the largest shift";
  } else {
    return;
  }
  words << ": give a larger one, choose more points, or keep less.";
  throw std::invalid_argument(words.str());
}

}  // namespace hull::modelling
