// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/longitudinal_reshape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "mesh/groups.h"
#include "mesh/tolerances.h"
#include "modelling/transformation/smooth_step.h"

namespace hull::modelling {
namespace {

// Of a normal: beyond, its plane is raked.
constexpr double kRaked = 1e-9;

// Ties of the ends of creases' and borders' edges in planes across the ship, but where a point is
// among those whose moves are settled otherwise.
std::vector<TiedPoint> ties_across(const surface::LimitSurface& surface,
                                   const std::vector<char>& is_settled) {
  const mesh::Topology& t = surface.mesh().topology();
  const std::vector<Vector3d>& points = surface.mesh().points();
  const double least = kInPlane * surface.mesh().size();
  std::vector<TiedPoint> ties;
  for (int h = 0; h < t.half_edge_count(); ++h) {
    const int a = t.origin(h), b = t.origin(t.next(h));
    if (!t.is_crease(h) || std::abs(points[a].x() - points[b].x()) > least) continue;
    if (is_settled[a] || is_settled[b]) continue;
    // Of an inner crease both half-edges come, and say the same: of dependent ties one counts.
    ties.push_back({a, b, Vector3d::UnitX()});
  }
  return ties;
}

ReshapeOptions options_for(const surface::LimitSurface& surface, const TransformLimits& limits,
                           const std::vector<int>& rigid) {
  const std::vector<Vector3d>& points = surface.mesh().points();
  ReshapeOptions options;
  options.limits.limits = limits.limits;
  std::vector<char> is_raked(points.size(), 0);
  for (const HeldDirection& held : limits.limits.held) {
    check_point(held.point, static_cast<int>(points.size()), "held");
    if (std::abs(held.normal.normalized().x()) > kRaked) is_raked[held.point] = 1;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    // In a raked plane a point that moves along the ship must rise or spread as well.
    if (is_raked[i]) continue;
    options.limits.limits.held.push_back({static_cast<int>(i), Vector3d::UnitY()});
    options.limits.limits.held.push_back({static_cast<int>(i), Vector3d::UnitZ()});
  }
  for (const TiedPoint& tied : limits.tied) {
    // Where neither of the two may leave its height the others say nothing.
    if (is_raked[tied.point] || is_raked[tied.leader] || tied.direction.x() != 0.0) {
      options.limits.tied.push_back(tied);
    }
  }
  for (const MoveCondition& sum : limits.kept) {
    // Rigid groups move as one whatever such sums say.
    const auto is_rigid = [&](int point) { return std::ranges::find(rigid, point) != rigid.end(); };
    if (!std::ranges::all_of(sum.points, is_rigid)) options.limits.kept.push_back(sum);
  }
  // A tie to a point that stays, or is told how to move, would hold the other one, too.
  std::vector<char> is_settled = is_raked;
  for (int point : limits.limits.locked) {
    check_point(point, static_cast<int>(points.size()), "locked");
    is_settled[point] = 1;
  }
  for (int point : rigid) is_settled[point] = 1;
  const std::vector<TiedPoint> across = ties_across(surface, is_settled);
  options.limits.tied.insert(options.limits.tied.end(), across.begin(), across.end());
  options.limits.prescribed = rigid;
  return options;
}

}  // namespace

std::vector<std::vector<int>> plane_ends(const surface::LimitSurface& surface) {
  const mesh::Topology& t = surface.mesh().topology();
  const std::vector<Vector3d>& points = surface.mesh().points();
  mesh::Groups groups(static_cast<int>(points.size()));
  std::set<int> found;
  for (int face = 0; face < t.face_count(); ++face) {
    const int h = t.first_half_edge(face);
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < t.face_size(face); ++k) {
      low = std::min(low, points[t.origin(h + k)].x());
      high = std::max(high, points[t.origin(h + k)].x());
    }
    // All of a face must be at one x: an edge across the ship alone is any frame's.
    if (high - low > kInPlane * surface.mesh().size()) continue;
    for (int k = 0; k < t.face_size(face); ++k) {
      found.insert(t.origin(h + k));
      groups.join(t.origin(h), t.origin(h + k));
    }
  }
  std::map<int, std::vector<int>> members;
  for (int point : found) members[groups.find(point)].push_back(point);
  std::vector<std::vector<int>> result;
  for (auto& [group, own] : members) result.push_back(std::move(own));
  return result;
}

struct LongitudinalReshape::Rigid {
  std::vector<int> points, group_of;
  std::vector<Group> groups;

  Rigid(const std::vector<Vector3d>& control_points, const TransformLimits& limits) {
    std::set<int> staying(limits.limits.locked.begin(), limits.limits.locked.end()), known;
    // Where a flat is across the ship its points stay in it.
    for (const HeldDirection& one : limits.limits.held) {
      if (std::abs(one.normal.normalized().x()) > kRaked) staying.insert(one.point);
    }
    for (const std::vector<int>& group : limits.rigid) {
      Group found{INFINITY, -INFINITY};
      bool stays = group.empty();
      for (int point : group) {
        check_point(point, static_cast<int>(control_points.size()), "rigid");
        found.aft = std::min(found.aft, control_points[point].x());
        found.forward = std::max(found.forward, control_points[point].x());
        stays = stays || staying.contains(point);
      }
      if (stays) continue;
      for (int point : group) {
        // A point of two groups goes with the first.
        if (!known.insert(point).second) continue;
        points.push_back(point);
        group_of.push_back(static_cast<int>(groups.size()));
      }
      groups.push_back(found);
    }
  }
};

LongitudinalReshape::LongitudinalReshape(const surface::LimitSurface& surface,
                                         const TransformLimits& limits)
    // Groups first, as the reshape's limits prescribe the moves of their points.
    : LongitudinalReshape(surface, limits, Rigid(surface.mesh().points(), limits)) {}

LongitudinalReshape::LongitudinalReshape(const surface::LimitSurface& surface,
                                         const TransformLimits& limits, const Rigid& rigid)
    : groups_(rigid.groups),
      group_of_(rigid.group_of),
      reshape_(surface, options_for(surface, limits, rigid.points)) {}

double LongitudinalReshape::Group::weight(double x) const {
  const double reach = 2.0 * (forward - aft), distance = std::abs(x - nearest(x));
  return distance < reach ? 1.0 - smooth_step(distance / reach) : 0.0;
}

double LongitudinalReshape::with_groups(const std::function<double(double x)>& shift,
                                        double x) const {
  double weights = 0.0, sum = shift(x);
  for (const Group& group : groups_) weights += group.weight(x);
  for (const Group& group : groups_) {
    const double weight = group.weight(x);
    if (!(weight > 0.0)) continue;
    // Within the group this makes it the middle's shift; outside, what is missing at its end fades.
    // Of several, as of the two halves of a transom, each counts by its share.
    sum += (shift(group.middle()) - shift(group.nearest(x))) * weight * (weight / weights);
  }
  return sum;
}

std::vector<Vector3d> LongitudinalReshape::at_places(
    const std::function<double(double x)>& shift) const {
  std::vector<Vector3d> shifts(places().count());
  for (int k = 0; k < places().count(); ++k) {
    shifts[k] = {with_groups(shift, places().position(k).x()), 0.0, 0.0};
  }
  return shifts;
}

std::vector<Vector3d> LongitudinalReshape::of_groups(
    const std::function<double(double x)>& shift) const {
  std::vector<Vector3d> prescribed;
  for (int group : group_of_) prescribed.emplace_back(shift(groups_[group].middle()), 0.0, 0.0);
  return prescribed;
}

LongitudinalReshape::Wanted LongitudinalReshape::wanted(
    const std::function<double(double x)>& shift) const {
  return {at_places(shift), of_groups(shift)};
}

Reshaped LongitudinalReshape::solve(const std::function<double(double x)>& shift) const {
  return reshape_.solve(at_places(shift), of_groups(shift));
}

std::vector<Vector3d> LongitudinalReshape::moves(const Wanted& wanted) const {
  return reshape_.moves(wanted.at_places, wanted.of_groups);
}

Residual LongitudinalReshape::residual(const std::vector<Vector3d>& moves,
                                       const Wanted& wanted) const {
  return reshape_.residual(moves, wanted.at_places);
}

}  // namespace hull::modelling
