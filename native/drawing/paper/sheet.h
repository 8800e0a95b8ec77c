// SPDX-License-Identifier: GPL-3.0-or-later
// A finished drawing as plain data: what is drawn where, in millimetres of the page, before any
// file is written. The origin is the page's upper left corner, x to the right, y down.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/paper/oriented_box.h"

namespace hull::drawing {

// What lines, areas and letters are drawn in, each part in [0, 1].
struct Ink {
  double red, green, blue;
  double opacity = 1.0;

  bool operator==(const Ink&) const = default;
};

// Lengths of line and gap in turn, mm; all zero for an unbroken line.
using Dashes = std::array<double, 4>;

struct Pen {
  double width;  // mm
  Ink colour;
  Dashes dashes = {};
  std::string_view layer = {};  // of files that have layers; a literal

  bool operator==(const Pen&) const = default;
};

// A cubic B-spline on the page: four more knots than points.
struct PageSpline {
  std::vector<Eigen::Vector2d> points;
  std::vector<double> knots;
};

struct Stroke {
  Pen pen;
  std::vector<Eigen::Vector2d> points;  // two or more; closed where the last is the first
  std::optional<PageSpline> spline = std::nullopt;  // the same curve for files that know splines
};

// A polygon filled without an outline; three points or more.
struct Fill {
  Ink colour;
  std::vector<Eigen::Vector2d> points;
};

// A picture in dots, each 0xRRGGBB, row by row from above, on a part of the page.
struct Picture {
  Eigen::Vector2d corner, size;  // upper left; width and height, mm
  int columns, rows;
  std::vector<std::uint32_t> dots;
};

// One line of text, drawn to fill its box from the left; whose height is ascent and descent
// (text_meter.h).
struct Label {
  std::string text;
  double size;  // the font's em, mm
  bool bold;
  Ink ink;
  bool knockout;   // blank the paper beneath: the label interrupts a curve
  double descent;  // from the bottom of the box up to the baseline
  OrientedBox box;
};

struct Sheet {
  std::string title;
  double width, height;
  std::vector<Fill> areas;      // drawn first, upon the pictures
  std::vector<Stroke> strokes;  // then these, in this order
  std::vector<Fill> patches;    // then these: dots, bars
  std::vector<Label> labels;    // drawn last
  std::vector<Picture> pictures = {};
};

}  // namespace hull::drawing
