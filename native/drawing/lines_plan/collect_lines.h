// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a surface, ready to be drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/lines_plan/lines_drawing.h"
#include "surface/limit_surface.h"
#include "surface/progress.h"

namespace hull::drawing {

struct LinesOptions {
  std::vector<double> stations;     // x, m
  std::vector<double> waterlines;   // z, m
  std::vector<double> buttocks;     // y, m, not below zero; 0 is the outline anyway
  std::vector<Diagonal> diagonals;  // named D1, D2, ... in this order
  bool mirrored = true;             // the surface is the half y >= 0
  std::optional<double> draft;   // a waterline at this z is added and drawn as the design waterline
  std::optional<double> length;  // between perpendiculars, from x = 0
  // A station's number is its x in units of this, so that 0 is the after perpendicular and half
  // stations read 0.5. Without it the smallest distance of two stations, if all are multiples of
  // it; else they are counted from 0, from aft.
  std::optional<double> station_spacing;
  std::optional<double> frame_spacing;  // m; draws the frames, frame 0 at x = 0
  // Drawn in place of those; stations are named by them where they are `in_frames`.
  std::optional<PlanFrames> frames;
  bool in_frames = false;
  bool offsets = true;  // draws the table of offsets
  PlanViews views;
  LengthUnit unit = LengthUnit::kMetre;  // of the plan's words; all here is in metres
  std::string title;
  std::vector<Particular> title_rows, particulars;
  PaperSize paper = paper_size(Paper::kA3);
  std::optional<double> scale_denominator;  // 100 for 1:100; without it the largest that fits
  dxf::DxfUnit dxf_unit = dxf::DxfUnit::kMetre;
  // How far curves may be from the surface's, m; without it as far as the paper does not show.
  std::optional<double> tolerance;
  bool splines = false;  // sections are splines from knuckle to knuckle
  // Of write_lines_drawing. When it is not told any more, the file is being written.
  surface::Progress progress;
};

// Cuts the surface at every position (in any order, repeated ones once) and adds its borders and
// knuckles, which are splines always, and the table of offsets. Of a whole hull the port half is
// taken, with its section by the centre plane as outline. Where a flat part of the hull lies in a
// plane, its edge is drawn. Lines beyond the hull and its perpendiculars are left out.
//
// Throws as lay_out_lines of the curves, and std::invalid_argument for a position, draft or length
// that is not finite, a negative buttock, more than kMostOffsetPositions of a kind, a diagonal's
// angle that is not from 0 to below 90 degrees, and a station spacing, frame spacing or tolerance
// that is not above zero.
LinesDrawing collect_lines(const surface::LimitSurface& surface, const LinesOptions& options);

// The two steps at once; a wrong file name is refused before anything is computed. A DXF file has
// splines, to kDxfTolerance of the hull's size unless a tolerance is given. Throws as collect_lines
// and write_lines_drawing (lines_drawing.h).
inline constexpr double kDxfTolerance = 1e-6;
void write_lines_drawing(const surface::LimitSurface& surface, const LinesOptions& options,
                         const std::string& path);

}  // namespace hull::drawing
