// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace hull::analysis {

// The mean line of a section from (0, 0) to (1, 0).
class SectionMeanLine {
 public:
  // y = 0.
  SectionMeanLine() = default;
  // Two parabolas that meet level, `highest` above the chord at `place` (Jacobs, Ward & Pinkerton
  // 1933).
  static SectionMeanLine four_digits(double highest, double place);
  // A cubic and a straight line, or a second cubic where it is reflexed, for no moment about the
  // quarter chord: 210 to 250 or 221 to 251 by their second digit, for the lift coefficient 0.3,
  // others in proportion (Jacobs & Pinkerton 1935). REQUIRES: twentieths from 1 to 5, from 2 where
  // reflexed.
  static SectionMeanLine five_digits(double lift, int twentieths, bool is_reflexed);
  // That has the lift coefficient at its ideal angle with the load even up to x = a and falling
  // to 0 from there (Abbott & Doenhoff 1959, equations 4.26 and 4.27), a in [0, 1].
  static SectionMeanLine loaded(double lift, double a);
  // a = 0.8 as 6A-series have it: 0.97948 of it, and behind 85 % of the chord straight, but for a
  // cubic up to 90 %, as at both stations published ordinates (Loftin 1948) are 0.0006 of the lift
  // coefficient apart from being one line.
  static SectionMeanLine loaded_6a(double lift);

  bool is_straight() const { return kind_ == Kind::kStraight; }
  double height(double x) const;
  // dy/dx and d²y/dx²: where two parts meet, of that behind or before. Where the slope is infinite,
  // at 0 and, for a = 1, at 1, it is that 1e-15 of the chord beside it.
  std::array<double, 2> slopes(double x, bool behind) const;
  // Likewise for tangents of cubics: behind 1 - 1e-5 the slope is that there.
  std::array<double, 2> held_slopes(double x, bool behind) const;
  // Likewise of the line that the thickness is perpendicular to: before 0.5 % of the chord loaded
  // lines, whose slope is infinite at 0, are continued by a parabola for it.
  std::array<double, 2> perpendicular_slopes(double x, bool behind) const;
  // x where parts meet.
  std::vector<double> joints() const;

 private:
  enum class Kind { kStraight, kFourDigits, kFiveDigits, kLoaded, kLoaded6A };
  std::array<double, 2> four_digit_slopes(double x, bool behind) const;
  std::array<double, 2> five_digit_slopes(double x, bool behind) const;
  double loaded_height(double x) const;
  std::array<double, 2> loaded_slopes(double x) const;
  double bridge_height(double x) const;
  std::array<double, 2> bridge_slopes(double x) const;
  bool is_behind(double x, double joint, bool behind) const;

  Kind kind_ = Kind::kStraight;
  double size_ = 0.0;    // m; k1; the lift coefficient
  double place_ = 0.0;   // p; r; a
  double second_ = 0.0;  // k2 / k1
};

}  // namespace hull::analysis
