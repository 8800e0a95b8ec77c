// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/developable/bezier_chain.h"

namespace hull::production {

// The warp of a ruling of (1 - v) a(t) + v b(t): the angle between the surface's normals at its two
// ends, rad, divided by its length, rad/m. It is zero all along just where the surface is
// developable. With q = b - a the normals are a' x q and b' x q, whose product is q det(a', b', q).
// Infinite where the ruling has no length; where it runs along an edge the angle is undefined.
double warp_at(const BezierSpan& a, const BezierSpan& b, double t);

struct LargestWarp {
  double found;  // the largest warp that was met, rad/m …
  double at;     // … and where
  double bound;  // no ruling has more, rad/m
};

// Of all rulings, the bound within a part `tolerance` of what was found, if there is one: by the
// Bernstein coefficients of det(a', b', q), of degree 7, and of the normals' squares and product,
// of degree 10, on parts that are halved where the bound is largest. Infinite where a ruling has no
// length or runs along an edge.
LargestWarp largest_warp(const BezierSpan& a, const BezierSpan& b, double tolerance = 1e-3);

}  // namespace hull::production
