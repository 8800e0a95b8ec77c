// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/vectors.h"

namespace hull::production {

// A polynomial on [0, 1] by its Bernstein coefficients, whose number is its degree plus one: they
// bound its values (Farin 2002, chapter 5).
using Bernstein = std::vector<double>;
using BernsteinVector = std::array<Bernstein, 3>;  // x, y, z, of one degree

Bernstein product(const Bernstein& a, const Bernstein& b);
// REQUIRES: of one degree.
Bernstein sum(const Bernstein& a, const Bernstein& b, double factor = 1.0);  // a + factor b
Bernstein dot(const BernsteinVector& a, const BernsteinVector& b);
BernsteinVector cross(const BernsteinVector& a, const BernsteinVector& b);
double value(const Bernstein& polynomial, double t);
// On [0, 1/2] and [1/2, 1] (de Casteljau).
std::array<Bernstein, 2> halves(const Bernstein& polynomial);
// Where it changes sign in [0, 1], zero counting as negative, in rising order, to rounding; pairs
// closer than 1e-12 may be missed together.
std::vector<double> sign_changes(const Bernstein& polynomial);

inline double least(const Bernstein& p) { return *std::min_element(p.begin(), p.end()); }
inline double most(const Bernstein& p) { return *std::max_element(p.begin(), p.end()); }

}  // namespace hull::production
