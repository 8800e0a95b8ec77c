// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/section_areas.h"

#include <cmath>
#include <stdexcept>

#include "analysis/stations/station_cutter.h"
#include "surface/parallel_for.h"

namespace hull::analysis {

void check_stations(const HullBody& body, const std::vector<double>& positions,
                    const Plane& water) {
  body.refuse_flooding(water);
  for (double position : positions) {
    if (!std::isfinite(position)) {
      throw std::invalid_argument("The position of a station must be a finite number.");
    }
  }
}

std::vector<SectionArea> section_areas(const HullBody& body, const std::vector<double>& positions,
                                       const Plane& water) {
  check_stations(body, positions, water);
  const StationCutter cutter(body);
  std::vector<SectionArea> areas(positions.size());
  surface::parallel_for(
      positions.size(), surface::kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          areas[i] = immersed_station(cutter, positions[i], water);
        }
      },
      kStationGrain);
  return areas;
}

std::vector<SectionArea> section_areas(const HullBody& body, const std::vector<double>& positions,
                                       const FloatingPosition& position) {
  return section_areas(body, positions, water_plane(position));
}

}  // namespace hull::analysis
