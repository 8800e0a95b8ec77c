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
  // Far above what rounding leaves of parallel unit vectors, far below any angle that is meant.
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
  std::vector<Vector> rests;  // of the axes
  for (Eigen::Index axis = 0; axis < size && !is_full(); ++axis) {
    rests.push_back(rest_of(Vector::Unit(size, axis)));
  }
  while (!is_full()) {
    // The longest, of equal ones the first.
    const Vector* best = &rests.front();
    for (const Vector& rest : rests) {
      if (rest.norm() > best->norm() + 1e-12) best = &rest;
    }
    found.push_back(rest_of(*best).normalized());
    for (Vector& rest : rests) rest -= found.back().dot(rest) * found.back();
  }
  return {found.begin() + held, found.end()};
}

}  // namespace hull::modelling
