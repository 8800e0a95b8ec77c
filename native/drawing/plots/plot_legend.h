// SPDX-License-Identifier: GPL-3.0-or-later
// The rows below a plot that say what its lines, dots and areas are.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "drawing/paper/sheet_builder.h"

namespace hull::drawing {

enum class LegendSign { kLine, kDot, kSwatch, kBar };

struct LegendEntry {
  LegendSign sign;
  Pen pen;  // of the line; its colour is that of a dot or swatch
  std::string text;
  double width = 7.0;  // of the sign, mm
  // What shares the entry, before it: "— S  — Aw: 200 m²/div".
  std::vector<LegendEntry> before = {};
};

inline constexpr double kLegendRow = 4.2;
inline constexpr double kSignGap = 1.5;

// Draws a sign with its left end at `start`, in the middle of its row.
void draw_sign(SheetBuilder& builder, const LegendEntry& entry, const Eigen::Vector2d& start);

class PlotLegend {
 public:
  // Arranged in columns across `width` mm, in at most `most_rows` rows: of one width if that does,
  // else each as wide as its entries are. Texts too long for a column are made smaller or end in an
  // ellipsis, and what has no row is counted in the last one.
  PlotLegend(std::vector<LegendEntry> entries, double width, int most_rows);

  double height() const { return rows_ * kLegendRow; }

  // Draws it with its upper left corner there.
  void draw(SheetBuilder& builder, const Eigen::Vector2d& corner) const;

 private:
  std::vector<LegendEntry> entries_;
  std::size_t left_out_ = 0;
  int rows_ = 0;
  std::vector<double> column_widths_;
};

}  // namespace hull::drawing
