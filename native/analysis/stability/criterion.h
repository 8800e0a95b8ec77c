// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/stability/stability_edges.h"

namespace hull::analysis {

enum class CriterionOutcome { kPass, kFail, kNotComputed };

// A requirement on a value: not to be below a limit, or not to be above it.
struct Criterion {
  enum class Bound { kAtLeast, kAtMost };

  std::string paragraph;  // of the code
  std::string name;
  std::optional<double> value;
  double limit = 0.0;
  std::string unit;  // of both
  Bound bound = Bound::kAtLeast;
  CriterionOutcome outcome = CriterionOutcome::kNotComputed;
  std::string note;  // a sentence where something is to be said, or empty
};

// With the outcome that its value means. What has none keeps the one it has; what has failed
// already, though part of its value was computed, stays failed.
Criterion judged(Criterion criterion);
bool all_pass(const std::vector<Criterion>& criteria);

// The curve of righting levers as the criteria of the 2008 IS Code look at it: from upright to 90°.
struct CriteriaCurve {
  // rad, every 5° as far as the ship does not stand on end: between these features are looked for.
  std::vector<double> heels;
  std::string why_it_ends;  // a sentence unless `heels` reach 90°
  std::optional<double> downflooding_heel;
  bool can_flood = false;

  // The last heel at which the levers count.
  double end() const { return downflooding_heel.value_or(heels.back()); }
};
CriteriaCurve criteria_curve(HeelingPath& path, const HullBody& body, const StabilityEdges& edges);

inline constexpr double kCriteriaAreaTolerance = 1e-8;  // m·rad

// "27.5°"
std::string in_degrees(double angle);

}  // namespace hull::analysis
