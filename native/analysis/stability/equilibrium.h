// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/immersion/floating_position.h"
#include "analysis/immersion/hull_body.h"
#include "analysis/stability/load_case.h"

namespace hull::analysis {

enum class EquilibriumStatus {
  kStable,        // comes back when trimmed or heeled a little
  kNeutral,       // some rotation costs nothing to first order (below 1e-9 of the size as GM)
  kUnstable,      // turns over when disturbed
  kFloods,        // in equilibrium if all were closed, but water comes over an opening there
  kSinks,         // weighs as much as the whole body displaces, or more
  kNotConverged,  // the message says why
};

struct EquilibriumOptions {
  // What is not free is held at the start's value.
  bool free_trim = true, free_heel = true;
  // Trim and heel of the start; its draft is found from the displacement. The result's draft is
  // measured at its draft_at.
  FloatingPosition start;
  // Where the equilibrium is unstable, the ship is pushed off it (to starboard, by the stern) and
  // followed down to a stable one: the angle of loll.
  bool leave_unstable = true;
};

struct UnstableEquilibrium {
  FloatingPosition position;
  double gm_transverse = 0.0, gm_longitudinal = 0.0;  // m
};

struct Equilibrium {
  EquilibriumStatus status = EquilibriumStatus::kNotConverged;
  std::string message;  // a sentence for the designer
  FloatingPosition position;
  Immersion immersion;  // in that water; of the last position tried where not converged
  // Metacentric heights for turns about the horizontal axes forward and across, m: second moment of
  // the waterplane over displaced volume, less the height of G over B.
  double gm_transverse = 0.0, gm_longitudinal = 0.0;
  // The unstable one that was left on the way to this one (`leave_unstable`).
  std::optional<UnstableEquilibrium> left;
  double whole_volume = 0.0;     // m³: what the body displaces when wholly under water
  double volume_residual = 0.0;  // relative
  double lever_residual = 0.0;   // m, between weight and buoyancy in the rotations that are free
  int iterations = 0;            // Newton steps tried
  int evaluations = 0;           // immersions computed

  // The draft at x, m, on the ship's own vertical: at a perpendicular, at marks.
  double draft(double x) const { return draft_in(immersion.water, x); }
};

// The equilibrium of a body under a load, by descent of the potential energy from the start: the
// minimum at the foot of the slope on which the start lies. Newton's method with exact derivatives
// (floating_descent.h) on the body with all openings closed; converged to 1e-11 of the displaced
// volume, and of the mesh's size as the lever between weight and buoyancy. Stability is judged in
// the rotations that are free.
//
// Throws std::invalid_argument for a load without positive mass, and for a start that is not
// finite or trimmed by 90° or more.
Equilibrium equilibrium(const HullBody& body, const LoadCase& load,
                        const EquilibriumOptions& options = {});

// One for each load.
std::vector<Equilibrium> equilibria(const HullBody& body, const std::vector<LoadCase>& loads,
                                    const EquilibriumOptions& options = {});

}  // namespace hull::analysis
