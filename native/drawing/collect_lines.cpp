// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/collect_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "analysis/sections/feature_curves.h"
#include "analysis/sections/sections.h"
#include "drawing/canvas.h"
#include "drawing/ship_curve.h"

namespace hull {

namespace {

// Of the mesh's size: 0.02 mm on a sheet of A3, a tenth of a thin line.
constexpr double kChordTolerance = 5e-5;
constexpr double kSamePosition = 1e-6;
// Of the mesh's size: how far to starboard the centre line of a half hull may lie by its modelling.
constexpr double kCentreLineSlack = 1e-3;

std::vector<double> in_order(std::vector<double> positions, const std::string& kind, double same) {
  for (const double position : positions) {
    if (!std::isfinite(position)) {
      throw std::invalid_argument("A " + kind + "'s position is not a finite number");
    }
  }
  std::sort(positions.begin(), positions.end());
  const auto is_same = [same](double a, double b) { return b - a <= same; };
  positions.erase(std::unique(positions.begin(), positions.end(), is_same), positions.end());
  return positions;
}

// The fewest decimals, from 1 to 3, that tell these numbers to half a millimetre.
int decimals_of(const std::vector<double>& values) {
  for (int decimals = 1; decimals < 3; ++decimals) {
    const double unit = std::pow(10.0, -decimals);
    const auto is_told = [unit](double value) {
      return std::abs(std::round(value / unit) * unit - value) <= 5e-4;
    };
    if (std::all_of(values.begin(), values.end(), is_told)) return decimals;
  }
  return 3;
}

std::string metres(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f m", decimals, value);
  return text;
}

// How far x is from a whole number of spacings, in spacings.
double off_grid(double x, double spacing) {
  return std::abs(x / spacing - std::round(x / spacing));
}

// The spacing by which sorted stations are numbered; 0 if they are to be counted.
double numbering_of(const std::vector<double>& stations, const std::optional<double>& given) {
  if (given) {
    if (!(*given > 0.0) || !std::isfinite(*given)) {
      throw std::invalid_argument("The station spacing must be above zero, not " +
                                  metres(*given, 3));
    }
    return *given;
  }
  if (stations.size() < 2) return 0.0;
  double smallest = stations[1] - stations[0];
  for (std::size_t i = 2; i < stations.size(); ++i) {
    smallest = std::min(smallest, stations[i] - stations[i - 1]);
  }
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

// The parts of the curve to port of y = 0. Points less than `slack` to starboard are taken for
// points of the centre plane.
void add_port_half(std::vector<ShipCurve>& curves, ShipCurve curve, double slack) {
  for (Vector3d& point : curve) {
    if (point.y() < 0.0 && point.y() >= -slack) point.y() = 0.0;
  }
  for (ShipCurve& part : part_of_curve(curve, 1, 0.0, Side::kAbove)) {
    curves.push_back(std::move(part));
  }
}

// Where a plane is cut that is to be drawn at `position`: an invisible step towards the middle of
// the hull. A flat end, bottom or side then shows its edge. In the plane itself it would show
// nothing, or only rounding where its points come from a file in single precision.
double inwards(const LimitSurface& surface, int axis, double position) {
  double low = position, high = position;
  for (const Vector3d& point : surface.mesh().points()) {
    low = std::min(low, point[axis]);
    high = std::max(high, point[axis]);
  }
  const double step = kSamePosition * surface.mesh().size();
  const double middle = 0.5 * (low + high);
  return position + std::clamp(middle - position, -step, step);
}

std::vector<ShipCurve> cut(const LimitSurface& surface, Axis axis, double position) {
  const int coordinate = static_cast<int>(axis);
  const double size = surface.mesh().size();
  const double where = inwards(surface, coordinate, position);
  std::vector<ShipCurve> curves;
  for (SectionCurve& branch : section(surface, axis, where, kChordTolerance * size)) {
    for (Vector3d& point : branch.points) point[coordinate] = position;
    add_port_half(curves, branch.points, kSamePosition * size);
  }
  return curves;
}

std::vector<NamedCurves> cut_all(const LimitSurface& surface, Axis axis,
                                 const std::vector<double>& positions) {
  const int decimals = decimals_of(positions);
  std::vector<NamedCurves> family;
  for (const double position : positions) {
    family.push_back({position, metres(position, decimals), cut(surface, axis, position)});
  }
  return family;
}

void mark_design_waterline(const LimitSurface& surface, std::vector<NamedCurves>& waterlines,
                           double draft, double same) {
  const auto is_same = [&](const NamedCurves& line) {
    return std::abs(line.position - draft) <= same;
  };
  const auto found = std::find_if(waterlines.begin(), waterlines.end(), is_same);
  if (found != waterlines.end()) {
    found->position = draft;
    found->label = "DWL " + found->label;
    return;
  }
  waterlines.push_back(
      {draft, "DWL " + metres(draft, decimals_of({draft})), cut(surface, Axis::kZ, draft)});
}

void add_features(const LimitSurface& surface, bool mirrored, LinesDrawing& drawing) {
  const double slack = (mirrored ? kCentreLineSlack : kSamePosition) * surface.mesh().size();
  for (const FeatureCurve& feature : feature_curves(surface)) {
    const bool border = feature.kind == CreaseKind::kBorder;
    add_port_half(border ? drawing.outlines : drawing.knuckles, feature.points, slack);
  }
}

}  // namespace

LinesDrawing collect_lines(const LimitSurface& surface, const LinesOptions& options) {
  const double same = kSamePosition * surface.mesh().size();
  LinesDrawing drawing;
  drawing.title = options.title;
  drawing.particulars = options.particulars;
  drawing.draft = options.draft;
  drawing.length = options.length;
  drawing.paper = options.paper;
  const std::vector<double> stations = in_order(options.stations, "station", same);
  const std::vector<double> waterlines = in_order(options.waterlines, "waterline", same);
  std::vector<double> buttocks = in_order(options.buttocks, "buttock", same);
  if (!buttocks.empty() && buttocks.front() < 0.0) {
    throw std::invalid_argument("A buttock at y = " + metres(buttocks.front(), 3) +
                                " is not on the half that is drawn; give offsets from 0 up");
  }
  // The centre plane's own curve is the outline.
  if (!buttocks.empty() && buttocks.front() <= same) buttocks.erase(buttocks.begin());
  if (options.draft && !std::isfinite(*options.draft)) {
    throw std::invalid_argument("The draft is not a finite number");
  }
  drawing.stations = cut_all(surface, Axis::kX, stations);
  number_stations(drawing.stations, numbering_of(stations, options.station_spacing));
  drawing.waterlines = cut_all(surface, Axis::kZ, waterlines);
  if (options.draft) mark_design_waterline(surface, drawing.waterlines, *options.draft, same);
  drawing.buttocks = cut_all(surface, Axis::kY, buttocks);
  if (!options.mirrored) {
    for (ShipCurve& curve : cut(surface, Axis::kY, 0.0)) {
      drawing.outlines.push_back(std::move(curve));
    }
  }
  add_features(surface, options.mirrored, drawing);
  return drawing;
}

void write_lines_drawing(const LimitSurface& surface, const LinesOptions& options,
                         const std::string& path) {
  check_drawing_path(path);
  write_lines_drawing(collect_lines(surface, options), path);
}

}  // namespace hull
