// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/station_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

// A point where a border crosses the plane of a section.
struct BorderCrossing {
  int loop;
  Vector3d point;
  bool ends_outline;  // or begins it
};

std::vector<BorderCrossing> border_crossings(const std::vector<BorderEdge>& border,
                                             const Plane& plane, double tolerance) {
  std::vector<BorderCrossing> crossings;
  for (const BorderEdge& edge : border) {
    BezierCubic height = edge.along(plane.normal, plane.offset);
    // Rounding must not make a border that runs in the plane cross it many times.
    for (double& h : height) h = std::abs(h) < tolerance ? 0.0 : h;
    bool below = height[0] < 0.0;
    for (double t : sign_changes(height)) {
      const Vector3d point(evaluate(edge.along(Vector3d::UnitX(), 0.0), t),
                           evaluate(edge.along(Vector3d::UnitY(), 0.0), t),
                           evaluate(edge.along(Vector3d::UnitZ(), 0.0), t));
      // With the shell on the border's left, the outline arrives where the border rises.
      crossings.push_back({edge.loop, point, below});
      below = !below;
    }
  }
  return crossings;
}

ClosingLine line_between(const SectionFrame& frame, const Vector3d& from, const Vector3d& to) {
  return {frame.across.dot(from - frame.origin), frame.up.dot(from - frame.origin),
          frame.across.dot(to - frame.origin), frame.up.dot(to - frame.origin)};
}

ClosingLine line_to_centre_plane(const SectionFrame& frame, const BorderCrossing& crossing) {
  const Vector3d foot(crossing.point.x(), 0.0, crossing.point.z());
  // Closing lines run on in the outline's direction: from its end, or to its beginning.
  return crossing.ends_outline ? line_between(frame, crossing.point, foot)
                               : line_between(frame, foot, crossing.point);
}

// Crossings of one opening, from side to side, are taken in pairs: an opening is bounded by two.
std::vector<ClosingLine> lines_across(const SectionFrame& frame,
                                      std::vector<BorderCrossing> crossings) {
  std::sort(crossings.begin(), crossings.end(), [](const auto& x, const auto& y) {
    return x.loop != y.loop ? x.loop < y.loop : x.point.y() < y.point.y();
  });
  std::vector<ClosingLine> lines;
  for (std::size_t i = 0; i + 1 < crossings.size();) {
    const BorderCrossing &a = crossings[i], &b = crossings[i + 1];
    // No opening lies between two loops, two ends or two beginnings: the second may begin one.
    if (a.loop != b.loop || a.ends_outline == b.ends_outline) {
      ++i;
      continue;
    }
    lines.push_back(a.ends_outline ? line_between(frame, a.point, b.point)
                                   : line_between(frame, b.point, a.point));
    i += 2;
  }
  return lines;
}

void add_other_side(SectionIntegrals other, SectionIntegrals& sum) {
  other.moment_a = -other.moment_a;  // `a` runs to the other side there
  sum += other;
}

}  // namespace

SectionOutline::SectionOutline(const surface::LimitSurface& surface, const CellBoxes& boxes,
                               const SectionFrame& frame, std::vector<ClosingLine> closing,
                               double highest_level, const ArcRule& rule)
    : rule_(rule), closing_(std::move(closing)) {
  const ArcReach search(surface, frame, highest_level);
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    if (!search.may_reach(boxes, cell)) continue;
    for_each_arc_in(search, cell, rule.deepest,
                    [this](const ArcSquare& square) { squares_.push_back(square); });
    cell_ends_.push_back(squares_.size());
  }
}

SectionIntegrals SectionOutline::below(double level) const {
  SectionIntegrals sum;
  std::size_t i = 0;
  // Cell by cell, as those are added that keep what cells gave (kept_stations.h).
  for (const std::size_t end : cell_ends_) {
    SectionIntegrals of_cell;
    for (; i < end; ++i) {
      // The coefficients' convex hull: none of the square reaches the level.
      if (!whole_.empty() && highest(squares_[i].b) < level) {
        of_cell += whole_[i];
      } else {
        add_arcs(squares_[i], level, rule_, of_cell);
      }
    }
    sum += of_cell;
  }
  for (const ClosingLine& line : closing_) {
    add_line(line.a0, line.b0, line.a1, line.b1, level, sum);
  }
  return sum;
}

void SectionOutline::prepare() {
  whole_.assign(squares_.size(), {});
  for (std::size_t i = 0; i < squares_.size(); ++i) {
    add_arcs(squares_[i], std::numeric_limits<double>::infinity(), rule_, whole_[i]);
  }
}

StationCutter::StationCutter(const HullBody& body)
    : body_(&body), rule_(arc_rule(body.surface().mesh().size(), body.tolerance())) {
  const surface::LimitSurface& surface = body.surface();
  const double thickest = 2.0 * kInPlane * surface.mesh().size();
  const auto take = [&](const auto& points) {
    double low = points[0].x(), high = low;
    for (const Vector3d& p : points) {
      low = std::min(low, p.x());
      high = std::max(high, p.x());
      // Most of a ship is left out by the second point or the third.
      if (high - low > thickest) return;
    }
    flats_.push_back({low, high});
  };
  // By control points, in whose hull the parts lie.
  for (int i = 0; i < surface.layout().leaf_count(); ++i) take(surface.leaf(i));
  for (int i = 0; i < surface.layout().corner_count(); ++i) take(surface.corner(i).outer);
  for (const BorderEdge& edge : body.border()) take(edge.points);
}

std::optional<double> StationCutter::distance_of_flats(double position) const {
  const double most = kInPlane * body_->surface().mesh().size();
  std::optional<double> distance;
  for (const Flat& flat : flats_) {
    const double own = std::max(std::abs(flat.low - position), std::abs(flat.high - position));
    if (own <= most) distance = std::max(distance.value_or(0.0), own);
  }
  return distance;
}

SectionOutline StationCutter::outline(const SectionFrame& frame, double highest_level,
                                      const ArcRule& rule) const {
  return {body_->surface(), body_->boxes(), frame, closing_lines(frame), highest_level, rule};
}

std::vector<ClosingLine> StationCutter::closing_lines(const SectionFrame& frame) const {
  const double tolerance = kZeroHeight * body_->surface().mesh().size();
  std::vector<BorderCrossing> crossings = border_crossings(body_->border(), frame.plane, tolerance);
  if (!body_->mirrored()) return lines_across(frame, std::move(crossings));
  std::vector<ClosingLine> lines;
  for (const BorderCrossing& crossing : crossings) {
    lines.push_back(line_to_centre_plane(frame, crossing));
  }
  return lines;
}

StationViews::StationViews(const StationCutter& cutter, double position, const Plane& water,
                           double highest_level, const ArcRule& rule)
    : position_(position), doubled_(cutter.body().mirrored() && water.normal.y() == 0.0) {
  const auto add_view = [&](const Plane& plane) {
    const SectionFrame frame = SectionFrame::above_water(plane, water);
    View view{frame, {cutter.outline(frame, highest_level, rule)}};
    if (cutter.body().mirrored() && !doubled_) {
      view.sides.push_back(cutter.outline(frame.mirrored(), highest_level, rule));
    }
    views_.push_back(std::move(view));
  };
  const std::optional<double> flats = cutter.distance_of_flats(position);
  const bool noisy = flats && *flats > kZeroHeight * cutter.body().surface().mesh().size();
  // A flat that lies in the plane but for noise is cut to ribbons: beside it both sides are whole.
  const double aside = noisy ? 2.0 * *flats : 0.0;
  add_view({Vector3d::UnitX(), position - aside});
  // A section at zero height belongs to the side above: seen from the other side it is the other.
  if (flats) add_view({-Vector3d::UnitX(), -position - aside});
}

void StationViews::prepare() {
  for (View& view : views_) {
    for (SectionOutline& side : view.sides) side.prepare();
  }
}

SectionArea StationViews::below(double level) const {
  SectionArea largest = below(views_.front(), level);
  for (std::size_t i = 1; i < views_.size(); ++i) {
    const SectionArea other = below(views_[i], level);
    if (other.area > largest.area) largest = other;
  }
  return largest;
}

SectionArea StationViews::below(const View& view, double level) const {
  SectionIntegrals sum = view.sides.front().below(level);
  if (view.sides.size() > 1) add_other_side(view.sides.back().below(level), sum);
  return station_of(position_, view.frame, sum, doubled_);
}

SectionArea station_of(double position, const SectionFrame& frame, SectionIntegrals sum,
                       bool doubled) {
  if (doubled) add_other_side(sum, sum);
  SectionArea result;
  result.position = position;
  result.area = sum.area;
  if (sum.area > 0.0) {
    result.centroid = frame.point(sum.moment_a / sum.area, sum.moment_b / sum.area);
  }
  result.girth = sum.girth;
  result.breadth = sum.breadth;
  result.area_error = sum.error;
  return result;
}

SectionArea immersed_station(const StationCutter& cutter, double position, const Plane& water) {
  return immersed_station(cutter, position, water, cutter.rule());
}

SectionArea immersed_station(const StationCutter& cutter, double position, const Plane& water,
                             const ArcRule& rule) {
  return StationViews(cutter, position, water, 0.0, rule).below(0.0);
}

}  // namespace hull::analysis
