// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/patches/bspline_patch.h"

namespace hull::conversion {

struct SurfaceIntegrals {
  double area = 0.0;    // m²
  double volume = 0.0;  // m³, of the cone from the origin: a third of ∫ p · n dS

  SurfaceIntegrals& operator+=(const SurfaceIntegrals& other) {
    area += other.area;
    volume += other.volume;
    return *this;
  }
};

// Of a whole patch, by a Gauss rule in every span, of five nodes each way or more where spans are
// not very small: the volume is that of a bicubic patch to 1e-12, the area's error falls with the
// tenth power of the spans' size.
SurfaceIntegrals integrals_of(const BSplinePatch& patch);

}  // namespace hull::conversion
