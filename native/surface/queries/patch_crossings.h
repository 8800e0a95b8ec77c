// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/pieces/bezier_patch.h"

namespace hull::surface {

// A point of a patch on the third axis.
struct Crossing {
  double z, u, v;
  // How much z may be off, by the tolerance; infinite where the axis only touches the patch.
  double z_error;
};

// The patch runs along the third axis from one to the other.
struct AxisStretch {
  Crossing begin, end;
};

// Where a patch meets the axis x = y = 0: what ray_hits.h promises, for one piece, in a frame
// whose third axis is the ray.
class PatchCrossings {
 public:
  // `tolerance`: what counts as on the axis, m. `touching`: below this extent parts that the axis
  // may touch are no longer told apart, m. Only crossings of `z_min` <= z <= `z_max` are wanted.
  PatchCrossings(double tolerance, double touching, double z_min, double z_max)
      : tolerance_(tolerance), touching_(touching), z_min_(z_min), z_max_(z_max) {}

  // Appends to what crossings() and stretches() hold.
  void find(const BezierPatch& patch);

  const std::vector<Crossing>& crossings() const { return crossings_; }
  const std::vector<AxisStretch>& stretches() const { return stretches_; }

 private:
  using Part = PatchPart;
  enum class Outcome { kNone, kOne, kUnknown };

  void find(const BezierPatch& patch, const Part& part);
  bool is_passed(const BezierPatch& patch) const;
  Outcome try_single(const BezierPatch& patch, const Part& part);
  bool try_stretch(const BezierPatch& patch, const Part& part);
  void try_touching(const BezierPatch& patch, const Part& part);
  bool find_on_sides(const BezierPatch& patch, double& u, double& v, SurfaceJet& jet) const;
  void split(const BezierPatch& patch, const Part& part);

  double tolerance_, touching_, z_min_, z_max_;
  int parts_ = 0;
  std::vector<Crossing> crossings_;
  std::vector<AxisStretch> stretches_;
};

}  // namespace hull::surface
