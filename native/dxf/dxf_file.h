// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings for CAD systems: a DXF file of release 2000 (AC1015), by way of dxflib.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace hull::dxf {

// What a number of the file means: the header's $INSUNITS.
enum class DxfUnit { kMetre, kMillimetre };

enum class DxfLineType { kContinuous, kCentre, kDashed };

struct DxfLayer {
  std::string name;  // letters, digits, '-' and '_'
  int colour;        // AutoCAD colour index, 1 to 255
  double width;      // mm on paper; the nearest of the format's line weights is taken
  DxfLineType line_type = DxfLineType::kContinuous;
};

// A curve in the drawing's plane, a cubic B-spline: four more knots than points.
struct DxfSpline {
  int layer;  // its number in DxfDrawing::layers
  std::vector<Eigen::Vector2d> points;
  std::vector<double> knots;
};

struct DxfPolyline {
  int layer;
  std::vector<Eigen::Vector2d> points;  // two or more; closed where the last is the first
};

// The same anywhere in space.
struct DxfSpaceSpline {
  int layer;
  std::vector<Eigen::Vector3d> points;
  std::vector<double> knots;
};

struct DxfText {
  int layer;
  std::string text;          // UTF-8
  Eigen::Vector2d position;  // of the baseline's middle, whatever the letters' width
  double height;             // of the capitals
  double angle = 0.0;        // radians, counter-clockwise
};

// All coordinates are in `unit`, x to the right, y up.
struct DxfDrawing {
  DxfUnit unit = DxfUnit::kMetre;
  double paper_millimetre = 1.0;  // its length in the drawing: dashes are as long as on paper
  std::vector<DxfLayer> layers;
  std::vector<DxfSpline> splines;
  std::vector<DxfPolyline> polylines;
  std::vector<DxfText> texts;
  std::vector<DxfSpaceSpline> space_splines;
};

// Writes the drawing to `path`, completely or not at all. Numbers have 16 digits; letters beyond
// ASCII are written as \U+XXXX, which the format's readers know.
//
// Throws FileError (files/atomic_file.h) if the file can't be written.
// REQUIRES: layers exist, numbers are finite.
void write_dxf(const DxfDrawing& drawing, const std::string& path);

}  // namespace hull::dxf
