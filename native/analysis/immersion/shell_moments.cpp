// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/shell_moments.h"

#include <array>

namespace hull::analysis {
namespace {

// The two factors of each product of ShellMoments::second.
constexpr std::array<std::array<int, 2>, 6> kFactors{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};

}  // namespace

ShellMoments& ShellMoments::operator+=(const ShellMoments& other) {
  area += other.area;
  area_error += other.area_error;
  volume_error += other.volume_error;
  normal += other.normal;
  first += other.first;
  second += other.second;
  return *this;
}

ShellMoments& ShellMoments::operator*=(double factor) {
  area *= factor;
  area_error *= factor;
  volume_error *= factor;
  normal *= factor;
  first *= factor;
  second *= factor;
  return *this;
}

Eigen::Matrix3d ShellMoments::second_along(const Vector3d& e) const {
  const Eigen::Matrix<double, 6, 1> s = second * e;
  Eigen::Matrix3d result;
  result << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return result;
}

ShellMoments moved(const ShellMoments& moments, const Vector3d& shift) {
  ShellMoments result = moments;
  // With t the shift, (p + t)(p + t)ᵀ = p pᵀ + t pᵀ + p tᵀ + t tᵀ, of each product.
  result.first += shift * moments.normal.transpose();
  for (int k = 0; k < 6; ++k) {
    const auto [i, j] = kFactors[k];
    result.second.row(k) += shift[i] * moments.first.row(j) + shift[j] * moments.first.row(i) +
                            shift[i] * shift[j] * moments.normal.transpose();
  }
  return result;
}

ShellMoments mirrored(const ShellMoments& moments) {
  // Each y in a product changes its sign, that of the normal too.
  const Vector3d mirror(1.0, -1.0, 1.0);
  ShellMoments result = moments;
  result.normal = mirror.cwiseProduct(moments.normal);
  result.first = mirror.asDiagonal() * moments.first * mirror.asDiagonal();
  for (int k = 0; k < 6; ++k) {
    const auto [i, j] = kFactors[k];
    result.second.row(k) = mirror[i] * mirror[j] * moments.second.row(k) * mirror.asDiagonal();
  }
  return result;
}

}  // namespace hull::analysis
