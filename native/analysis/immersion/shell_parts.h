// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/immersion/body_rules.h"

namespace hull::analysis {

// Where a part lies in a water, as far as its control points tell.
enum class WaterSide { kAbove, kAcross, kBelow };

// A part of a shell whose moments are known.
struct ShellPart {
  // A box around its control points, positions counted from the rules' centre.
  Vector3d middle = Vector3d::Zero(), half = Vector3d::Zero();
  ShellMoments moments;

  WaterSide side(const Plane& water, const BodyRules& rules) const;
};

// The parts that a limit surface is made of, bicubic spans and squares at irregular knots, each
// with its moments about the rules' centre.
class ShellParts {
 public:
  // `surface` must outlive the parts.
  ShellParts(const surface::LimitSurface& surface, bool mirrored, double tolerance);

  // The same parts of a surface with the layout and points of theirs, as of a copy. With a water
  // they are for this one alone from the next update() on: only parts that lie below it have
  // moments, and these no areas.
  ShellParts(const ShellParts& parts, const surface::LimitSurface& copy,
             const std::optional<Plane>& water = std::nullopt);

  // After surface.set_points(): computes again the parts whose control points have moved. The
  // results do not depend on what was there before.
  void update();

  const surface::LimitSurface& surface() const { return *surface_; }
  const BodyRules& rules() const { return rules_; }
  // As SurfaceLayout numbers them.
  const std::vector<ShellPart>& leaves() const { return leaves_; }
  const std::vector<ShellPart>& corners() const { return corners_; }
  const CornerSeries& series(int corner) const { return series_[series_of_[corner]]; }

 private:
  BodyRules rules_now() const;
  bool is_asked_for(const ShellPart& part) const;
  void update_leaf(int leaf);
  void update_corner(int corner);

  const surface::LimitSurface* surface_;
  bool mirrored_;
  double tolerance_;
  std::optional<Plane> water_;  // the only one, if there is one
  BodyRules rules_;
  std::vector<CornerSeries> series_;  // one for each basis
  std::vector<int> series_of_;        // of each corner
  std::vector<ShellPart> leaves_, corners_;
  // What the parts were computed from.
  std::vector<surface::BicubicPoints> leaf_points_;
  std::vector<std::vector<Vector3d>> corner_points_;
};

// A part's box. REQUIRES: count > 0.
void place(ShellPart& part, const Vector3d* points, std::size_t count, const Vector3d& centre);

}  // namespace hull::analysis
