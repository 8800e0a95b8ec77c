// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/kept_stations.h"

#include "analysis/sections/kept_cells.h"
#include "surface/parallel_for.h"

namespace hull::analysis {

bool KeptStations::Conditions::operator==(const Conditions& other) const {
  return water.normal == other.water.normal && water.offset == other.water.offset &&
         size == other.size;
}

void KeptStations::require(const Plane& water) {
  const Conditions now{water, body_->surface().mesh().size()};
  if (!conditions_ || !(*conditions_ == now)) kept_.clear();
  conditions_ = now;
}

std::vector<SectionArea> KeptStations::section_areas(const std::vector<double>& positions,
                                                     const Plane& water) {
  check_stations(*body_, positions, water);
  require(water);
  const StationCutter cutter(*body_);
  std::vector<Station> asked;
  for (const double position : positions) asked.emplace_back(position, cutter.rule());
  const std::vector<KeptCells*> kept = kept_.of(asked);
  std::vector<SectionArea> areas(positions.size());
  surface::parallel_for(
      positions.size(), surface::kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          areas[i] = station(cutter, asked[i], *kept[i]);
        }
      },
      kStationGrain);
  return areas;
}

SectionArea KeptStations::station(const StationCutter& cutter, double position, const Plane& water,
                                  const ArcRule& rule) {
  require(water);
  const Station asked{position, rule};
  return station(cutter, asked, *kept_.of({asked}).front());
}

SectionArea KeptStations::station(const StationCutter& cutter, const Station& asked,
                                  KeptCells& kept) const {
  const double position = asked.first;
  const ArcRule& rule = asked.second;
  const Plane& water = conditions_->water;
  const bool upright = water.normal.y() == 0.0;
  if ((body_->mirrored() && !upright) || cutter.distance_of_flats(position)) {
    kept = {};
    return immersed_station(cutter, position, water, rule);
  }
  const surface::LimitSurface& surface = body_->surface();
  const SectionFrame frame = SectionFrame::above_water({Vector3d::UnitX(), position}, water);
  const ArcReach search(surface, frame, 0.0);
  KeptCells now{surface.revision(), {}};
  const auto take = [&](int cell, const OfCell* known, bool has_moved) {
    if (!has_moved) {
      now.cells.push_back(*known);
    } else if (search.may_reach(body_->boxes(), cell)) {
      SectionIntegrals& of_cell = now.cells.emplace_back(cell, SectionIntegrals{}).second;
      for_each_arc_in(search, cell, rule.deepest,
                      [&](const ArcSquare& square) { add_arcs(square, 0.0, rule, of_cell); });
    }
  };
  for_each_moved_or_kept(
      surface.cells_moved_since(kept.revision), kept.cells,
      [](const OfCell& known) { return known.first; }, take);
  SectionIntegrals sum;
  for (const auto& [cell, of_cell] : now.cells) sum += of_cell;
  for (const ClosingLine& line : cutter.closing_lines(frame)) {
    add_line(line.a0, line.b0, line.a1, line.b1, 0.0, sum);
  }
  kept = std::move(now);
  return station_of(position, frame, sum, body_->mirrored());
}

}  // namespace hull::analysis
