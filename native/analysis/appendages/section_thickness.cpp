// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/section_thickness.h"

#include <Eigen/Dense>
#include <cmath>

#include "analysis/appendages/section_tables.h"

namespace hull::analysis {
namespace {

constexpr double kFormulaThickness = 0.2;  // of the published polynomials
constexpr double kNose = 0.2969;
// Slope at the trailing edge by tenths of the chord where the thickness is largest, from 2.
constexpr std::array<double, 5> kTailSlopes{0.200, 0.234, 0.315, 0.465, 0.700};
constexpr double kTail = 0.002;
constexpr double kBluntTail = 0.0105;  // of the thickness, of four digits
constexpr int kUsualNose = 6, kBluntNose = 9;

using Powers = std::array<double, 9>;

Powers times(Powers factors, double by) {
  for (double& factor : factors) factor *= by;
  return factors;
}

double knot(int i) { return std::sqrt(kTableX[i]); }

// Slopes of the natural cubic spline through values at the stations, by √x.
std::array<double, kTableStations> spline_slopes(const std::array<double, kTableStations>& values) {
  const int n = kTableStations;
  std::array<double, kTableStations> diagonal{}, right{}, slopes{}, upper{};
  for (int i = 0; i < n; ++i) {
    const double before = i > 0 ? 1.0 / (knot(i) - knot(i - 1)) : 0.0;
    const double after = i + 1 < n ? 1.0 / (knot(i + 1) - knot(i)) : 0.0;
    // Second derivatives are equal on both sides of a station, and zero at the first and the last.
    diagonal[i] = 2.0 * (before + after);
    upper[i] = after;
    if (i > 0) right[i] += 3.0 * before * before * (values[i] - values[i - 1]);
    if (i + 1 < n) right[i] += 3.0 * after * after * (values[i + 1] - values[i]);
  }
  // Thomas' algorithm on a symmetric matrix: below[i] is upper[i - 1].
  for (int i = 1; i < n; ++i) {
    const double factor = upper[i - 1] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (int i = n - 1; i >= 0; --i) {
    slopes[i] = (right[i] - (i + 1 < n ? upper[i] * slopes[i + 1] : 0.0)) / diagonal[i];
  }
  return slopes;
}

// s (a + m u + c u² + d u³) with u = s - from, in powers of s.
Powers times_root(double from, double a, double m, double c, double d) {
  return {0.0, a - from * (m - from * (c - from * d)), m - from * (2.0 * c - 3.0 * from * d),
          c - 3.0 * from * d, d};
}

}  // namespace

SectionThickness SectionThickness::four_digits(double thickness) {
  const Powers factors{0.0, kNose, -0.1260, 0.0, -0.3516, 0.0, 0.2843, 0.0, -0.1015};
  return SectionThickness({{1.0, times(factors, thickness / kFormulaThickness)}},
                          kBluntTail * thickness);
}

SectionThickness SectionThickness::modified(double thickness, int nose, int tenths) {
  const double place = 0.1 * tenths, rest = 1.0 - place, highest = 0.5 * kFormulaThickness;
  // Behind: d0 + d1 (1 - x) + d2 (1 - x)² + d3 (1 - x)³, level at the largest thickness.
  const double d1 = kTailSlopes[tenths - 2];
  const double d3 = (rest * d1 - 2.0 * (highest - kTail)) / (rest * rest * rest);
  const double d2 = (highest - kTail - rest * d1) / (rest * rest) - rest * d3;
  // Before: a0 √x + a1 x + a2 x² + a3 x³, as high, level and curved there.
  // The radius goes with a0², and an index of 9 stands for three times that of 6.
  const double a0 = kNose * (nose == kBluntNose ? std::sqrt(3.0) : nose / double{kUsualNose});
  const double root = std::sqrt(place);
  // Rows: height, slope and second derivative at the largest thickness.
  const Eigen::Matrix3d powers{{place, place * place, place * place * place},
                               {1.0, 2.0 * place, 3.0 * place * place},
                               {0.0, 2.0, 6.0 * place}};
  const Eigen::Vector3d wanted(highest - a0 * root, -0.5 * a0 / root,
                               2.0 * d2 + 6.0 * d3 * rest + 0.25 * a0 / (root * place));
  const Eigen::Vector3d a = powers.partialPivLu().solve(wanted);
  const Powers before{0.0, a0, a[0], 0.0, a[1], 0.0, a[2]};
  const Powers behind{
      kTail + d1 + d2 + d3, 0.0, -d1 - 2.0 * d2 - 3.0 * d3, 0.0, d2 + 3.0 * d3, 0.0, -d3};
  const double factor = thickness / kFormulaThickness;
  return SectionThickness({{root, times(before, factor)}, {1.0, times(behind, factor)}},
                          kTail * factor);
}

SectionThickness SectionThickness::series(int family, bool is_6a, double thickness) {
  const std::array<double, kTableStations> ratios = series_ratios(family, is_6a, thickness);
  const std::array<double, kTableStations> slopes = spline_slopes(ratios);
  std::vector<Piece> pieces;
  for (int i = 0; i + 1 < kTableStations; ++i) {
    const double h = knot(i + 1) - knot(i), rise = (ratios[i + 1] - ratios[i]) / h;
    pieces.push_back({knot(i + 1), times_root(knot(i), ratios[i], slopes[i],
                                              (3.0 * rise - 2.0 * slopes[i] - slopes[i + 1]) / h,
                                              (slopes[i] + slopes[i + 1] - 2.0 * rise) / (h * h))});
  }
  return SectionThickness(std::move(pieces), ratios.back());
}

std::array<double, 2> SectionThickness::at(double s) const {
  std::size_t i = 0;
  while (i + 1 < pieces_.size() && pieces_[i].end < s) ++i;
  double y = 0.0, slope = 0.0;
  // By nested multiplication, the derivative along with the value.
  for (std::size_t k = pieces_[i].factors.size(); k-- > 0;) {
    slope = slope * s + y;
    y = y * s + pieces_[i].factors[k];
  }
  return {s == 1.0 ? tail_ : y, slope};
}

std::vector<double> SectionThickness::knots() const {
  std::vector<double> all{0.0};
  for (const Piece& piece : pieces_) all.push_back(piece.end);
  return all;
}

}  // namespace hull::analysis
