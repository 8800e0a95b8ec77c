// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hull::modelling {

// The natural cubic spline through values at stations, equally spaced; constant beyond its ends.
class StationSpline {
 public:
  // REQUIRES: as many values as stations, three or more.
  StationSpline(const std::vector<double>& stations, std::vector<double> values);

  double at(double x) const;

 private:
  double first_, spacing_;
  std::vector<double> values_;
  std::vector<double> bends_;  // second derivatives times spacing² / 6
};

}  // namespace hull::modelling
