// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/section_areas.h"

#include <cmath>
#include <stdexcept>

#include "analysis/stations/station_cutter.h"

namespace hull::analysis {

std::vector<SectionArea> section_areas(const HullBody& body, const std::vector<double>& positions,
                                       const Plane& water) {
  body.refuse_flooding(water);
  const StationCutter cutter(body);
  std::vector<SectionArea> areas;
  for (double position : positions) {
    if (!std::isfinite(position)) {
      throw std::invalid_argument("The position of a station must be a finite number.");
    }
    areas.push_back(immersed_station(cutter, position, water));
  }
  return areas;
}

std::vector<SectionArea> section_areas(const HullBody& body, const std::vector<double>& positions,
                                       const FloatingPosition& position) {
  return section_areas(body, positions, water_plane(position));
}

}  // namespace hull::analysis
