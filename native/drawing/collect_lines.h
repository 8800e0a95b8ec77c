// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a surface, ready to be drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/lines_drawing.h"
#include "surface/limit_surface.h"

namespace hull {

struct LinesOptions {
  std::vector<double> stations;    // x, m
  std::vector<double> waterlines;  // z, m
  std::vector<double> buttocks;    // y, m, not below zero; 0 is the outline anyway
  bool mirrored = true;            // the surface is the half y >= 0
  std::optional<double> draft;   // a waterline at this z is added and drawn as the design waterline
  std::optional<double> length;  // between perpendiculars, from x = 0
  // A station's number is its x in units of this, so that 0 is the after perpendicular and half
  // stations read 0.5. Without it the smallest distance of two stations, if all are multiples of
  // it; else they are counted from 0, from aft.
  std::optional<double> station_spacing;
  std::string title;
  std::vector<Particular> particulars;
  Paper paper = Paper::kA3;
};

// Cuts the surface at every position (in any order, repeated ones once) and adds its borders and
// knuckles. Of a whole hull the port half is taken, with its section by the centre plane as
// outline. Curves are as fine as the paper can show. Where a flat part of the hull lies in a plane,
// its edge is drawn.
//
// Throws std::invalid_argument for a position, draft or length that is not finite, a negative
// buttock and a station spacing that is not above zero.
LinesDrawing collect_lines(const LimitSurface& surface, const LinesOptions& options);

// The two steps at once; a wrong file name is refused before anything is computed. Throws as
// collect_lines and write_lines_drawing (lines_drawing.h).
void write_lines_drawing(const LimitSurface& surface, const LinesOptions& options,
                         const std::string& path);

}  // namespace hull
