// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/paper/paper.h"

#include <cstdio>
#include <stdexcept>

namespace hull::drawing {

PaperSize paper_size(Paper paper) {
  switch (paper) {
    case Paper::kA4:
      return {"A4", 297.0, 210.0};
    case Paper::kA3:
      return {"A3", 420.0, 297.0};
    case Paper::kA2:
      return {"A2", 594.0, 420.0};
    case Paper::kA1:
      return {"A1", 841.0, 594.0};
    case Paper::kA0:
      return {"A0", 1189.0, 841.0};
  }
  throw std::logic_error("a paper without a size");
}

PaperSize own_paper_size(double width, double height) {
  char text[80];
  std::snprintf(text, sizeof text, "%.10g × %.10g mm", width, height);
  const auto usable = [](double side) { return side >= 100.0 && side <= 10000.0; };
  if (!usable(width) || !usable(height)) {
    throw std::invalid_argument("A sheet of " + std::string(text) +
                                " can't be drawn on: its sides are between 100 mm and 10 m");
  }
  return {text, width, height};
}

}  // namespace hull::drawing
