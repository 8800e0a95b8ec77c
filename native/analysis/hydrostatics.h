// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/limit_surface.h"

namespace hull {

// Particulars of a hull floating upright, of both sides where half a hull was mirrored. Lengths in
// m from the after perpendicular (x = 0), the centre plane (y = 0) and the base line (z = 0).
struct UprightHydrostatics {
  double draft = 0.0;                            // of the water above the base line
  double displaced_volume = 0.0;                 // m³, moulded
  double lcb = 0.0, tcb = 0.0, kb = 0.0;         // centre of buoyancy: x, y, z
  double wetted_surface = 0.0;                   // m²
  double waterplane_area = 0.0;                  // m²
  double lcf = 0.0, tcf = 0.0;                   // centre of flotation: x, y
  double waterplane_inertia_transverse = 0.0;    // m⁴, about the fore-and-aft axis through it
  double waterplane_inertia_longitudinal = 0.0;  // m⁴, about the transverse axis through it
  double bm_transverse = 0.0, bm_longitudinal = 0.0;  // metacentric radii, m
  double km_transverse = 0.0, km_longitudinal = 0.0;  // heights of the metacentres above base, m

  // Estimates of the error of integration: m³ and m².
  double volume_error = 0.0, wetted_surface_error = 0.0;
  // The volume once more, from ∫ y n_y instead of ∫ (z - draft) n_z. It differs where the shell is
  // open below the water otherwise than across the ship or along its centre plane, and where faces
  // are turned the wrong way.
  double volume_from_breadths = 0.0;
};

// By integration over the exact surface below z = draft. Openings below the water are closed by
// vertical planes: the centre plane of a half hull (`mirrored`: half at y >= 0, doubled), an open
// transom, the end of a cut body. All zero if nothing is immersed.
//
// Throws std::invalid_argument if the draft is not finite, and if the volume comes out negative:
// the faces are turned inwards.
UprightHydrostatics upright_hydrostatics(const LimitSurface& surface, double draft, bool mirrored);

}  // namespace hull
