// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/sections/kept_entries.h"
#include "analysis/stations/section_areas.h"
#include "analysis/stations/station_cutter.h"

namespace hull::analysis {

// Immersed stations of a body whose surface's points are moved. Of each station that was asked for
// by some rule the integrals over its cells are kept, and only those over cells that have moved
// since are taken again. Stations in whose plane a flat lies are cut anew as a whole, and so are
// all of half a hull that is heeled.
class KeptStations {
 public:
  // `body` must outlive the stations.
  explicit KeptStations(const HullBody& body) : body_(&body) {}

  // The same as analysis::section_areas() of the body as it is, to the last bit.
  std::vector<SectionArea> section_areas(const std::vector<double>& positions, const Plane& water);

  // The same as analysis::immersed_station() by a cutter of the body as it is.
  SectionArea station(const StationCutter& cutter, double position, const Plane& water,
                      const ArcRule& rule);

  const HullBody& body() const { return *body_; }
  // Of how many stations integrals are kept.
  std::size_t station_count() const { return kept_.size(); }

 private:
  using OfCell = std::pair<int, SectionIntegrals>;
  struct KeptCells {
    int revision = -1;          // of the surface that they are of: cells that moved later are not
    std::vector<OfCell> cells;  // in order
  };
  // What all that is kept depends on but the surface's cells.
  struct Conditions {
    Plane water;
    double size;  // of the mesh
    bool operator==(const Conditions&) const;
  };
  using Station = std::pair<double, ArcRule>;
  void require(const Plane& water);
  SectionArea station(const StationCutter& cutter, const Station& asked, KeptCells& kept) const;

  const HullBody* body_;
  std::optional<Conditions> conditions_;
  // More than a curve of sectional areas has: forgotten are those of ends that were moved.
  KeptEntries<Station, KeptCells> kept_{2000};
};

}  // namespace hull::analysis
