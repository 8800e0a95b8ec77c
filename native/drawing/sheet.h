// SPDX-License-Identifier: GPL-3.0-or-later
// A finished drawing as plain data: what is drawn where, in millimetres of the page, before any
// file is written. The origin is the page's upper left corner, x to the right, y down.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "drawing/oriented_box.h"

namespace hull {

// What a line means; canvas.cpp gives each kind its width, colour and dashes.
enum class LineKind {
  kFrame,
  kTable,
  kGrid,
  kBaseline,
  kCentreLine,
  kPerpendicular,
  kDesignWaterline,  // the straight trace of the design waterline
  kStation,
  kWaterline,
  kLoadWaterline,  // the design waterline as a curve, heavier than its neighbours
  kButtock,
  kKnuckle,
  kOutline,
  kLeader,
};

enum class Ink { kBlack, kGrey, kStation, kWaterline, kButtock };

struct Stroke {
  LineKind kind;
  std::vector<Eigen::Vector2d> points;  // two or more
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

// Where one view of the hull lies.
struct View {
  Eigen::AlignedBox2d bounds;  // everything that belongs to the view is inside
  Eigen::Vector2d origin;      // page point of the view's ship coordinates (0, 0)
  double scale;                // millimetres of page per metre of ship

  Eigen::Vector2d to_page(double right, double up) const {
    return {origin.x() + scale * right, origin.y() - scale * up};
  }
};

struct Sheet {
  std::string title;
  double width, height;
  double scale_denominator;  // 200 for 1:200
  Eigen::AlignedBox2d frame;
  Eigen::AlignedBox2d title_block;
  View profile, half_breadth, body_plan;
  std::vector<Stroke> strokes;               // drawn first, in this order
  std::vector<Eigen::AlignedBox2d> patches;  // filled black: the scale bar
  std::vector<Label> labels;                 // drawn last
};

}  // namespace hull
