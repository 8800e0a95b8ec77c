// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include "analysis/immersion/body_stamp.h"
#include "analysis/stability/floating_descent.h"

namespace hull::analysis {

enum class TrimMode {
  kFree,   // weight and buoyancy are kept above one another lengthwise
  kFixed,  // the trim is held
};

// A heeled body at its displacement.
struct HeeledState {
  double heel = 0.0, trim = 0.0;  // rad
  double righting_lever = 0.0;    // GZ = (B - G)·starboard, m: positive rights a heel > 0
  double slope = 0.0;             // dGZ/dheel along the path, m/rad
  Immersion immersion;
  double trim_slope = 0.0;                // dtrim/dheel
  double depth = 0.0, depth_slope = 0.0;  // m, m/rad: the water over the path's middle point
  int evaluations = 0;                    // immersions computed for this state
};

// Righting levers of a body at one displacement as a function of the heel, at any heel. Each state
// is solved by Newton's method from what its solved neighbours say, and kept: what was asked before
// saves time and moves a state within the solver's tolerance (1e-11), no more.
//
// For one thread: to ask is to solve and to keep, so that nothing that asks is const. Two paths of
// one body may be in two threads. References to states stay valid as long as the path.
//
// Heeling by dφ at the trim θ costs the energy ∇ GZ cos θ dφ (times density and gravity).
class HeelingPath {
 public:
  // REQUIRES: 0 < volume < whole_volume, which greatest_volume() gives; `trim` below 90°: held, or
  // the first guess. `body` must outlive the path; once
  // its surface's points were set, or it was updated or joined to others, queries throw
  // std::invalid_argument.
  HeelingPath(const HullBody& body, double volume, double whole_volume,
              const Vector3d& centre_of_gravity, TrimMode mode, double trim = 0.0);

  // None if the ship stands on end at this heel (|trim| reaches 90°), or does not settle for want
  // of a waterplane.
  const HeeledState* find(double heel);
  // The same, but throws std::invalid_argument if there is none.
  const HeeledState& at(double heel);

  double volume() const { return task_.volume; }
  int evaluations() const { return evaluations_; }

 private:
  struct Guess {
    double trim, offset;
  };
  Guess guess(double heel);
  Guess first_guess(double heel, double trim);
  std::optional<HeeledState> solve(double heel);
  void add_slopes(HeeledState& state) const;

  const HullBody& body_;
  BodyStamp stamp_;  // of the body that states_ are of
  double whole_volume_;
  FloatingTask task_;
  double first_trim_;
  Vector3d middle_;
  std::map<double, HeeledState> states_;
  int evaluations_ = 0;
};

// ∫ GZ dheel between two angles, m·rad, to an estimated error below `tolerance`; the integral to a
// smaller angle is negative.
double lever_area(HeelingPath& path, double from, double to, double tolerance);

}  // namespace hull::analysis
