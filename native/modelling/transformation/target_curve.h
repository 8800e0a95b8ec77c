// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hull::modelling {

// A sectional area curve that is wanted, through given points: the cubic Hermite spline that rises
// and falls only where they do (Fritsch and Carlson 1980). Zero beyond its ends.
class TargetCurve {
 public:
  // x, m, in rising order, and areas, m². Throws std::invalid_argument unless there are three or
  // more of both, x rise, and areas are finite and not negative, one of them above zero.
  TargetCurve(std::vector<double> positions, std::vector<double> areas);

  double at(double x) const;
  double aft() const { return positions_.front(); }
  double forward() const { return positions_.back(); }
  double largest() const { return largest_; }              // m²
  double largest_position() const { return largest_at_; }  // its x, m

  // Where before, or beyond, the largest area the curve has this area: the place nearest to the
  // largest one; the end where all is larger.
  double position_of(double area, bool is_fore) const;

 private:
  std::vector<double> positions_, areas_, slopes_;
  double largest_, largest_at_;
};

}  // namespace hull::modelling
