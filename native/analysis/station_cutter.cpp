// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/station_cutter.h"

#include <algorithm>
#include <cmath>

namespace hull {
namespace {

using section_internal::kZeroHeight;

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

template <class Points>
bool all_at(const Points& points, double position, double tolerance) {
  return std::all_of(points.begin(), points.end(), [&](const Vector3d& p) {
    return std::abs(p.x() - position) < tolerance;
  });
}

// The station's plane, seen from ahead or from abaft: its zero heights count as behind the plane's
// normal, so that one sees what is abaft of a jump and the other what is ahead.
SectionFrame station_frame(double position, bool from_ahead, const Plane& water) {
  const Plane plane = from_ahead ? Plane{Vector3d::UnitX(), position}
                                 : Plane{-Vector3d::UnitX(), -position};
  return SectionFrame::above_water(plane, water);
}

SectionArea one_view(const StationCutter& cutter, double position, bool from_ahead,
                     const Plane& water) {
  const SectionFrame frame = station_frame(position, from_ahead, water);
  SectionIntegrals sum = cutter.outline(frame, 0.0).below(0.0);
  if (cutter.body().mirrored()) {
    const bool upright = frame.up.y() == 0.0;
    SectionIntegrals other =
        upright ? sum : cutter.outline(frame.mirrored(), 0.0).below(0.0);
    other.moment_a = -other.moment_a;
    sum += other;
  }
  return to_section_area(position, frame, sum);
}

}  // namespace

SectionOutline::SectionOutline(const LimitSurface& surface, const CellBoxes& boxes,
                               const SectionFrame& frame, std::vector<ClosingLine> closing,
                               double highest_level)
    : size_(surface.mesh().size()), closing_(std::move(closing)) {
  for_each_arc(surface, boxes, frame, highest_level,
               [this](const ArcSquare& square) { squares_.push_back(square); });
}

SectionIntegrals SectionOutline::below(double level) const {
  SectionIntegrals sum;
  for (const ArcSquare& square : squares_) add_arcs(square, level, size_, sum);
  for (const ClosingLine& line : closing_) {
    add_line(line.a0, line.b0, line.a1, line.b1, level, sum);
  }
  return sum;
}

StationCutter::StationCutter(const HullBody& body)
    : body_(&body), boxes_(body.surface()), border_(border_edges(body.surface())) {}

bool StationCutter::has_flat(double position) const {
  const LimitSurface& surface = body_->surface();
  const double tolerance = kZeroHeight * surface.mesh().size();
  for (int i = 0; i < surface.layout().leaf_count(); ++i) {
    if (all_at(surface.leaf(i), position, tolerance)) return true;
  }
  for (int i = 0; i < surface.layout().corner_count(); ++i) {
    if (all_at(surface.corner(i).squares.front(), position, tolerance)) return true;
  }
  return std::any_of(border_.begin(), border_.end(), [&](const BorderEdge& edge) {
    return all_at(edge.points, position, tolerance);
  });
}

SectionOutline StationCutter::outline(const SectionFrame& frame, double highest_level) const {
  return {body_->surface(), boxes_, frame, closing_lines(frame), highest_level};
}

std::vector<ClosingLine> StationCutter::closing_lines(const SectionFrame& frame) const {
  const double tolerance = kZeroHeight * body_->surface().mesh().size();
  std::vector<BorderCrossing> crossings = border_crossings(border_, frame.plane, tolerance);
  if (!body_->mirrored()) return lines_across(frame, std::move(crossings));
  std::vector<ClosingLine> lines;
  for (const BorderCrossing& crossing : crossings) {
    lines.push_back(line_to_centre_plane(frame, crossing));
  }
  return lines;
}

SectionArea to_section_area(double position, const SectionFrame& frame,
                            const SectionIntegrals& both) {
  SectionArea result;
  result.position = position;
  result.area = both.area;
  if (both.area > 0.0) {
    result.centroid = frame.point(both.moment_a / both.area, both.moment_b / both.area);
  }
  result.girth = both.girth;
  result.breadth = both.breadth;
  result.area_error = both.error;
  return result;
}

SectionArea immersed_station(const StationCutter& cutter, double position, const Plane& water) {
  const SectionArea from_ahead = one_view(cutter, position, true, water);
  if (!cutter.has_flat(position)) return from_ahead;
  const SectionArea from_abaft = one_view(cutter, position, false, water);
  return from_abaft.area > from_ahead.area ? from_abaft : from_ahead;
}

}  // namespace hull
