// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace hull::modelling {

// Gauss's points and weights on [0, 1].
struct GaussRule {
  int count;
  std::array<double, 3> points, weights;
};

inline constexpr GaussRule kThreePoints{
    3, {0.1127016653792583, 0.5, 0.8872983346207417}, {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0}};
inline constexpr GaussRule kTwoPoints{
    2, {0.2113248654051871, 0.7886751345948129, 0.0}, {0.5, 0.5, 0.0}};

}  // namespace hull::modelling
