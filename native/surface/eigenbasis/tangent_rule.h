// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/eigenbasis/dominant_spectrum.h"

namespace hull::surface {

// How the tangent plane at an irregular corner follows from the dominant coordinates x of its
// neighbourhood: it is spanned by a^T x and b^T x, whose cross product, times sign, is the outward
// normal's direction.
struct TangentRule {
  bool defined = false;
  Eigen::VectorXd a, b;  // weights of the dominant coordinates (m)
  double sign = 1.0;
};

// From the spectrum of a ring's matrix (points in the order of ring_points()). The two leading
// modes after the constant one map the ring's rays to the tangent plane. There is none if the modes
// are not two, or if they fold the sector or collapse a ray: under Catmull–Clark's rules crease
// sectors of valence 4 and more and corner sectors of 2 and more.
TangentRule tangent_rule(const DominantSpectrum& spectrum);

}  // namespace hull::surface
