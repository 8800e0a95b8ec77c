// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "analysis/derivatives/surface_adjoint.h"
#include "analysis/immersion/hull_body.h"

namespace hull::analysis {

// Derivatives of an Immersion's numbers by the control points, the water staying where it is.
// Zero where nothing is immersed; those of the centre of flotation where there is no waterplane.
struct ImmersionDerivatives {
  Gradient volume, wetted_surface, waterplane_area;
  std::array<Gradient, 3> centre_of_buoyancy, centre_of_flotation;  // of x, y and z
  // Of ∫ (q - F)(q - F)ᵀ dA: x x, y y, z z, x y, y z, z x.
  std::array<Gradient, 6> waterplane_second;
};

// What a body's integrals gain by shifts of the control points of its surface, exactly: to about
// 1e-11 of their own size with irregular points and cuts by the water, to rounding otherwise.
// Closings move along with the borders that they close (closing_derivatives.h). Of a mirrored body
// derivatives count both sides, whose points move as mirror images.
//
// Where a closing or an opening is taken in another way beyond some point, as where the border of a
// half hull leaves the centre plane, derivatives are those of the way that is taken now.
//
// What depends on topology alone is prepared once; then the body may get other points
// (HullBody::update()). Queries are thread-safe among themselves.
class BodyDerivatives {
 public:
  // `body` must outlive it.
  explicit BodyDerivatives(const HullBody& body);

  const HullBody& body() const { return *body_; }
  const SurfaceAdjoint& adjoint() const { return adjoint_; }

  // `immersion`: body().immersion(water), if it is known already. Throws as that does.
  ImmersionDerivatives immersion(const Immersion& immersion) const;

  // Of the area of a station below the water (SectionArea::area). Throws std::invalid_argument
  // where a flat of the shell or a border lies in the station's plane, as areas jump there, and for
  // a position that is not finite.
  Gradient section_area(double position, const Plane& water) const;

 private:
  PointColumns immersed_numbers(const Plane& water, const Immersion& immersion,
                                bool is_image) const;
  PointColumns section(const Plane& station, const Plane& water) const;

  const HullBody* body_;
  SurfaceAdjoint adjoint_;
};

}  // namespace hull::analysis
