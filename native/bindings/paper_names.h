// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "drawing/paper/paper.h"

namespace hull::bindings {

inline drawing::Paper paper_from(const std::string& name) {
  for (const drawing::Paper paper : {drawing::Paper::kA4, drawing::Paper::kA3, drawing::Paper::kA2,
                                     drawing::Paper::kA1, drawing::Paper::kA0}) {
    if (drawing::paper_size(paper).name == name) return paper;
  }
  throw std::invalid_argument("paper is \"A4\", \"A3\", \"A2\", \"A1\" or \"A0\", not \"" + name +
                              "\".");
}

}  // namespace hull::bindings
