// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hull_body.h"

#include <cmath>
#include <stdexcept>

#include "analysis/immersed_integrals.h"

namespace hull {
namespace {

const Vector3d kMirror(1.0, -1.0, 1.0);

Plane mirrored_plane(const Plane& plane) {
  return {plane.normal.cwiseProduct(kMirror), plane.offset};
}

ImmersedIntegrals mirrored_integrals(ImmersedIntegrals part) {
  part.flux_moment.y() *= -1.0;
  part.projected_moment.y() *= -1.0;
  part.projected_second =
      (kMirror.asDiagonal() * part.projected_second * kMirror.asDiagonal()).eval();
  return part;
}

}  // namespace

HullBody::HullBody(const LimitSurface& surface, bool mirrored)
    : surface_(&surface), mirrored_(mirrored) {
  update();
}

void HullBody::update() {}

Immersion HullBody::immersion(const Plane& water) const {
  if (!water.normal.allFinite() || !std::isfinite(water.offset)) {
    throw std::invalid_argument("The water's surface must be given by finite numbers.");
  }
  ImmersedIntegrals sum = immersed_integrals(*surface_, water);
  if (mirrored_) sum += mirrored_integrals(immersed_integrals(*surface_, mirrored_plane(water)));
  Immersion result;
  result.water = water;
  result.volume = sum.flux;
  if (sum.flux > 0.0) result.centre_of_buoyancy = sum.flux_moment / sum.flux;
  result.wetted_surface = sum.wetted_area;
  result.waterplane_area = sum.projected_area;
  if (sum.projected_area > 0.0) {
    const Vector3d centre = sum.projected_moment / sum.projected_area;
    result.centre_of_flotation = centre;
    result.waterplane_second =
        sum.projected_second - sum.projected_area * centre * centre.transpose();
  }
  result.flux_forms = sum.flux_forms;
  result.volume_error = sum.flux_error;
  result.wetted_surface_error = sum.wetted_area_error;
  return result;
}

}  // namespace hull
