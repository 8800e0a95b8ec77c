// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/patches/corner_blend.h"

#include <algorithm>

#include "network/patches/dual.h"

namespace hull::network {
namespace {

// From the line of a side of the polygon, above zero inside.
Dual distance_from(const Vector2d& from, const Vector2d& to, const Vector2d& place) {
  const Vector2d along = (to - from).normalized();
  const Vector2d inwards(-along[1], along[0]);
  // On the side itself rounding is not to make it less than zero.
  return {std::max(0.0, inwards.dot(place - from)), inwards};
}

// The side after a corner and the one before, both from it.
struct Corner {
  const RibbonedSide& after;
  const RibbonedSide& before;
};

struct FromCorner {
  DualPlace place, ribbon;
  Vector3d corner, slope, twist;  // at the corner
};

// A side's jet in the sense away from the corner.
FromCorner from_corner(const RibbonedSide& side, const Dual& t, bool is_turned) {
  const double sense = is_turned ? -1.0 : 1.0;
  const SideJet jet = side(is_turned ? 1.0 - t.value : t.value);
  const SideJet at_corner = side(is_turned ? 1.0 : 0.0);
  return {along(jet.point, sense * jet.slope, t), along(jet.ribbon, sense * jet.ribbon_slope, t),
          at_corner.point, sense * at_corner.slope, sense * at_corner.ribbon_slope};
}

DualPlace corner_patch(const Corner& corner, const Dual& u, const Dual& v) {
  const FromCorner after = from_corner(corner.after, u, false);
  const FromCorner before = from_corner(corner.before, v, true);
  // Off both sides along their ribbons, less the plane and the twist that both have at the corner.
  const DualPlace ruled = before.place + u * before.ribbon + after.place + v * after.ribbon;
  const Dual sum = u + v;
  const Dual share = sum.value > 0.0 ? v / sum : Dual{0.5, Vector2d::Zero()};
  // Where v = 0 the ribbon of the side before is in the way of that of the side after: its twist.
  const DualPlace twist = share * fixed(after.twist) + (1.0 - share) * fixed(before.twist);
  return ruled - fixed(after.corner) - u * fixed(after.slope) - v * fixed(before.slope) -
         u * v * twist;
}

}  // namespace

PatchPoint corner_blend(const std::vector<RibbonedSide>& sides,
                        const std::vector<Vector2d>& polygon, const Vector2d& place) {
  const std::size_t count = sides.size();
  std::vector<Dual> d;
  for (std::size_t i = 0; i < count; ++i) {
    d.push_back(distance_from(polygon[i], polygon[(i + 1) % count], place));
  }
  DualPlace sum;
  Dual all{0.0, Vector2d::Zero()};
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t before = (j + count - 1) % count;
    Dual weight{1.0, Vector2d::Zero()};
    for (std::size_t i = 0; i < count; ++i) {
      // Squared, so that on all other sides the corner's patch counts for nothing with its slope as
      // well: a side is met, in its tangent plane, by the patches at its ends alone.
      if (i != j && i != before) weight = weight * d[i] * d[i];
    }
    // There two distances whose sum divides may both be zero, too.
    if (!(weight.value > 0.0)) continue;
    // On side j u goes from 0, where the side before it ends, to 1, where the next one begins; v on
    // the side before from 0, where side j begins, backwards to 1.
    const std::size_t next = (j + 1) % count, second_before = (j + count - 2) % count;
    const Dual u = d[before] / (d[before] + d[next]), v = d[j] / (d[second_before] + d[j]);
    sum = sum + weight * corner_patch({sides[j], sides[before]}, u, v);
    all = all + weight;
  }
  const Dual scale = Dual{1.0, Vector2d::Zero()} / all;
  const DualPlace point = scale * sum;
  return {point.value, point.by.col(0), point.by.col(1)};
}

}  // namespace hull::network
