// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/fairness/course_memory.h"
#include "analysis/fairness/curve_fairness.h"
#include "analysis/sections/kept_entries.h"
#include "analysis/sections/plane_keys.h"

namespace hull::analysis {

// The fairness of sections of a surface whose points are moved. Of each plane that was asked for is
// kept what was found between the points of its sections, and only in cells that have moved since
// it is found anew.
class KeptFairness {
 public:
  // `surface` must outlive it.
  explicit KeptFairness(const surface::LimitSurface& surface) : surface_(&surface) {}

  // The same as analysis::section_fairness() of sections that are there, to the last bit.
  std::vector<std::vector<CurveFairness>> section_fairness(
      const std::vector<Plane>& planes, const std::vector<std::vector<const SectionCurve*>>& curves,
      const FairnessOptions& options);

  // Of how many planes something is kept.
  std::size_t plane_count() const { return kept_.size(); }
  // From how many points to the next nothing was found anew the last time.
  int recalled_count() const { return recalled_; }

 private:
  const surface::LimitSurface* surface_;
  // More planes than a ship's lines have: forgotten are those of lines that were moved.
  KeptEntries<PlaneKey, CourseMemory> kept_{1000};
  int recalled_ = 0;
};

}  // namespace hull::analysis
