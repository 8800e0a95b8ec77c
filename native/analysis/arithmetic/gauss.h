// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace hull::analysis {

// Gauss–Legendre quadrature on [0, 1]: exact for polynomials of degree 2 n - 1.
struct GaussRule {
  std::vector<double> nodes, weights;
};

// The rule of n >= 1 nodes, to rounding.
GaussRule gauss_rule(int n);

// Rules of few nodes as constants: those of gauss_rule() but for the last digit.
struct ShortGaussRule {
  int count;
  std::array<double, 4> nodes, weights;  // count of each
};

inline constexpr ShortGaussRule kTwoNodes{2, {0.2113248654051871, 0.7886751345948129}, {0.5, 0.5}};
inline constexpr ShortGaussRule kThreeNodes{
    3, {0.1127016653792583, 0.5, 0.8872983346207417}, {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0}};
inline constexpr ShortGaussRule kFourNodes{
    4,
    {0.06943184420297371, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629},
    {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693}};

}  // namespace hull::analysis
