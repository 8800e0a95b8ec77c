// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings for the mould loft and the shop: plates, templates and frames at true size, over as many
// sheets as that takes.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "drawing/paper/paper.h"
#include "drawing/paper/sheet.h"

namespace hull::drawing {

// What a line is, and so how it looks and on which layer of a DXF file it is.
enum class ShopLayer {
  kOutline,
  kFrames,
  kWaterlines,
  kButtocks,
  kSeams,
  kRolling,
  kShell,
  kBase,
  kStretch,
  kHidden
};

struct ShopLine {
  ShopLayer layer;
  std::vector<Eigen::Vector2d> points;  // mm at true size, y up; two or more
};

struct ShopText {
  std::string text;
  Eigen::Vector2d position;  // of its middle, mm at true size
  double size;               // of the em, mm on paper
  double angle = 0.0;        // rad, counter-clockwise
  double lift = 0.0;         // mm on paper, by which the words are above their position
};

struct ShopDrawing {
  std::string title;
  std::vector<std::pair<std::string, std::string>> rows;  // below the title: name and value
  std::vector<ShopLine> lines;
  std::vector<ShopText> texts;
};

// The layer by its name in files, as "OUTLINE". Throws std::invalid_argument for another.
ShopLayer shop_layer(const std::string& name);

// A first sheet with all of it, as small as it must be, with the division into sheets; then these,
// in rows from the lower left: A1, A2, …, B1. They are trimmed at the corner marks and abut there;
// lines go on 5 mm beyond. `scale`: mm on paper per mm, 1 for true size.
//
// Throws std::invalid_argument for a drawing without lines, a scale that is not in (0, 10], and for
// more than 400 sheets.
std::vector<Sheet> shop_sheets(const ShopDrawing& drawing, const PaperSize& paper, double scale);

// All of it on one sheet of this paper, as large as fits, by a usual scale.
Sheet shop_page(const ShopDrawing& drawing, const PaperSize& paper);

// All of it on one sheet as large as it takes, with a margin. Throws as shop_sheets(), and where a
// side would be longer than `largest` mm.
Sheet shop_sheet(const ShopDrawing& drawing, double scale, double largest);

// The first sheets of many drawings as the pages of one `.pdf`, each drawing as large as fits.
// Throws std::invalid_argument for another extension and for drawings without lines or no drawings.
void write_shop_booklet(const std::vector<ShopDrawing>& drawings, const PaperSize& paper,
                        const std::string& path);

// Writes to `path`, completely or not at all: `.pdf`, the sheets above; `.svg`, one sheet as large
// as it takes; `.dxf`, in mm at true size whatever the scale. Throws std::invalid_argument for
// another extension and as shop_sheets(), FileError if the file can't be written.
void write_shop_drawing(const ShopDrawing& drawing, const PaperSize& paper, double scale,
                        const std::string& path);

}  // namespace hull::drawing
