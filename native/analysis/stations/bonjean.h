// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/stations/section_areas.h"

namespace hull::analysis {

// Immersed stations over a range of upright drafts: Bonjean's curves.
struct BonjeanCurves {
  std::vector<double> stations;       // x, m
  std::vector<double> drafts;         // m
  std::vector<SectionArea> sections;  // index station * drafts.size() + draft

  const SectionArea& at(std::size_t station, std::size_t draft) const {
    return sections[station * drafts.size() + draft];
  }
};

// Each station is cut once for all drafts. As section_areas(), with the same values and errors.
BonjeanCurves bonjean(const HullBody& body, std::vector<double> stations,
                      std::vector<double> drafts);

}  // namespace hull::analysis
