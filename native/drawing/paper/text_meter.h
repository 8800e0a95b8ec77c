// SPDX-License-Identifier: GPL-3.0-or-later
// How much room a text takes on the page. Measured without hinting, so that a layout is the same
// for every kind of file.
#pragma once

#include <string>

namespace hull::drawing {

struct TextSize {
  double width;
  double ascent;   // from the baseline to above the capitals; the same for all texts of one size
  double descent;  // from the baseline to below the deepest letter of this text
};

// The size in mm of `text` set in the drawing's sans-serif face with an em of `size` mm.
// REQUIRES: valid UTF-8.
TextSize text_size(const std::string& text, double size, bool bold);

// A text and the size at which it fits.
struct FittedText {
  std::string text;
  double size;
};

// `text` made to fit into `width` mm: at `size` if it does, else smaller down to 60 %, and if that
// is not enough, shortened to end in an ellipsis.
FittedText fit_text(const std::string& text, double size, bool bold, double width);

}  // namespace hull::drawing
