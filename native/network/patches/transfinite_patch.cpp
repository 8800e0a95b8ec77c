// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/patches/transfinite_patch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "network/patches/coons_gregory.h"
#include "network/patches/corner_blend.h"

namespace hull::network {
namespace {

constexpr int kMostSides = 10;
constexpr double kAgreement = 1e-9;  // of the size, and of ribbons' lengths
constexpr int kLengthParts = 16;

double side_length(const RibbonedSide& side) {
  double length = 0.0;
  Vector3d before = side(0.0).point;
  for (int i = 1; i <= kLengthParts; ++i) {
    const Vector3d next = side(static_cast<double>(i) / kLengthParts).point;
    length += (next - before).norm();
    before = next;
  }
  return length;
}

// In the middle the ribbon of a half is the other half's slope, from there; to the half's other end
// it becomes what it was, all the way in the side's tangent plane.
RibbonedSide half_of(const RibbonedSide& side, bool is_first) {
  return [side, is_first](double u) {
    const SideJet whole = side(0.5 * (is_first ? u : 1.0 + u));
    const Vector3d slope = 0.5 * whole.slope, bend = 0.25 * whole.bend;
    const double w = is_first ? u : 1.0 - u, sense = is_first ? 1.0 : -1.0;
    // With its slope it fades to nothing at the half's other end, where the ribbon is to be met.
    const double share = w * w, rise = 2.0 * sense * w;
    return SideJet{whole.point, slope, (1.0 - share) * whole.ribbon + share * sense * slope,
                   (1.0 - share) * 0.5 * whole.ribbon_slope + share * sense * bend +
                       rise * (sense * slope - whole.ribbon),
                   bend};
  };
}

// Two sides have two corners only: a third one in the longer side makes a triangle of them.
std::vector<RibbonedSide> with_halved_side(const std::vector<RibbonedSide>& sides) {
  const std::size_t longer = side_length(sides[1]) > side_length(sides[0]) ? 1 : 0;
  // The other side's ribbons are slopes of halves at its ends.
  const RibbonedSide other = [whole = sides[1 - longer]](double u) {
    SideJet jet = whole(u);
    jet.ribbon *= 0.5;
    jet.ribbon_slope *= 0.5;
    return jet;
  };
  return {other, half_of(sides[longer], true), half_of(sides[longer], false)};
}

// The side with what it was at each parameter asked for before.
RibbonedSide remembering(const RibbonedSide& side) {
  // By a pointer: the function itself is const, and its copies know the same.
  return [side, known = std::make_shared<std::unordered_map<double, SideJet>>()](double u) {
    const auto found = known->find(u);
    return found != known->end() ? found->second : known->emplace(u, side(u)).first->second;
  };
}

PatchPoint point_of(const std::vector<RibbonedSide>& sides, const std::vector<Vector2d>& domain,
                    const Vector2d& place) {
  return sides.size() == 4 ? coons_gregory(sides, place) : corner_blend(sides, domain, place);
}

}  // namespace

TransfinitePatch::TransfinitePatch(std::vector<RibbonedSide> sides) : sides_(std::move(sides)) {
  const auto count = static_cast<int>(sides_.size());
  if (count < 2 || count > kMostSides) {
    throw std::invalid_argument("A patch has two to " + std::to_string(kMostSides) +
                                " sides, not " + std::to_string(count) + ".");
  }
  // As given: halves of a side agree by the way they are made.
  check();
  if (count == 2) sides_ = with_halved_side(sides_);
  if (count == 4) {
    domain_ = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    return;
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides_.size());
    domain_.emplace_back(std::cos(angle), std::sin(angle));
  }
}

void TransfinitePatch::check() const {
  double size = 0.0;
  for (const RibbonedSide& side : sides_) size = std::max(size, side_length(side));
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const std::size_t next = (i + 1) % sides_.size();
    const SideJet a = sides_[i](1.0), b = sides_[next](0.0);
    // What is no number agrees with nothing.
    if (!((a.point - b.point).norm() <= kAgreement * size)) {
      throw std::invalid_argument("Side " + std::to_string(i) +
                                  " of the patch ends elsewhere than side " + std::to_string(next) +
                                  " begins.");
    }
    const double length = std::max(a.slope.norm(), b.slope.norm());
    if (!((a.ribbon - b.slope).norm() <= kAgreement * length &&
          (b.ribbon + a.slope).norm() <= kAgreement * length)) {
      throw std::invalid_argument(
          "The ribbons of sides " + std::to_string(i) + " and " + std::to_string(next) +
          " of the patch are not the slopes of one another where they meet.");
    }
  }
}

PatchPoint TransfinitePatch::at(const Vector2d& place) const {
  return point_of(sides_, domain_, place);
}

std::vector<PatchPoint> TransfinitePatch::at_all(const std::vector<Vector2d>& places) const {
  std::vector<RibbonedSide> sides;
  // Remembered within this call alone: patches may be asked on several threads.
  for (const RibbonedSide& side : sides_) sides.push_back(remembering(side));
  std::vector<PatchPoint> points;
  for (const Vector2d& place : places) points.push_back(point_of(sides, domain_, place));
  return points;
}

}  // namespace hull::network
