// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawing/lines_plan/lines_views.h"
#include "drawing/lines_plan/ship_curve.h"
#include "drawing/lines_plan/view_parts.h"
#include "mesh/tolerances.h"

namespace hull::drawing {

using Eigen::Vector2d;

namespace {

// Which half of the body plan: -1 the left, with the after sections, +1 the right.
using Hand = int;
constexpr Hand kAft = -1;
constexpr Hand kFore = +1;

constexpr double kTraceOverhang = 3.0;  // mm: of diagonals beyond the hull
// mm: labels at the ends of sections keep clear of the deck line, which is half as broad.
constexpr double kEndClearance = 0.5;
constexpr double kSameEnd = 1.2;  // mm: sections that end nearer than this share one label

// The upper end of a section on the page and what is written there.
struct SectionEnd {
  Vector2d point;
  std::vector<std::string> labels;

  std::string text() const {
    if (labels.size() == 1) return labels.front();
    return labels.front() + (labels.size() == 2 ? ", " : "–") + labels.back();
  }
};

struct Section {
  std::string label;
  std::vector<PlacedCurve> curves;
};

Projection end_view(const View& view, Hand hand) {
  // The port half twice: from abaft it is on the left, with the after sections, from ahead on the
  // right.
  return projection(view, {0.0, static_cast<double>(hand), 0.0}, {0.0, 0.0, 1.0});
}

GridBox body_plan_grid(const View& view, const HullExtents& extents) {
  GridBox grid(view.to_page(-extents.breadth, extents.top),
               view.to_page(extents.breadth, extents.bottom));
  grid.min() -= Vector2d(kSideOverhang, kOverhang);
  grid.max() += Vector2d(kSideOverhang, kOverhang);
  return grid;
}

void draw_offsets(SheetBuilder& builder, const View& view, const GridBox& grid,
                  const LinesDrawing& drawing, const HullExtents& extents) {
  std::vector<Tick> ticks;
  for (const NamedCurves& buttock : drawing.buttocks) {
    if (buttock.position <= 0.0 || buttock.position > extents.breadth) continue;
    for (const Hand hand : {kAft, kFore}) {
      const double x = view.to_page(hand * buttock.position, 0.0).x();
      draw_vertical(builder, pens::kGrid, grid, x);
      ticks.push_back({x, buttock.label, inks::kButtock, false});
    }
  }
  const double centre = view.to_page(0.0, 0.0).x();
  draw_vertical(builder, pens::kCentreLine, grid, centre);
  ticks.push_back({centre, "CL", inks::kBlack, true});
  label_verticals(builder, view, std::move(ticks), grid.max().y() + 0.5 * kLabelRow);
}

// The parts aft of midship to the left, the others to the right, without what lies in the centre
// plane.
void draw_split(SheetBuilder& builder, const View& view, const Pen& pen,
                const std::vector<ShipCurve>& curves, const HullExtents& extents) {
  // Cut at midship, as a knuckle runs on from the after body into the fore one.
  for (const ShipCurve& curve : curves) {
    // What is left lies off the centre plane by more than a line on paper would show.
    for (const ShipCurve& part : parts_off_centre(curve, kOffCentre / view.scale)) {
      for (const ShipCurve& aft : part_of_curve(part, 0, extents.midship, LimitSide::kBelow)) {
        draw_ship_curve(builder, pen, end_view(view, kAft), aft);
      }
      for (const ShipCurve& fore : part_of_curve(part, 0, extents.midship, LimitSide::kAbove)) {
        draw_ship_curve(builder, pen, end_view(view, kFore), fore);
      }
    }
  }
}

// The point of the section to label: its upper outer end, the deck edge where there is a deck.
Vector2d upper_end(const Section& section, Hand hand) {
  Vector2d best = section.curves.front().path.front();
  // Height on the page, whose y runs down, and a part of the distance outwards, so that of a
  // section with a deck the edge wins over the crown.
  const auto height = [hand](const Vector2d& point) { return -point.y() + 0.7 * hand * point.x(); };
  for (const PlacedCurve& curve : section.curves) {
    for (const Vector2d& point : curve.path) {
      if (height(point) > height(best)) best = point;
    }
  }
  return best;
}

std::vector<Section> draw_sections(SheetBuilder& builder, const View& view,
                                   const LinesDrawing& drawing, const HullExtents& extents,
                                   Hand hand) {
  const double same = kSamePosition * (extents.fore - extents.aft);
  std::vector<Section> sections;
  for (const NamedCurves& station : drawing.stations) {
    // A midship station is on both hands.
    if (hand * (station.position - extents.midship) < -same || station.curves.empty()) continue;
    const bool midship = std::abs(station.position - extents.midship) <= same;
    const Pen& pen = midship ? pens::kMidshipSection : kStationLines.pen;
    Section& section = sections.emplace_back(Section{station.label, {}});
    for (const ShipCurve& curve : station.curves) {
      section.curves.push_back(draw_ship_curve(builder, pen, end_view(view, hand), curve));
    }
  }
  return sections;
}

// Tries places around the section's end, near ones and those up and outwards first; farther ones
// are joined to it by a leader.
void label_end(SheetBuilder& builder, const View& view, const SectionEnd& end, Hand hand) {
  const std::string text = end.text();
  const TextStyle style{.size = 2.4, .ink = kStationLines.ink, .knockout = true};
  const Vector2d half = SheetBuilder::text_box(text, style, {0.0, 0.0}).half;
  for (const double distance : {0.7, 1.5, 2.5, 4.0, 5.5, 7.0, 9.0, 11.0}) {
    for (const double angle_deg : {75.0, 90.0, 55.0, 110.0, 35.0, 15.0, 0.0, 130.0, -20.0}) {
      const double angle = angle_deg * std::numbers::pi / 180.0;
      const Vector2d direction(hand * std::cos(angle), -std::sin(angle));
      // From the end to the nearest side of the box in this direction is `distance`.
      const double inside = std::min(half.x() / std::max(std::abs(direction.x()), 1e-9),
                                     half.y() / std::max(std::abs(direction.y()), 1e-9));
      const OrientedBox box =
          SheetBuilder::text_box(text, style, end.point + (distance + inside) * direction);
      const Vector2d leader_end = end.point + distance * direction;
      if (!builder.has_room(box, kEndClearance, view.bounds) ||
          !builder.placer().is_free(end.point, leader_end)) {
        continue;
      }
      if (distance > 2.0) builder.draw(pens::kLeader, {end.point, leader_end});
      builder.put_text(text, style, box);
      return;
    }
  }
}

void label_sections(SheetBuilder& builder, const View& view, const std::vector<Section>& sections,
                    const HullExtents& extents, Hand hand) {
  std::vector<SectionEnd> ends;
  for (const Section& section : sections) {
    const Vector2d point = upper_end(section, hand);
    // Stations come in order, so those that end together, as along a parallel middle body, follow
    // one another.
    if (!ends.empty() && (ends.back().point - point).norm() < kSameEnd) {
      ends.back().labels.push_back(section.label);
    } else {
      ends.push_back({point, {section.label}});
    }
  }
  // From the centre line outwards: there is more room outside for those that come last.
  // A copy: `ends` has to keep the order of the sections, which are counted along with it below.
  std::vector<SectionEnd> outwards = ends;
  std::stable_sort(outwards.begin(), outwards.end(),
                   [hand](const SectionEnd& a, const SectionEnd& b) {
                     return hand * a.point.x() < hand * b.point.x();
                   });
  for (const SectionEnd& end : outwards) label_end(builder, view, end, hand);

  // Sections that end together are told apart where they part, in the bilge or the bottom.
  std::vector<double> wanted;
  // As parts of the breadth.
  for (const double share : {0.6, 0.3, 0.9}) {
    wanted.push_back(view.to_page(hand * share * extents.breadth, 0.0).x());
  }
  std::size_t next = 0;
  for (const SectionEnd& end : ends) {
    for (const std::string& label : end.labels) {
      const Section& section = sections[next++];
      if (end.labels.size() == 1) continue;
      label_on_curve(builder, view, section.curves, label, kStationLines.ink, wanted);
    }
  }
}

// The straight traces of the diagonals, from the centre line to beyond the hull.
void draw_diagonals(SheetBuilder& builder, const View& view, const LinesDrawing& drawing) {
  for (const NamedDiagonal& member : drawing.diagonals) {
    double reach = 0.0;
    for (const ShipCurve& curve : member.curves) {
      for (const Eigen::Vector3d& point : curve.points) reach = std::max(reach, point.y());
    }
    // A diagonal that meets the hull in the centre plane alone has no trace.
    if (reach <= 0.0) continue;
    const double angle = member.diagonal.angle;
    const TextStyle style{.size = 2.4, .ink = kDiagonalLines.ink, .knockout = true};
    const Vector2d start = view.to_page(0.0, member.diagonal.height);
    for (const Hand hand : {kAft, kFore}) {
      const Vector2d along(hand * std::cos(angle), std::sin(angle));
      // Along the trace the distance is the breadth over the cosine of the angle.
      const Vector2d end = start + (view.scale * reach / std::cos(angle) + kTraceOverhang) * along;
      builder.draw(pens::kDiagonalTrace, {start, end});
      const Vector2d half = SheetBuilder::text_box(member.label, style, {0.0, 0.0}).half;
      // Beyond the trace's end first, then back upon the trace, which the label interrupts.
      for (const double distance : {0.4, 1.5, 3.0, -4.0, -6.0}) {
        const OrientedBox box =
            SheetBuilder::text_box(member.label, style, end + (half.x() + distance) * along);
        if (!builder.has_room(box, 0.2, view.bounds)) continue;
        builder.put_text(member.label, style, box);
        break;
      }
    }
  }
}

}  // namespace

void draw_body_plan(SheetBuilder& builder, const View& view, const LinesDrawing& drawing,
                    const HullExtents& extents) {
  const GridBox grid = body_plan_grid(view, extents);
  draw_caption(builder, view, "Body plan");
  draw_offsets(builder, view, grid, drawing, extents);
  draw_heights(builder, view, grid, drawing, extents.bottom, extents.top);

  // All curves are drawn before the first section is named, so that its label finds them as
  // obstacles.
  const std::vector<Section> aft = draw_sections(builder, view, drawing, extents, kAft);
  const std::vector<Section> fore = draw_sections(builder, view, drawing, extents, kFore);
  draw_split(builder, view, pens::kKnuckle, drawing.knuckles, extents);
  draw_split(builder, view, pens::kOutline, drawing.outlines, extents);
  draw_diagonals(builder, view, drawing);
  label_sections(builder, view, aft, extents, kAft);
  label_sections(builder, view, fore, extents, kFore);
}

}  // namespace hull::drawing
