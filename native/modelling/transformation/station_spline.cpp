// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/station_spline.h"

#include <cstddef>
#include <utility>

#include "analysis/arithmetic/tridiagonal.h"

namespace hull::modelling {

StationSpline::StationSpline(const std::vector<double>& stations, std::vector<double> values)
    : first_(stations.front()),
      spacing_((stations.back() - stations.front()) / static_cast<double>(stations.size() - 1)),
      values_(std::move(values)),
      bends_(values_.size(), 0.0) {
  // bends[i-1] + 4 bends[i] + bends[i+1] is the second difference; zero at both ends.
  const std::size_t inner = values_.size() - 2;
  const analysis::Tridiagonal rows{std::vector<double>(inner, 1.0), std::vector<double>(inner, 4.0),
                                   std::vector<double>(inner, 1.0)};
  // The solver is one of vectors: the values are their first coordinates.
  std::vector<Vector3d> right(inner, Vector3d::Zero());
  for (std::size_t i = 0; i < inner; ++i) {
    right[i].x() = values_[i] - 2.0 * values_[i + 1] + values_[i + 2];
  }
  right = rows.solve(std::move(right));
  for (std::size_t i = 0; i < inner; ++i) bends_[i + 1] = right[i].x();
}

double StationSpline::at(double x) const {
  const double along = (x - first_) / spacing_, last = static_cast<double>(values_.size() - 1);
  if (!(along > 0.0)) return values_.front();
  if (along >= last) return values_.back();
  const auto i = static_cast<std::size_t>(along);
  const double t = along - static_cast<double>(i), s = 1.0 - t;
  return s * values_[i] + t * values_[i + 1] + (s * s * s - s) * bends_[i] +
         (t * t * t - t) * bends_[i + 1];
}

}  // namespace hull::modelling
