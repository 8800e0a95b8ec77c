// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/paper/text_meter.h"

#include <algorithm>

#include "drawing/paper/cairo_handles.h"

namespace hull::drawing {

namespace {

constexpr double kSmallestShare = 0.6;
constexpr double kAscent = 0.77;  // per em: capitals, figures and ascenders of sans-serif faces
constexpr double kBelow = 0.02;

// Removes the last character of UTF-8 text: its continuation bytes (10xxxxxx) and its first byte.
void remove_last_character(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
  if (!text.empty()) text.pop_back();
}

}  // namespace

TextSize text_size(const std::string& text, double size, bool bold) {
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const CairoContext context(cairo_create(surface.get()));
  // Measured large and scaled down: the advances of small fonts are rounded by some backends.
  constexpr double kMeasuredEm = 100.0;
  select_face(context.get(), kMeasuredEm, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context.get(), text.c_str(), &extents);
  // Cairo's bearing is from the baseline to the top of the ink, negative upwards.
  const double descent = std::max(0.0, extents.y_bearing + extents.height) / kMeasuredEm;
  return {extents.x_advance * size / kMeasuredEm, kAscent * size, (descent + kBelow) * size};
}

FittedText fit_text(const std::string& text, double size, bool bold, double width) {
  const double wanted = text_size(text, size, bold).width;
  if (wanted <= width) return {text, size};
  const double smaller = std::max(size * width / wanted, kSmallestShare * size);
  std::string kept = text;
  std::string shown = text;
  // The slack: a text made just as small as it must be is measured anew here, and rounding must not
  // cost it a letter.
  while (!kept.empty() && text_size(shown, smaller, bold).width > width * (1.0 + 1e-9)) {
    remove_last_character(kept);
    shown = kept + "…";
  }
  return {shown, smaller};
}

}  // namespace hull::drawing
