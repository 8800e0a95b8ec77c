// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/lines_dxf.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drawing/paper/dxf_lines.h"

namespace hull::drawing {

using Eigen::Vector2d;

namespace {

constexpr char kTextLayer[] = "TEXT";
// Of the em, the capitals of the drawing's face are so high.
constexpr double kCapitals = 0.72;
constexpr double kAboveCurve = 0.4;  // mm

// AutoCAD's first colours, in the order red, green, blue, magenta; the nearest hue is taken.
constexpr int kBlackOrWhite = 7;
constexpr int kGreyIndex = 8;

int colour_index(const Ink& colour) {
  const double high = std::max({colour.red, colour.green, colour.blue});
  const double low = std::min({colour.red, colour.green, colour.blue});
  // Without a hue: black or a grey.
  if (high - low < 0.1) return high < 0.2 ? kBlackOrWhite : kGreyIndex;
  if (colour.red > colour.green && colour.blue > colour.green && colour.red > 0.6 * colour.blue &&
      colour.blue > 0.6 * colour.red) {
    return 6;  // magenta
  }
  if (colour.red == high) return 1;
  return colour.green == high ? 3 : 5;
}

// CAD programs' own letters have no dashes but the hyphen.
std::string without_dashes(const std::string& text) {
  const std::string dash = "–";
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_dash = text.compare(i, dash.size(), dash) == 0;
    plain += is_dash ? '-' : text[i];
    // In UTF-8 it is several bytes.
    if (is_dash) i += dash.size() - 1;
  }
  return plain;
}

class Converter {
 public:
  Converter(const LinesSheet& sheet, dxf::DxfUnit unit)
      : origin_(sheet.profile.origin),
        per_mm_((unit == dxf::DxfUnit::kMetre ? 1.0 : 1000.0) / sheet.profile.scale) {
    drawing_.unit = unit;
    drawing_.paper_millimetre = per_mm_;
  }

  dxf::DxfDrawing convert(const LinesSheet& sheet) && {
    for (const Stroke& stroke : sheet.strokes) add(stroke);
    for (const Fill& patch : sheet.patches) add(patch);
    // All words are on one layer, whatever ink they have on paper.
    const int text_layer = layer({0.18, {0.0, 0.0, 0.0}, {}, kTextLayer});
    for (const Label& label : sheet.labels) add(label, text_layer);
    return std::move(drawing_);
  }

 private:
  Vector2d true_point(const Vector2d& page) const {
    // Page to ship: y is turned up again, about the profile's origin.
    return {per_mm_ * (page.x() - origin_.x()), per_mm_ * (origin_.y() - page.y())};
  }

  std::vector<Vector2d> true_points(const std::vector<Vector2d>& page) const {
    std::vector<Vector2d> points;
    points.reserve(page.size());
    for (const Vector2d& point : page) points.push_back(true_point(point));
    return points;
  }

  // The number of the pen's layer; the first pen of a layer gives it its looks.
  int layer(const Pen& pen) {
    for (std::size_t i = 0; i < drawing_.layers.size(); ++i) {
      if (drawing_.layers[i].name == pen.layer) return static_cast<int>(i);
    }
    drawing_.layers.push_back(
        {std::string(pen.layer), colour_index(pen.colour), pen.width, dxf_line_type(pen.dashes)});
    return static_cast<int>(drawing_.layers.size()) - 1;
  }

  void add(const Stroke& stroke) {
    const int number = layer(stroke.pen);
    // An affine map takes a spline's control points along, its knots stay.
    if (stroke.spline) {
      drawing_.splines.push_back(
          {number, true_points(stroke.spline->points), stroke.spline->knots});
    } else {
      drawing_.polylines.push_back({number, true_points(stroke.points)});
    }
  }

  // The dark parts of the scale bar: crossed through.
  void add(const Fill& patch) {
    if (patch.points.size() < 4) return;
    const int number = layer({0.18, patch.colour, {}, "TABLES"});
    // A DxfDrawing has no filled areas.
    drawing_.polylines.push_back({number, true_points({patch.points[0], patch.points[2]})});
    drawing_.polylines.push_back({number, true_points({patch.points[1], patch.points[3]})});
  }

  void add(const Label& label, int text_layer) {
    const double angle = label.box.angle;
    const Vector2d down(-std::sin(angle), std::cos(angle));
    // Where the paper knocks a gap into the curve, the file sets the text above it: its curves are
    // whole.
    const double baseline = label.knockout ? -kAboveCurve : label.box.half.y() - label.descent;
    // Angles on the page turn from x to y, which runs down; the file's y runs up.
    drawing_.texts.push_back({text_layer, without_dashes(label.text),
                              true_point(label.box.centre + baseline * down),
                              kCapitals * label.size * per_mm_, -angle});
  }

  Vector2d origin_;
  double per_mm_;  // of the file's unit
  dxf::DxfDrawing drawing_;
};

}  // namespace

dxf::DxfDrawing lines_dxf(const LinesSheet& sheet, dxf::DxfUnit unit) {
  return Converter(sheet, unit).convert(sheet);
}

void write_lines_dxf(const LinesSheet& sheet, dxf::DxfUnit unit, const std::string& path) {
  dxf::write_dxf(lines_dxf(sheet, unit), path);
}

}  // namespace hull::drawing
