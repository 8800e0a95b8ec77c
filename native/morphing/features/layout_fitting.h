// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "modelling/fit/fit.h"
#include "modelling/reshape/move_space.h"
#include "morphing/features/layout_fit.h"

namespace hull::morphing {

// Where a member between two hulls of one topology is folded, of kFoldTrials; none: nowhere.
std::optional<Vector3d> fold_between(const surface::LimitSurface& first,
                                     const surface::LimitSurface& second);

// Control points that are in the centre plane, rising.
std::vector<int> points_in_centre_plane(const surface::LimitSurface& surface);

// Ways to a second hull, of which one leads where another does not.
struct LayoutWay {
  // The edge of a bar keel that has no counterpart keeps its distance from the centre plane. The
  // strip between is so narrow that it may turn over where the second hull has no such edge to lie
  // along; but held, it may lie less near.
  bool holds_bar = false;
  // Bending of the moves is measured by the first hull in the second one's box, in place of the
  // layout as it is near by: where lines have drawn that together or over, it is a bad measure.
  // Container ship and bulk carrier come nearer one another with it, and with fewer marks.
  bool has_first_metric = false;
};

// A fit with one stiffness of the moves from where it begins.
struct FitStage {
  double stiffness;  // as FitOptions has it
  int most_steps;
};

// A layout on its way to the second hull.
class LayoutFitting {
 public:
  // All but `options` and `way` must outlive it.
  LayoutFitting(const surface::LimitSurface& first, const surface::LimitSurface& second,
                const FeatureGraph& other, const LayoutOptions& options, const LayoutWay& way);

  // Fits the layout from where its points are now: near enough to tell what is square and flat in
  // both hulls, and then with that. Returns where a step that is not taken would fold a member.
  std::optional<Vector3d> fit(surface::LimitSurface& layout, const FeatureGraph& graph,
                              const FeatureMatch& match, bool is_far,
                              std::vector<CommonFlat>& flats) const;

 private:
  // Whether the distances both ways are within the tolerance.
  bool is_met(const surface::LimitSurface& layout) const;
  std::optional<Vector3d> approach(surface::LimitSurface& layout,
                                   const std::vector<modelling::FitCurve>& curves,
                                   const modelling::ReshapeLimits& limits,
                                   const std::vector<modelling::FitBound>& bounds,
                                   const surface::LimitSurface* metric,
                                   std::span<const FitStage> stages) const;

  const surface::LimitSurface& first_;
  const surface::LimitSurface& second_;
  const FeatureGraph& other_;
  surface::Progress progress_;
  double tolerance_;  // m
  LayoutWay way_;
  modelling::FitTarget target_;
};

}  // namespace hull::morphing
