// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "drawing/paper.h"

namespace hull::bindings {

inline Paper paper_from(const std::string& name) {
  for (const Paper paper : {Paper::kA4, Paper::kA3, Paper::kA2, Paper::kA1, Paper::kA0}) {
    if (paper_size(paper).name == name) return paper;
  }
  throw std::invalid_argument("paper is \"A4\", \"A3\", \"A2\", \"A1\" or \"A0\", not \"" + name +
                              "\".");
}

}  // namespace hull::bindings
