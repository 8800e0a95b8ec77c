// SPDX-License-Identifier: GPL-3.0-or-later
// Usual papers.
#pragma once

#include <string>

namespace hull {

enum class Paper { kA4, kA3, kA2, kA1, kA0 };  // all landscape

struct PaperSize {
  std::string name;
  double width, height;  // mm
};

PaperSize paper_size(Paper paper);

}  // namespace hull
