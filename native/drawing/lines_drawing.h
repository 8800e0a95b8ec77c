// SPDX-License-Identifier: GPL-3.0-or-later
// A lines plan: body plan, profile and half-breadth plan of one hull at one scale on one sheet.
//
// `LinesDrawing` is what is to be drawn, as curves in ship axes (x forward, y to port, z up,
// metres); collect_lines.h makes one from a surface. `lay_out_lines` decides where everything goes,
// and `write_lines_drawing` writes the result as a file.
//
// The drawing follows the trade: the bow to the right, the half-breadth plan below the profile and
// in line with it, the body plan with the fore sections right and the after sections left of the
// centre line, midship sections on both sides.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "drawing/lines_sheet.h"
#include "drawing/paper.h"

namespace hull {

using ShipCurve = std::vector<Eigen::Vector3d>;

// The curves in which one plane cuts the hull.
struct NamedCurves {
  double position;    // x of a station, z of a waterline, y of a buttock
  std::string label;  // "7", "2.0 m"
  std::vector<ShipCurve> curves;
};

struct Particular {
  std::string name;   // "Length between perpendiculars"
  std::string value;  // "120.00 m"
};

// Only the half y >= 0 is drawn; curves must be on it.
struct LinesDrawing {
  std::string title;
  std::vector<Particular> particulars;  // at most kMostParticulars
  std::vector<NamedCurves> stations, waterlines, buttocks;
  std::vector<ShipCurve>
      outlines;  // borders: stem, keel, sheer; the centre contour of a whole hull
  std::vector<ShipCurve> knuckles;
  // The waterline at this z is drawn as the design waterline.
  std::optional<double> draft;
  // Between perpendiculars, from x = 0: draws AP and FP, and midship is at its half. Without it
  // midship is halfway between the hull's ends.
  std::optional<double> length;
  Paper paper = Paper::kA3;
};

inline constexpr std::size_t kMostParticulars = 16;

// The largest usual scale at which the three views and the title block fit the paper, and
// everything in its place. On the sheet no two labels overlap and nothing lies outside the frame;
// where lines are so close that their labels would, some go without.
//
// Throws std::invalid_argument when there is no curve to draw, a coordinate or position is not
// finite, a curve has less than two points, there are too many particulars, or the hull is longer
// than 100 km or shorter than a millimetre.
LinesSheet lay_out_lines(const LinesDrawing& drawing);

// Lays out and writes. Throws as lay_out_lines and write_sheet (canvas.h).
void write_lines_drawing(const LinesDrawing& drawing, const std::string& path);

}  // namespace hull
