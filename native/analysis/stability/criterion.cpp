// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/criterion.h"

#include <algorithm>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "analysis/arithmetic/degree.h"

namespace hull::analysis {
namespace {

constexpr double kLastHeel = 90.0 * kDegree;
constexpr double kStep = 5.0 * kDegree;

}  // namespace

Criterion judged(Criterion c) {
  if (!c.value) return c;
  const bool within =
      c.bound == Criterion::Bound::kAtLeast ? *c.value >= c.limit : *c.value <= c.limit;
  // A value that was computed of part of the curve does not undo a failure told already.
  const bool met = within && c.outcome != CriterionOutcome::kFail;
  c.outcome = met ? CriterionOutcome::kPass : CriterionOutcome::kFail;
  return c;
}

bool all_pass(const std::vector<Criterion>& criteria) {
  return std::all_of(criteria.begin(), criteria.end(),
                     [](const Criterion& c) { return c.outcome == CriterionOutcome::kPass; });
}

CriteriaCurve criteria_curve(HeelingPath& path, const HullBody& body, const StabilityEdges& edges) {
  CriteriaCurve curve;
  // Upright there has to be a lever: that throws, where a larger heel only ends the curve.
  path.at(0.0);
  curve.heels.push_back(0.0);
  // Counted, not added up: 18 steps of rounded size would miss 90°.
  for (int i = 1; i * kStep <= kLastHeel * (1.0 + 1e-12); ++i) {
    if (!path.find(i * kStep)) {
      curve.why_it_ends = "There is no righting lever at " + in_degrees(i * kStep) +
                          ": the ship stands on end, or does not settle.";
      break;
    }
    curve.heels.push_back(i * kStep);
  }
  curve.can_flood = can_flood(body, edges);
  if (curve.heels.size() > 1) {
    curve.downflooding_heel = downflooding_heel(path, body, edges, curve.heels);
  }
  return curve;
}

std::string in_degrees(double angle) {
  std::ostringstream words;
  words << std::fixed << std::setprecision(1) << angle / kDegree << "°";
  return words.str();
}

}  // namespace hull::analysis
