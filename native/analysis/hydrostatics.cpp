// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hydrostatics.h"

#include <cmath>
#include <stdexcept>

#include "analysis/immersed_integrals.h"

namespace hull {
namespace {

// Both sides from the port one: what is odd in y cancels, the rest doubles.
ImmersedIntegrals doubled(ImmersedIntegrals half) {
  half += ImmersedIntegrals(half);
  half.flux_moment.y() = 0.0;
  half.projected_moment.y() = 0.0;
  return half;
}

}  // namespace

UprightHydrostatics upright_hydrostatics(const LimitSurface& surface, double draft, bool mirrored) {
  if (!std::isfinite(draft)) throw std::invalid_argument("The draft must be a finite number.");
  ImmersedIntegrals integrals = immersed_integrals(surface, {Vector3d::UnitZ(), draft});
  if (mirrored) integrals = doubled(integrals);

  UprightHydrostatics result;
  result.draft = draft;
  result.displaced_volume = integrals.flux;
  result.volume_error = integrals.flux_error;
  result.volume_from_breadths = integrals.flux_forms.y();
  result.wetted_surface = integrals.wetted_area;
  result.wetted_surface_error = integrals.wetted_area_error;
  if (integrals.wetted_area == 0.0) return result;
  const double size = surface.mesh().size();
  if (integrals.flux < -1e-9 * size * integrals.wetted_area) {
    throw std::invalid_argument(
        "The displaced volume is negative: the faces are turned inwards. Turn them outwards, into "
        "the water.");
  }
  if (integrals.flux > 0.0) {
    const Vector3d centre = integrals.flux_moment / integrals.flux;
    result.lcb = centre.x();
    result.tcb = centre.y();
    result.kb = centre.z();
  }
  const double area = integrals.projected_area;
  result.waterplane_area = area;
  if (area > 0.0) {
    result.lcf = integrals.projected_moment.x() / area;
    result.tcf = integrals.projected_moment.y() / area;
    result.waterplane_inertia_longitudinal =
        integrals.projected_second(0, 0) - area * result.lcf * result.lcf;
    result.waterplane_inertia_transverse =
        integrals.projected_second(1, 1) - area * result.tcf * result.tcf;
  }
  if (integrals.flux > 0.0) {
    result.bm_transverse = result.waterplane_inertia_transverse / integrals.flux;
    result.bm_longitudinal = result.waterplane_inertia_longitudinal / integrals.flux;
    result.km_transverse = result.kb + result.bm_transverse;
    result.km_longitudinal = result.kb + result.bm_longitudinal;
  }
  return result;
}

}  // namespace hull
