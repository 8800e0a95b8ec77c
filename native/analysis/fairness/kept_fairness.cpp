// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/kept_fairness.h"

namespace hull::analysis {

std::vector<std::vector<CurveFairness>> KeptFairness::section_fairness(
    const std::vector<Plane>& planes, const std::vector<std::vector<const SectionCurve*>>& curves,
    const FairnessOptions& options) {
  const std::vector<CourseMemory*> memories = kept_.of(keys_of(planes));
  auto result = analysis::section_fairness(*surface_, planes, curves, options, memories);
  recalled_ = 0;
  for (const CourseMemory* memory : memories) recalled_ += memory->recalled_count();
  return result;
}

}  // namespace hull::analysis
