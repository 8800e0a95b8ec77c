// SPDX-License-Identifier: GPL-3.0-or-later
// Adds lines and labels to a sheet and keeps account of what is taken.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drawing/paper/label_placer.h"
#include "drawing/paper/pens.h"
#include "drawing/paper/sheet.h"

namespace hull::drawing {

using PagePath = std::vector<Eigen::Vector2d>;

// The sides of a box, closed.
PagePath outline_of(const Eigen::AlignedBox2d& box);

inline constexpr double kLabelSize = 2.8;  // mm, about 8 points

struct TextStyle {
  double size = kLabelSize;
  bool bold = false;
  Ink ink = inks::kBlack;
  bool knockout = false;
};

// Which point of a text's box is meant by its position.
enum class Align { kLeft, kCentre, kRight };  // vertically always the middle of the capitals

class SheetBuilder {
 public:
  explicit SheetBuilder(Sheet sheet) : sheet_(std::move(sheet)) {}

  // A line that labels may cross: grid, frame, leader.
  void draw(const Pen& pen, PagePath points);

  // A line that labels keep clear of. Returns its number for `own_curve` below.
  int draw_curve(const Pen& pen, PagePath points, std::optional<PageSpline> spline = std::nullopt);

  // Above the lines: a dot, the part of a bar.
  void fill(const Ink& colour, PagePath polygon) {
    sheet_.patches.push_back({colour, std::move(polygon)});
  }

  // Below the lines.
  void shade(const Ink& colour, PagePath polygon) {
    sheet_.areas.push_back({colour, std::move(polygon)});
  }

  // Below all else.
  void show(Picture picture) { sheet_.pictures.push_back(std::move(picture)); }

  // A box that labels keep clear of, with nothing drawn.
  void occupy(const OrientedBox& box) { placer_.add_box(box); }

  // The box `text` takes at `position`.
  static OrientedBox text_box(const std::string& text, const TextStyle& style,
                              const Eigen::Vector2d& position, Align align = Align::kCentre,
                              double angle = 0.0);

  // Puts the text there, whatever else is there.
  void put_text(const std::string& text, const TextStyle& style, const OrientedBox& box);

  // Whether `box` with `clearance` mm around it is within `bounds` and free.
  bool has_room(const OrientedBox& box, double clearance, const Eigen::AlignedBox2d& bounds,
                int own_curve = LabelPlacer::kNoCurve) const;

  const LabelPlacer& placer() const { return placer_; }

  Sheet finish() && { return std::move(sheet_); }

 private:
  Sheet sheet_;
  LabelPlacer placer_;
};

}  // namespace hull::drawing
