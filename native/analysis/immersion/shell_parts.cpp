// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/shell_parts.h"

#include <map>

namespace hull::analysis {

void place(ShellPart& part, const Vector3d* points, std::size_t count, const Vector3d& centre) {
  Vector3d low = points[0], high = low;
  for (std::size_t i = 1; i < count; ++i) {
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
  }
  part.middle = 0.5 * (low + high) - centre;
  part.half = 0.5 * (high - low);
}

WaterSide ShellPart::side(const Plane& water, const BodyRules& rules) const {
  const double height = water.normal.dot(middle) + water.height(rules.centre);
  // Half of the box's shadow on the normal, and heights that count as none.
  const double reach = water.normal.cwiseAbs().dot(half) + rules.cut.zero;
  if (height >= reach) return WaterSide::kAbove;
  return height < -reach ? WaterSide::kBelow : WaterSide::kAcross;
}

ShellParts::ShellParts(const surface::LimitSurface& surface, bool mirrored, double tolerance)
    : surface_(&surface),
      mirrored_(mirrored),
      tolerance_(tolerance),
      rules_(body_rules(surface, mirrored, tolerance)) {
  const surface::SurfaceLayout& layout = surface.layout();
  // Corners of one kind share a basis, and so their series.
  std::map<const surface::CornerBasis*, int> numbers;
  for (int i = 0; i < layout.corner_count(); ++i) {
    const auto [place, is_new] = numbers.emplace(&layout.basis(i), numbers.size());
    if (is_new) series_.emplace_back(layout.basis(i));
    series_of_.push_back(place->second);
  }
  leaves_.resize(layout.leaf_count());
  leaf_points_.resize(layout.leaf_count());
  corners_.resize(layout.corner_count());
  corner_points_.resize(layout.corner_count());
  for (int i = 0; i < layout.leaf_count(); ++i) update_leaf(i);
  for (int i = 0; i < layout.corner_count(); ++i) update_corner(i);
}

ShellParts::ShellParts(const ShellParts& parts, const surface::LimitSurface& copy,
                       const std::optional<Plane>& water)
    : ShellParts(parts) {
  // Parts stay as they are: the next update() finds rules without areas, which are others, and
  // computes all of them.
  surface_ = &copy;
  water_ = water;
}

BodyRules ShellParts::rules_now() const {
  const BodyRules rules = body_rules(*surface_, mirrored_, tolerance_);
  return water_ ? without_areas(rules) : rules;
}

bool ShellParts::is_asked_for(const ShellPart& part) const {
  return !water_ || part.side(*water_, rules_) == WaterSide::kBelow;
}

void ShellParts::update() {
  const BodyRules rules = rules_now();
  const bool all = !(rules == rules_);
  rules_ = rules;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    const int leaf = static_cast<int>(i);
    // By the points, not by what was told to move: a drag that ends where it began costs nothing.
    if (all || surface_->leaf(leaf) != leaf_points_[i]) update_leaf(leaf);
  }
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const int corner = static_cast<int>(i);
    if (all || surface_->corner(corner).outer != corner_points_[i]) update_corner(corner);
  }
}

void ShellParts::update_leaf(int leaf) {
  const surface::BicubicPoints& points = surface_->leaf(leaf);
  leaf_points_[leaf] = points;
  place(leaves_[leaf], points.data(), points.size(), rules_.centre);
  // Of what is above, or cut, nothing is asked for in the one water: zero, not what was there.
  leaves_[leaf].moments = {};
  if (!is_asked_for(leaves_[leaf])) return;
  leaves_[leaf].moments = span_moments({points, rules_.centre}, rules_.span, rules_.span_area);
}

void ShellParts::update_corner(int corner) {
  const surface::CornerPoints& points = surface_->corner(corner);
  const surface::CornerBasis& basis = surface_->layout().basis(corner);
  corner_points_[corner] = points.outer;
  place(corners_[corner], points.outer.data(), points.outer.size(), rules_.centre);
  corners_[corner].moments = {};
  if (!is_asked_for(corners_[corner])) return;
  surface::CornerRing ring(basis, points);
  corners_[corner].moments =
      corner_moments(ring, basis, points, series(corner), rules_.centre, rules_.corner);
}

}  // namespace hull::analysis
