// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace hull::analysis {

// Half the thickness of a section of unit chord, perpendicular to its mean line at x = s²:
// polynomials in s.
class SectionThickness {
 public:
  // y = t / 0.2 (0.2969 √x - 0.1260 x - 0.3516 x² + 0.2843 x³ - 0.1015 x⁴), (Jacobs, Ward &
  // Pinkerton 1933): the trailing edge is 0.0105 t thick on each side.
  static SectionThickness four_digits(double thickness);
  // The four-digit sections' modification (Stack & Doenhoff 1934; Ladson & Brooks 1975): the nose's
  // radius by an index from 1 to 9, of which 6 is that of four digits and 9 three times it, and the
  // largest thickness at 2 to 6 tenths of the chord. The trailing edge is 0.01 t thick on each
  // side.
  static SectionThickness modified(double thickness, int nose, int tenths);
  // 63-, 64-, 65-series and their 6A-series: y / √x is the natural cubic spline in √x through the
  // ratios of section_tables.h.
  static SectionThickness series(int family, bool is_6a, double thickness);

  // y and dy/ds.
  std::array<double, 2> at(double s) const;
  // Where one polynomial ends and the next begins, with 0 and 1.
  std::vector<double> knots() const;

 private:
  // Σ factors[k] s^k up to an end.
  struct Piece {
    double end;
    std::array<double, 9> factors;
  };
  SectionThickness(std::vector<Piece> pieces, double tail)
      : pieces_(std::move(pieces)), tail_(tail) {}

  std::vector<Piece> pieces_;
  double tail_;  // y at 1 without rounding: sharp edges are sharp
};

}  // namespace hull::analysis
