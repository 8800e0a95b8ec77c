// SPDX-License-Identifier: GPL-3.0-or-later
// A lines plan: body plan, profile and half-breadth plan of one hull at one scale on one sheet.
//
// `LinesDrawing` is what is to be drawn, as curves in ship axes (x forward, y to port, z up,
// metres); collect_lines.h makes one from a surface. `lay_out_lines` decides where everything goes,
// and `write_lines_drawing` writes the result as a file.
//
// The drawing follows the trade: the bow to the right, the half-breadth plan below the profile and
// in line with it, diagonals expanded below its centre line, the body plan with the fore sections
// right and the after sections left of the centre line, midship sections on both sides.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "analysis/offsets/offset_table.h"
#include "drawing/lines_plan/lines_sheet.h"
#include "drawing/lines_plan/plan_frames.h"
#include "drawing/lines_plan/plan_lengths.h"
#include "drawing/lines_plan/ship_curve.h"
#include "drawing/paper/paper.h"
#include "dxf/dxf_file.h"

namespace hull::drawing {

// The curves in which one plane cuts the hull.
struct NamedCurves {
  double position;    // x of a station, z of a waterline, y of a buttock
  std::string label;  // "7", "2.0 m"
  std::vector<ShipCurve> curves;
};

// A plane along the ship that meets the centre plane at the height z and falls away from it, to
// both sides, by `angle` below the horizontal (radians).
struct Diagonal {
  double height;
  double angle;
};

struct NamedDiagonal {
  Diagonal diagonal;
  std::string label;  // "D1"
  std::vector<ShipCurve> curves;
};

struct Particular {
  std::string name;   // "Length between perpendiculars"
  std::string value;  // "120.00 m"
};

// Only the half y >= 0 is drawn; curves must be on it.
struct LinesDrawing {
  std::string title;
  std::vector<Particular> title_rows;   // below the title: drawn by, date; at most kMostTitleRows
  std::vector<Particular> particulars;  // at most kMostParticulars
  std::vector<NamedCurves> stations, waterlines, buttocks;
  std::vector<NamedDiagonal> diagonals;
  std::vector<ShipCurve>
      outlines;  // borders: stem, keel, sheer; the centre contour of a whole hull
  std::vector<ShipCurve> knuckles;
  // The waterline at this z is drawn as the design waterline.
  std::optional<double> draft;
  // Between perpendiculars, from x = 0: draws AP and FP, and midship is at its half. Without it
  // midship is halfway between the hull's ends.
  std::optional<double> length;
  // Draws the frames below the profile, from frame 0 at x = 0, or where they are told to be.
  std::optional<double> frame_spacing;
  std::optional<PlanFrames> frames;
  // Drawn as a table; its stations, waterlines and buttocks are those above in the same order, but
  // for a buttock 0 before the others, which is the centre line.
  std::optional<analysis::OffsetTable> offsets;
  PlanViews views;
  LengthUnit unit = LengthUnit::kMetre;  // of what is written; labels above have it
  PaperSize paper = paper_size(Paper::kA3);
  // 100 for 1:100; without it the largest usual scale that fits.
  std::optional<double> scale_denominator;
  dxf::DxfUnit dxf_unit = dxf::DxfUnit::kMetre;  // of a DXF file, which is at true size
};

inline constexpr std::size_t kMostParticulars = 16;
inline constexpr std::size_t kMostTitleRows = 8;

// The three views, the table of offsets and the title block on the paper: at the scale given, or
// the largest usual one at which all fits. On the sheet no two labels overlap and nothing lies
// outside the frame; where lines are so close that their labels would, some go without.
//
// Throws std::invalid_argument when there is no curve or view to draw, a coordinate or position is
// not finite, a curve has less than two points, there are too many particulars, the hull is longer
// than 100 km or shorter than a millimetre; when the scale given or the table is too large for the
// paper; and when lines of a kind would be nearer to one another than half a millimetre on average.
LinesSheet lay_out_lines(const LinesDrawing& drawing);

// Lays out and writes. The extension of `path` chooses PDF, SVG, PNG (canvas.h) or DXF
// (lines_dxf.h). Throws as lay_out_lines, write_sheet and write_lines_dxf.
void write_lines_drawing(const LinesDrawing& drawing, const std::string& path);

// The second step of it. REQUIRES: `sheet` is the drawing's, and the path is one of
// check_lines_path().
void write_lines_sheet(const LinesSheet& sheet, const LinesDrawing& drawing,
                       const std::string& path);

// Throws std::invalid_argument unless the extension of `path` is one of these.
void check_lines_path(const std::string& path);

// Whether it is that of DXF.
bool is_dxf_path(const std::string& path);

}  // namespace hull::drawing
