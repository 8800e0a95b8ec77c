// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/derivatives/gradient.h"
#include "analysis/immersion/piece_moments.h"
#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// The numbers of an immersion whose derivatives are integrals over a span, in the order of columns.
// Positions are counted from the centre of buoyancy, those of the waterplane from the centre of
// flotation.
namespace immersed_number {
inline constexpr int kVolume = 0;
inline constexpr int kFirst = 1;  // x, y, z
inline constexpr int kWettedSurface = 4;
inline constexpr int kSubmerged = 5;  // so many are all that what is wholly below the water has
inline constexpr int kWaterplaneArea = 5;
inline constexpr int kWaterplaneFirst = 6;   // x, y, z
inline constexpr int kWaterplaneSecond = 9;  // x x, y y, z z, x y, y z, z x
inline constexpr int kCount = 15;
}  // namespace immersed_number

// A water and what its integrals are counted from.
struct ImmersionFrame {
  Plane water;
  Vector3d buoyancy, flotation;
  double zero;  // m: heights closer to the water than this are none (CutRules::zero)
};

// Adds the derivatives of the immersed numbers by the 16 points of a span. With δS the surface's
// shift and N = S_u x S_v, those of a volume ∫ f dV are ∫ f δS·N du dv over what is below the
// water, as of any body whose border moves (Hadamard); that of the wetted surface ∫ δ|N| du dv and
// what the waterline adds; and those of a waterplane's ∫ g dA are ∫ g δS·N / |h_v| du along the
// waterline, h the height above the water. REQUIRES: columns of all numbers, or, for a span that is
// below the water, of the first kSubmerged.
void add_immersion_derivatives(const surface::BicubicPoints& points, const ImmersionFrame& frame,
                               SpanRule rule, PointColumns& sum);

// Adds the derivatives, by the 16 points of a span, of the area of the section by `station` below
// the water: ∫ δS·N / |h_v| du along the section, h the height above the station's plane. `size`:
// that of the mesh, m.
void add_section_derivatives(const surface::BicubicPoints& points, const Plane& station,
                             const Plane& water, double size, PointColumns& sum);

}  // namespace hull::analysis
