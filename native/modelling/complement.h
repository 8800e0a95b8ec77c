// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull::modelling {

// Orthonormal vectors that span all that is square to the given ones, along the axes where they can
// be, so that axes stay axes where what is given is square to them. Of the given ones, of any
// length but zero, those closer than 1e-9 (sine of the angle) to what others span are none.
template <class Vector>
std::vector<Vector> complement(const std::vector<Vector>& given, Eigen::Index size) {
  constexpr double kSameDirection = 1e-9;
  std::vector<Vector> found;  // first what spans the given ones
  const auto rest_of = [&](Vector v) {
    // Twice: once leaves rounding of what was nearly parallel.
    for (int pass = 0; pass < 2; ++pass) {
      for (const Vector& other : found) v -= other.dot(v) * other;
    }
    return v;
  };
  const auto is_full = [&] { return static_cast<Eigen::Index>(found.size()) == size; };
  for (const Vector& vector : given) {
    const Vector rest = rest_of(vector.normalized());
    if (!is_full() && rest.norm() > kSameDirection) found.push_back(rest.normalized());
  }
  const auto held = static_cast<std::ptrdiff_t>(found.size());
  while (!is_full()) {
    // Of the axes' rests the longest.
    Vector best = Vector::Zero(size);
    for (Eigen::Index axis = 0; axis < size; ++axis) {
      const Vector rest = rest_of(Vector::Unit(size, axis));
      if (rest.norm() > best.norm() + 1e-12) best = rest;
    }
    found.push_back(best.normalized());
  }
  return {found.begin() + held, found.end()};
}

}  // namespace hull::modelling
