// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "drawing/paper/canvas.h"
#include "drawing/paper/dxf_lines.h"
#include "drawing/shop/shop_pens.h"
#include "dxf/dxf_file.h"

namespace hull::drawing {

using Eigen::Vector2d;

namespace {

// Of the em, the capitals of the drawings' face are so high.
constexpr double kCapitals = 0.72;
constexpr double kWordWidth = 0.18;  // of DXF's text layer, mm
// An SVG is one sheet: larger ones are no longer opened by common programs.
constexpr double kLargestSheet = 10000.0;

dxf::DxfDrawing shop_dxf(const ShopDrawing& drawing) {
  dxf::DxfDrawing file;
  file.unit = dxf::DxfUnit::kMillimetre;
  const auto layer = [&file](ShopLayer wanted) {
    const ShopPen pen = shop_pen(wanted);
    // Layers are made as lines ask for them, so that a file has none that are empty but that of
    // texts.
    const std::string name(pen.pen.layer);
    const auto found = std::find_if(file.layers.begin(), file.layers.end(),
                                    [&name](const auto& own) { return own.name == name; });
    if (found != file.layers.end()) return static_cast<int>(found - file.layers.begin());
    file.layers.push_back({name, pen.colour, pen.pen.width, dxf_line_type(pen.pen.dashes)});
    return static_cast<int>(file.layers.size()) - 1;
  };
  for (const ShopLine& line : drawing.lines) {
    file.polylines.push_back({layer(line.layer), line.points});
  }
  const auto words = static_cast<int>(file.layers.size());
  file.layers.push_back({"TEXT", 7, kWordWidth});
  for (const ShopText& text : drawing.texts) {
    // DXF places a text by its baseline, the drawing by the middle of its capitals. At true size a
    // mm of paper is one of the drawing.
    const double height = kCapitals * text.size;
    const Vector2d up(-std::sin(text.angle), std::cos(text.angle));
    file.texts.push_back(
        {words, text.text, text.position + (text.lift - 0.5 * height) * up, height, text.angle});
  }
  return file;
}

}  // namespace

void write_shop_drawing(const ShopDrawing& drawing, const PaperSize& paper, double scale,
                        const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".pdf") return write_sheets(shop_sheets(drawing, paper, scale), path);
  if (extension == ".dxf") {
    if (drawing.lines.empty()) {
      throw std::invalid_argument("The drawing \"" + drawing.title + "\" has no lines.");
    }
    return dxf::write_dxf(shop_dxf(drawing), path);
  }
  if (extension != ".svg") {
    throw std::invalid_argument("A shop drawing can't be written to \"" + path +
                                "\": the name must end in .pdf, .svg or .dxf.");
  }
  write_sheet(shop_sheet(drawing, scale, kLargestSheet), path);
}

void write_shop_booklet(const std::vector<ShopDrawing>& drawings, const PaperSize& paper,
                        const std::string& path) {
  std::vector<Sheet> sheets;
  for (const ShopDrawing& drawing : drawings) sheets.push_back(shop_page(drawing, paper));
  write_sheets(sheets, path);
}

}  // namespace hull::drawing
