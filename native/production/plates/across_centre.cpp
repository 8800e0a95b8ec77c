// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/across_centre.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/tolerances.h"

namespace hull::production {

namespace {

// Of the mean normal: plates that face more to the side than this are not bent around the stem.
constexpr double kMostAside = 0.6;

// The sides with those that run along the centre plane apart from what else is border.
std::vector<PlateSide> with_central_apart(const PlatedShell& shell,
                                          const std::vector<PlateSide>& loop) {
  const auto is_on = [&shell](int p) { return is_central(shell.surface, shell.mesh.points[p]); };
  std::vector<PlateSide> sides;
  for (const PlateSide& side : loop) {
    for (std::size_t i = 0; i + 1 < side.points.size(); ++i) {
      const int a = side.points[i], b = side.points[i + 1];
      const bool central = side.curve < 0 && is_on(a) && is_on(b);
      // A stretch goes on within one side as long as its parts are of one kind.
      const bool goes_on = i > 0 && !sides.empty() &&
                           central == (is_on(sides.back().points.front()) &&
                                       is_on(sides.back().points[1]) && side.curve < 0);
      if (!goes_on) sides.push_back({side.curve, {a}});
      sides.back().points.push_back(b);
    }
  }
  return sides;
}

bool is_central_side(const PlatedShell& shell, const PlateSide& side) {
  return side.curve < 0 && std::all_of(side.points.begin(), side.points.end(), [&](int p) {
           return is_central(shell.surface, shell.mesh.points[p]);
         });
}

// Whether a plate faces where kMostAside lets it, and by what it and its mirror image are bent in
// the centre plane, rad.
std::pair<bool, double> bend_in_centre(const PlatedShell& shell, const Plate& plate) {
  Vector3d sum = Vector3d::Zero();
  double aside = 0.0;
  for (const int t : plate.triangles) {
    const ShellTriangle& triangle = shell.mesh.triangles[t];
    const auto corner = [&](int k) { return shell.mesh.points[triangle.points[k]]; };
    // Doubled areas: only the direction of the sum counts.
    sum += (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (!is_central(shell.surface, corner(k)) || !is_central(shell.surface, corner(next)))
        continue;
      const Eigen::Vector2d middle = 0.5 * (triangle.uv[k] + triangle.uv[next]);
      const Vector3d normal = shell.surface.normal(triangle.cell, middle.x(), middle.y());
      // The image's normal is this one with -y: the angle between both is twice that whose sine is
      // y.
      aside = std::max(aside, std::abs(normal.y()));
    }
  }
  return {std::abs(sum.y()) <= kMostAside * sum.norm(), 2.0 * std::asin(std::min(aside, 1.0))};
}

}  // namespace

bool is_central(const surface::LimitSurface& surface, const Vector3d& point) {
  return std::abs(point.y()) <= kOnCentrePlane * surface.mesh().size();
}

void join_across_centre(const PlatedShell& shell, double largest_knuckle, Plate& plate) {
  if (plate.loops.size() != 1) return;
  std::vector<PlateSide> sides = with_central_apart(shell, plate.loops.front());
  // A central stretch that the loop begins and ends with is one.
  if (sides.size() > 1 && is_central_side(shell, sides.front()) &&
      is_central_side(shell, sides.back())) {
    sides.back().points.insert(sides.back().points.end(), sides.front().points.begin() + 1,
                               sides.front().points.end());
    sides.erase(sides.begin());
  }
  const auto is_middle = [&](const PlateSide& side) { return is_central_side(shell, side); };
  if (std::count_if(sides.begin(), sides.end(), is_middle) != 1 || sides.size() < 2) return;
  const auto [faces_so, bend] = bend_in_centre(shell, plate);
  if (!faces_so) return;
  plate.centre_knuckle = bend;
  if (bend > largest_knuckle) return;
  // The border from the centre plane back to the centre plane, then its image the other way.
  const auto middle = std::find_if(sides.begin(), sides.end(), is_middle);
  std::rotate(sides.begin(), middle + 1, sides.end());
  sides.pop_back();
  std::vector<PlateSide> whole = sides;
  for (auto side = sides.rbegin(); side != sides.rend(); ++side) {
    whole.push_back({side->curve, {side->points.rbegin(), side->points.rend()}, true});
  }
  plate.loops = {std::move(whole)};
  plate.across = true;
  plate.area *= 2.0;
  plate.centre.y() = 0.0;
  for (Vector3d end : {plate.box.min(), plate.box.max()}) {
    end.y() *= -1.0;
    plate.box.extend(end);
  }
}

}  // namespace hull::production
