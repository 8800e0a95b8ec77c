// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace hull::analysis {

// A section of unit chord, leading edge at (0, 0), trailing edge at (1, 0).
//
// The thickness is that of NACA's families:
//   four and five digits: y = t / 0.2 (0.2969 √x - 0.1260 x - 0.3516 x² + 0.2843 x³ - 0.1015 x⁴)
//     (Jacobs, Ward & Pinkerton, NACA Report 460; Jacobs & Pinkerton, NACA Report 537), whose
//     trailing edge is 0.0105 t thick on each side;
//   63-0tt, 64-0tt, 65-0tt: the spline through the published ordinates of 12 % thickness (Abbott,
//     von Doenhoff & Stivers, NACA Report 824), y / √x by cubics in √x, to other thicknesses in
//     proportion. Published ordinates of these differ from that by some thousandths of the
//     thickness.
// It is laid out perpendicular to the mean line of the first four families: y = 0 or two parabolas
// (four digits), a cubic and a straight line (five digits); 6-series symmetric only.
class SectionForm {
 public:
  // "2412", "0012", "23012", "63-012", "64-015", "65-010"; with "NACA " before it or without.
  // Throws std::invalid_argument for what is no such name.
  explicit SectionForm(const std::string& name);

  const std::string& name() const { return name_; }
  // Largest thickness of the family, of the chord.
  double thickness() const { return thickness_; }
  bool is_symmetric() const { return camber_ == Camber::kNone; }
  // Half thickness at x in [0, 1] of the mean line, of the chord.
  double half_thickness(double x) const;
  double mean_line(double x) const;

  // A point of the outline at x = s² of the mean line, and its derivative by s: of the upper side
  // (1) or the lower one (-1), thickness times a factor. At the place where two mean lines meet,
  // the derivative is that of the part behind or before it.
  struct Point {
    Eigen::Vector2d place, slope;
  };
  Point outline(double s, int side, double factor, bool behind) const;
  // s from 0 to 1, between which cubics follow the outline within 1e-6 of the chord.
  std::vector<double> knots() const;

 private:
  enum class Camber { kNone, kFourDigits, kFiveDigits };
  void read(const std::string& digits);
  // Mean line's slope and its derivative.
  std::array<double, 2> mean_slopes(double x, bool behind) const;
  // Half thickness and its derivative by √x.
  std::array<double, 2> thickness_and_slope(double s) const;
  std::array<double, 2> table_ratio_at(double s) const;

  std::string name_;
  double thickness_ = 0.0;
  int series_ = 0;              // 63, 64, 65; 0: polynomial
  std::vector<double> slopes_;  // of the table's spline
  Camber camber_ = Camber::kNone;
  double camber_size_ = 0.0, camber_place_ = 0.0;  // m, p; k1, r
};

}  // namespace hull::analysis
