// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/collect_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "analysis/offsets/line_planes.h"
#include "analysis/offsets/offset_table.h"
#include "analysis/sections/port_side.h"
#include "analysis/sections/section_splines.h"
#include "analysis/sections/sections.h"
#include "drawing/lines_plan/hull_extents.h"
#include "drawing/lines_plan/plan_lengths.h"
#include "drawing/lines_plan/ship_curve.h"
#include "drawing/lines_plan/ship_spline.h"
#include "mesh/tolerances.h"
#include "surface/creases/crease_curves.h"

namespace hull::drawing {

namespace {

// On paper, mm: a tenth of a thin line.
constexpr double kPaperTolerance = 0.02;
constexpr int kStepsPerEdge = 16;  // of knuckles and borders
constexpr int kStepsPerKnot = 8;   // of splines
constexpr int kMostFrames = 100000;

std::vector<double> in_order(std::vector<double> positions, const std::string& kind, double same) {
  if (positions.size() > analysis::kMostOffsetPositions) {
    std::string message = std::to_string(positions.size()) + " " + kind;
    throw std::invalid_argument(message +
                                "s are more than a lines plan can show: space them wider");
  }
  for (const double position : positions) {
    if (!std::isfinite(position)) {
      throw std::invalid_argument("A " + kind + "'s position is not a finite number");
    }
  }
  std::sort(positions.begin(), positions.end());
  // `b` comes after `a` in order.
  const auto is_same = [same](double a, double b) { return b - a <= same; };
  positions.erase(std::unique(positions.begin(), positions.end(), is_same), positions.end());
  return positions;
}

std::string metres(double value) { return length_text(value, 3, LengthUnit::kMetre); }

// How far x is from a whole number of spacings, in spacings.
double off_grid(double x, double spacing) {
  return std::abs(x / spacing - std::round(x / spacing));
}

// The spacing by which sorted stations are numbered; 0 if they are to be counted.
double numbering_of(const std::vector<double>& stations, const std::optional<double>& given) {
  if (given) return *given;
  if (stations.size() < 2) return 0.0;
  double smallest = stations[1] - stations[0];
  for (std::size_t i = 2; i < stations.size(); ++i) {
    smallest = std::min(smallest, stations[i] - stations[i - 1]);
  }
  // Within a thousandth of a spacing of a whole number.
  const auto fits = [smallest](double x) { return off_grid(x, smallest) < 1e-3; };
  return std::all_of(stations.begin(), stations.end(), fits) ? smallest : 0.0;
}

std::string station_number(double x, double spacing) {
  if (off_grid(x, spacing) < 1e-3) return std::to_string(std::lround(x / spacing));
  char text[64];
  std::snprintf(text, sizeof text, "%.4g", x / spacing);
  return text;
}

void number_stations(std::vector<NamedCurves>& stations, double spacing) {
  for (std::size_t i = 0; i < stations.size(); ++i) {
    stations[i].label =
        spacing > 0.0 ? station_number(stations[i].position, spacing) : std::to_string(i);
  }
}

void check_spacing(const std::optional<double>& value, const std::string& name) {
  if (value && (!(*value > 0.0) || !std::isfinite(*value))) {
    throw std::invalid_argument("The " + name + " must be above zero, not " + metres(*value));
  }
}

// So many that marks and numbers of all fill no memory; a ship has some hundreds.
void check_frame_count(const std::optional<double>& spacing, double size) {
  if (!spacing || *spacing * kMostFrames >= size) return;
  throw std::invalid_argument("The frame spacing, " + metres(*spacing) + ", makes more than " +
                              std::to_string(kMostFrames) +
                              " frames: give a larger one, in metres");
}

// The parts of the curve to port of y = 0. Points less than `slack` to starboard are taken for
// points of the centre plane.
void add_port_half(std::vector<ShipCurve>& curves, ShipCurve curve, double slack) {
  // Of a spline the control points: the curve moves by no more than they do.
  const auto to_centre_plane = [slack](Vector3d& point) {
    if (point.y() < 0.0 && point.y() >= -slack) point.y() = 0.0;
  };
  for (Vector3d& point : curve.points) to_centre_plane(point);
  if (curve.spline) {
    std::vector<Vector3d> points = curve.spline->points();
    for (Vector3d& point : points) to_centre_plane(point);
    curve.spline = surface::CubicSpline(std::move(points), curve.spline->knots());
  }
  for (ShipCurve& part : part_of_curve(curve, 1, 0.0, LimitSide::kAbove)) {
    curves.push_back(std::move(part));
  }
}

// Points of a spline, closer than its knots.
ShipCurve with_points(const surface::CubicSpline& spline) {
  ShipCurve curve{{}, spline};
  const std::vector<double>& knots = spline.knots();
  curve.points.push_back(spline.evaluate(spline.begin(), 0).point);
  for (std::size_t i = 4; i + 3 < knots.size(); ++i) {
    // A convex combination of the knots, which ends exactly in the next one.
    for (int step = 1; step <= kStepsPerKnot; ++step) {
      const double share = static_cast<double>(step) / kStepsPerKnot;
      const double t = (1.0 - share) * knots[i - 1] + share * knots[i];
      curve.points.push_back(spline.evaluate(t, 0).point);
    }
  }
  return curve;
}

// The surface with what all its lines are cut by.
class Cutter {
 public:
  Cutter(const surface::LimitSurface& surface, double tolerance, bool splines, LengthUnit unit)
      : surface_(surface),
        tolerance_(tolerance),
        splines_(splines),
        size_(surface.mesh().size()),
        unit_(unit) {}

  double same() const { return kSamePosition * size_; }

  // To port, exactly at the position.
  std::vector<ShipCurve> cut(analysis::Axis axis, double position) const {
    const int coordinate = static_cast<int>(axis);
    std::vector<ShipCurve> curves;
    for (ShipCurve& branch : cut(analysis::line_plane(surface_, axis, position))) {
      // Plane to the last digit, lines look straight in the other views, and meet the grid.
      for (Vector3d& point : branch.points) point[coordinate] = position;
      if (branch.spline) {
        std::vector<Vector3d> points = branch.spline->points();
        for (Vector3d& point : points) point[coordinate] = position;
        branch.spline = surface::CubicSpline(std::move(points), branch.spline->knots());
      }
      add_port_half(curves, std::move(branch), same());
    }
    return curves;
  }

  std::vector<ShipCurve> cut(const Diagonal& diagonal) const {
    std::vector<ShipCurve> curves;
    for (ShipCurve& branch : cut(analysis::diagonal_plane(diagonal.height, diagonal.angle))) {
      add_port_half(curves, std::move(branch), same());
    }
    return curves;
  }

  std::vector<NamedCurves> cut_all(analysis::Axis axis,
                                   const std::vector<double>& positions) const {
    const int decimals = decimals_of(positions, unit_);
    std::vector<NamedCurves> family;
    for (const double position : positions) {
      family.push_back({position, length_text(position, decimals, unit_), cut(axis, position)});
    }
    return family;
  }

 private:
  // Splines from knuckle to knuckle, or polylines from end to end.
  std::vector<ShipCurve> cut(const analysis::Plane& plane) const {
    std::vector<ShipCurve> curves;
    if (splines_) {
      for (const analysis::SectionSplines& branch :
           analysis::section_splines(surface_, plane, tolerance_, kInSection * size_)) {
        for (const analysis::SectionSpline& spline : branch.splines) {
          curves.push_back(with_points(spline.curve));
        }
      }
    } else {
      for (analysis::SectionCurve& branch : analysis::section(
               surface_, plane, analysis::SectionOptions{tolerance_, kInSection * size_})) {
        // A branch as a whole, over its knuckles: on paper they are points like others.
        curves.push_back({std::move(branch.points), std::nullopt});
      }
    }
    return curves;
  }

  const surface::LimitSurface& surface_;
  double tolerance_;
  bool splines_;
  double size_;
  LengthUnit unit_;
};

// The waterlines in order of their heights, with the design waterline among them.
void mark_design_waterline(const Cutter& cutter, std::vector<NamedCurves>& waterlines,
                           double draft) {
  const auto is_same = [&](const NamedCurves& line) {
    return std::abs(line.position - draft) <= cutter.same();
  };
  const auto found = std::find_if(waterlines.begin(), waterlines.end(), is_same);
  // At the very draft, so that is_design_waterline() knows it again.
  if (found != waterlines.end()) {
    found->position = draft;
    found->label = "DWL " + found->label;
    return;
  }
  NamedCurves own = std::move(cutter.cut_all(analysis::Axis::kZ, {draft}).front());
  own.label = "DWL " + own.label;
  waterlines.push_back(std::move(own));
  std::sort(waterlines.begin(), waterlines.end(),
            [](const NamedCurves& a, const NamedCurves& b) { return a.position < b.position; });
}

std::vector<NamedDiagonal> cut_diagonals(const Cutter& cutter,
                                         const std::vector<Diagonal>& diagonals) {
  std::vector<NamedDiagonal> named;
  for (const Diagonal& diagonal : diagonals) {
    if (!std::isfinite(diagonal.height) || !(diagonal.angle >= 0.0) ||
        !(diagonal.angle < 0.5 * std::numbers::pi - 1e-6)) {
      throw std::invalid_argument("A diagonal at the height " + metres(diagonal.height) +
                                  " needs an angle from 0 to below 90 degrees");
    }
    std::string label = "D" + std::to_string(named.size() + 1);
    named.push_back({diagonal, std::move(label), cutter.cut(diagonal)});
  }
  // After they were named: a diagonal keeps its number though one before it does not meet the hull.
  std::erase_if(named, [](const NamedDiagonal& member) { return member.curves.empty(); });
  return named;
}

ShipCurve ship_curve(const surface::CreaseCurve& crease) {
  const surface::CubicSpline& spline = crease.spline();
  ShipCurve curve{{}, part_of_spline(spline, spline.begin(), spline.end())};
  const int steps = crease.edge_count() * kStepsPerEdge;
  for (int i = 0; i <= steps; ++i) {
    curve.points.push_back(crease.evaluate(static_cast<double>(i) / kStepsPerEdge, 0).point);
  }
  // Bit for bit, which is how a closed line is told when drawn.
  if (crease.closed()) curve.points.back() = curve.points.front();
  return curve;
}

void add_features(const surface::LimitSurface& surface, bool mirrored, LinesDrawing& drawing) {
  // Keel and stem of a half hull that stand a little beyond the centre plane are its profile still.
  const double slack = (mirrored ? kAtCentreLine : kSamePosition) * surface.mesh().size();
  for (const surface::CreaseCurve& crease : surface::crease_curves(surface)) {
    const bool border = crease.kind() == surface::CreaseKind::kBorder;
    // Nothing is cut: a crease's own spline is the surface's curve, but for darts.
    add_port_half(border ? drawing.outlines : drawing.knuckles, ship_curve(crease), slack);
  }
}

// Lines beyond what the views show would only have rows in the table.
void leave_out_beyond(LinesDrawing& drawing, double same) {
  // A line that cuts the hull has its own curve in them, so only such as cut nothing are beyond.
  const HullExtents extents = hull_extents(drawing);
  const auto leave_out = [same](std::vector<NamedCurves>& family, double low, double high) {
    std::erase_if(family, [&](const NamedCurves& member) {
      return member.position < low - same || member.position > high + same;
    });
  };
  leave_out(drawing.stations, extents.aft, extents.fore);
  leave_out(drawing.waterlines, extents.bottom, extents.top);
  leave_out(drawing.buttocks, 0.0, extents.breadth);
}

analysis::OffsetTable offsets_of(const surface::LimitSurface& surface, const LinesDrawing& drawing,
                                 bool mirrored) {
  const auto positions = [](const std::vector<NamedCurves>& family) {
    std::vector<double> all;
    for (const NamedCurves& member : family) all.push_back(member.position);
    return all;
  };
  std::vector<double> buttocks = positions(drawing.buttocks);
  // Before the others, where the table on the sheet expects it.
  buttocks.insert(buttocks.begin(), 0.0);  // for the heights of the profile
  return analysis::offset_table(surface, positions(drawing.stations), positions(drawing.waterlines),
                                buttocks, mirrored);
}

}  // namespace

LinesDrawing collect_lines(const surface::LimitSurface& surface, const LinesOptions& options) {
  const double size = surface.mesh().size();
  check_spacing(options.tolerance, "tolerance");
  check_spacing(options.frame_spacing, "frame spacing");
  check_frame_count(options.frame_spacing, size);
  check_spacing(options.station_spacing, "station spacing");
  if (options.frames) check_frames(*options.frames);
  // On paper the hull is no larger than the sheet, whatever the scale will be.
  const double paper = std::max(options.paper.width, options.paper.height);
  const Cutter cutter(surface, options.tolerance.value_or(kPaperTolerance / paper * size),
                      options.splines, options.unit);
  LinesDrawing drawing;
  drawing.unit = options.unit;
  drawing.title = options.title;
  drawing.title_rows = options.title_rows;
  drawing.particulars = options.particulars;
  drawing.draft = options.draft;
  drawing.length = options.length;
  drawing.frame_spacing = options.frame_spacing;
  drawing.frames = options.frames;
  drawing.views = options.views;
  drawing.paper = options.paper;
  drawing.scale_denominator = options.scale_denominator;
  drawing.dxf_unit = options.dxf_unit;
  const double same = cutter.same();
  const std::vector<double> stations = in_order(options.stations, "station", same);
  const std::vector<double> waterlines = in_order(options.waterlines, "waterline", same);
  std::vector<double> buttocks = in_order(options.buttocks, "buttock", same);
  if (!buttocks.empty() && buttocks.front() < 0.0) {
    throw std::invalid_argument("A buttock at y = " + metres(buttocks.front()) +
                                " is not on the half that is drawn; give offsets from 0 up");
  }
  // The centre plane's own curve is the outline.
  if (!buttocks.empty() && buttocks.front() <= same) buttocks.erase(buttocks.begin());
  if (options.draft && !std::isfinite(*options.draft)) {
    throw std::invalid_argument("The draft is not a finite number");
  }
  // Before anything is cut: the half that is drawn has to be there.
  const std::string missing = options.mirrored ? analysis::missing_port_side(surface, true) : "";
  if (!missing.empty()) throw std::invalid_argument(missing);
  drawing.stations = cutter.cut_all(analysis::Axis::kX, stations);
  number_stations(drawing.stations, numbering_of(stations, options.station_spacing));
  // Numbers that were given before are replaced; frames are checked by then.
  if (options.frames && options.in_frames) {
    for (NamedCurves& station : drawing.stations) {
      station.label = frame_name(station.position, *options.frames);
    }
  }
  drawing.waterlines = cutter.cut_all(analysis::Axis::kZ, waterlines);
  if (options.draft) mark_design_waterline(cutter, drawing.waterlines, *options.draft);
  drawing.buttocks = cutter.cut_all(analysis::Axis::kY, buttocks);
  drawing.diagonals = cut_diagonals(cutter, options.diagonals);
  // A whole hull has no border in the centre plane that would be its profile.
  if (!options.mirrored) {
    for (ShipCurve& curve : cutter.cut(analysis::Axis::kY, 0.0)) {
      drawing.outlines.push_back(std::move(curve));
    }
  }
  add_features(surface, options.mirrored, drawing);
  // Before the table is made, which has a row or column for each line that is left.
  leave_out_beyond(drawing, same);
  if (options.offsets) drawing.offsets = offsets_of(surface, drawing, options.mirrored);
  return drawing;
}

void write_lines_drawing(const surface::LimitSurface& surface, const LinesOptions& options,
                         const std::string& path) {
  check_lines_path(path);
  LinesOptions chosen = options;
  // Who reads the file may enlarge it: what serves a sheet of paper would show.
  if (is_dxf_path(path)) {
    chosen.splines = true;
    chosen.tolerance = options.tolerance.value_or(kDxfTolerance * surface.mesh().size());
  }
  // In the time of crowded plans most goes into the layout.
  surface::tell(options.progress, 0.0, 1.0);
  const LinesDrawing drawing = collect_lines(surface, chosen);
  surface::tell(options.progress, 0.1, 1.0);
  const LinesSheet sheet = lay_out_lines(drawing);
  surface::tell(options.progress, 0.8, 1.0);
  write_lines_sheet(sheet, drawing, path);
}

}  // namespace hull::drawing
