// SPDX-License-Identifier: GPL-3.0-or-later
// Usual papers, and others.
#pragma once

#include <string>

namespace hull::drawing {

enum class Paper { kA4, kA3, kA2, kA1, kA0 };  // all landscape

struct PaperSize {
  std::string name;
  double width, height;  // mm
};

PaperSize paper_size(Paper paper);

// A sheet of one's own, named "600 × 400 mm". Throws std::invalid_argument unless both sides are
// between 100 mm and 10 m.
PaperSize own_paper_size(double width, double height);

}  // namespace hull::drawing
