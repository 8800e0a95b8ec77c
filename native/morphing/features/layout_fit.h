// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "morphing/features/feature_matching.h"
#include "morphing/features/kept_shape.h"
#include "surface/limit_surface.h"
#include "surface/progress.h"

namespace hull::morphing {

struct LayoutOptions {
  // Of features, by their numbers in feature_graph(): those that are paired, and that are not.
  std::vector<std::array<int, 2>> pairs, apart;
  // Of the second hull's length: where the root mean square distance is more, the layout is
  // subdivided, exactly, and fitted again, …
  double tolerance = 1e-4;
  int most_subdivisions = 1;  // … so often
  surface::Progress progress;
};

// The layout of one hull on another one: parents of a family.
struct LayoutFit {
  surface::LimitSurface
      first;  // the first hull: as given, or subdivided, which is the same surface
  surface::LimitSurface second;  // with the faces, creases and corners of `first`, on the second
  int subdivisions = 0;
  // Points of `second` that are in flats of the second hull as they are in flats of the first.
  std::vector<CommonFlat> flats = {};
  // Distances, m, of places all over the second hull from `second`, by area, and of places all over
  // `second` from the second hull.
  double rms = 0.0, largest = 0.0;
  Vector3d largest_place = Vector3d::Zero();  // on the second hull
  double rms_back = 0.0, largest_back = 0.0;
  Vector3d largest_back_place = Vector3d::Zero();  // on `second`
  // Where, on `first`, a member between the two is folded (HullFamily::first_fold() at kFoldTrials
  // members), or the layout is turned over on the second hull (LayoutTurns); none: nowhere.
  std::optional<Vector3d> fold = std::nullopt;
  // Where a member would be folded by a step that was not taken for it; none: all were.
  std::optional<Vector3d> fold_ahead = std::nullopt;
  FeatureMatch match = {};  // of the hulls as given
  // layout_shortfall(): a sentence, empty where the distances are within the tolerance and no
  // member is folded.
  std::string shortfall = {};
};

inline constexpr int kFoldTrials = 9;

// Brings the first hull's control mesh onto the second hull's exact surface. Two hulls of one
// topology, however they are numbered, need no fit: `second` is the second hull itself,
// renumbered; so are hulls of which one is the other's layout subdivided, whatever
// most_subdivisions is. Others are brought near (points_near()), and fitted step by step with less
// and less stiffness to places all over the second hull, creases and borders along their
// counterparts. Half hulls keep their points in the centre plane there and all others on their side
// of it, and with them the surface; they are square to it where both hulls are; what is flat in
// both stays flat. A step by which a member between the two would
// be folded is not taken, and the fit ends before it: with a larger distance. Of several ways the
// one without a fold is taken, or the one that comes nearest.
//
// Throws std::invalid_argument, naming them, where bodies are not paired, as for a hull with a keel
// beside one without, for a half hull beside one of both sides or of the other side, for schemes
// that differ, and as match_features() and fit() do.
LayoutFit fit_layout(const surface::LimitSurface& first, const surface::LimitSurface& second,
                     const LayoutOptions& options = {});

}  // namespace hull::morphing
