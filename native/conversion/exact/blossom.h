// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/pieces/bicubic.h"

namespace hull::conversion {

// Weights of a uniform cubic span's control points in its blossom f(a, b, c), the symmetric
// multiaffine form with f(t, t, t) = the curve (Ramshaw 1989); arguments counted in spans from its
// beginning. A B-spline's control point is the blossom at three successive knots.
surface::Basis blossom_weights(double a, double b, double c);

// The blossom of a bicubic span with these weights along u and v.
Vector3d blossom(const surface::BicubicPoints& points, const surface::Basis& along_u,
                 const surface::Basis& along_v);

}  // namespace hull::conversion
