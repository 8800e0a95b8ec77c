// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/immersion/hull_body.h"
#include "analysis/sections/border_edges.h"
#include "analysis/stations/section_areas.h"
#include "analysis/stations/section_integrals.h"

namespace hull::analysis {

// A straight line that closes a section between borders, in a frame's coordinates.
struct ClosingLine {
  double a0, b0, a1, b1;
};

// The outline of one side's section by a plane, cut once and then immersed to any level.
class SectionOutline {
 public:
  // For levels up to `highest_level`.
  SectionOutline(const surface::LimitSurface& surface, const CellBoxes& boxes,
                 const SectionFrame& frame, std::vector<ClosingLine> closing, double highest_level,
                 const ArcRule& rule);

  SectionIntegrals below(double level) const;
  // Makes it cheaper to immerse to many levels: squares that are wholly immersed are integrated
  // now.
  void prepare();

 private:
  ArcRule rule_;
  std::vector<ArcSquare> squares_;
  std::vector<std::size_t> cell_ends_;   // the squares of one cell end before these
  std::vector<SectionIntegrals> whole_;  // of each square, once prepared
  std::vector<ClosingLine> closing_;
};

// Cuts stations out of a body as it is when the cutter is made. `body` must outlive it.
class StationCutter {
 public:
  explicit StationCutter(const HullBody& body);

  // Where a flat of the shell, or a border, lies in the plane x = position, areas may jump: how
  // far, in m, the control points of such flats are from it, as in single precision; less than
  // kInPlane of the size.
  std::optional<double> distance_of_flats(double position) const;

  // The port side's outline, or that of the whole where the body is modelled whole. `frame` is that
  // of a plane across x, seen from either side.
  SectionOutline outline(const SectionFrame& frame, double highest_level,
                         const ArcRule& rule) const;

  // What closes it.
  std::vector<ClosingLine> closing_lines(const SectionFrame& frame) const;

  const HullBody& body() const { return *body_; }
  // That of the body's tolerance.
  const ArcRule& rule() const { return rule_; }

 private:
  // From the least to the greatest x of control points of a part of the shell, or border.
  struct Flat {
    double low, high;
  };

  const HullBody* body_;
  ArcRule rule_;
  std::vector<Flat> flats_;  // that are across x, but for less than twice kInPlane of the size
};

// A station of both sides, cut once and then immersed to any level above (or below) a water's
// surface, straight up within the station.
class StationViews {
 public:
  StationViews(const StationCutter& cutter, double position, const Plane& water,
               double highest_level, const ArcRule& rule);

  SectionArea below(double level) const;
  void prepare();

 private:
  // What lies in the plane of the station counts as ahead of it, seen from abaft, and the other way
  // round: one view has what is abaft of a jump, the other what is ahead. Where it lies in the
  // plane but for noise, the views are cut on either side of the noise.
  struct View {
    SectionFrame frame;
    std::vector<SectionOutline> sides;  // the second in mirrored coordinates
  };
  SectionArea below(const View& view, double level) const;

  double position_;
  bool doubled_;  // the other side's integrals are those of the first
  std::vector<View> views_;
};

// From the integrals over one side; doubled: the other side's are the same.
SectionArea station_of(double position, const SectionFrame& frame, SectionIntegrals sum,
                       bool doubled);

// Both sides of the station in the given water, by the cutter's rule or another.
SectionArea immersed_station(const StationCutter& cutter, double position, const Plane& water);
SectionArea immersed_station(const StationCutter& cutter, double position, const Plane& water,
                             const ArcRule& rule);

}  // namespace hull::analysis
