// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/immersion/floating_position.h"
#include "analysis/immersion/hull_body.h"
#include "analysis/immersion/sea_water.h"
#include "analysis/stations/kept_stations.h"

namespace hull::analysis {

// The ship's dimensions that coefficients refer to, m. Midship is at x = length_pp / 2. A zero
// means "not given".
struct ProjectDimensions {
  double length_pp = 0.0;
  double beam = 0.0;
  double draft = 0.0;  // not given: the draft of the floating position
};

// Coefficients of form on some length L, beam B, draft T and section area A; ∇ the displaced
// volume, Awp the waterplane area. Zero where a dimension is not given or nothing is immersed.
struct FormCoefficients {
  double block = 0.0;               // Cb = ∇ / (L B T)
  double prismatic = 0.0;           // Cp = ∇ / (A L)
  double midship = 0.0;             // Cm = A / (B T)
  double waterplane = 0.0;          // Cwp = Awp / (L B)
  double vertical_prismatic = 0.0;  // Cvp = ∇ / (Awp T)
};

// Hydrostatics of a body in water, of both sides where half a hull was mirrored. Positions are x, y
// and z in the ship's axes: from the after perpendicular, the centre plane and the base line.
// Lengths, beams and drafts of what is under water are measured level along the ship, level
// across it, and straight down. What is undefined because nothing is immersed, because there is no
// waterplane or because a dimension is not given, is zero.
struct Hydrostatics {
  FloatingPosition position;
  double draft = 0.0;  // that of the position, m

  double displaced_volume = 0.0;          // m³, moulded
  double displacement_t = 0.0;            // t, volume times density
  double lcb = 0.0, tcb = 0.0, kb = 0.0;  // centre of buoyancy
  double wetted_surface = 0.0;            // m², of the shell alone

  double waterplane_area = 0.0;                       // m²
  double lcf = 0.0, tcf = 0.0;                        // centre of flotation F: x, y
  double waterplane_inertia_transverse = 0.0;         // m⁴, about the fore-and-aft axis through F
  double waterplane_inertia_longitudinal = 0.0;       // m⁴, about the transverse axis through F
  double waterplane_inertia_product = 0.0;            // m⁴, of distances forward and to port
  double bm_transverse = 0.0, bm_longitudinal = 0.0;  // metacentric radii, m
  double km_transverse = 0.0, km_longitudinal = 0.0;  // z of the metacentres, m

  double lcb_percent = 0.0, lcf_percent = 0.0;  // of length_pp, forward of midship
  double tpc = 0.0;                             // t/cm: displacement for 1 cm of sinkage
  double mtc = 0.0;  // t·m/cm: moment to change trim by 1 cm over length_pp; BMl stands for GMl

  double waterline_length = 0.0,
         waterline_beam = 0.0;  // Lwl, Bwl: extents of the shell's waterline
  double waterline_aft = 0.0, waterline_forward = 0.0;  // x of the waterline's ends
  double immersed_length = 0.0, immersed_beam = 0.0;    // extents of the immersed shell
  double immersed_draft = 0.0;                          // depth of its lowest point

  SectionArea midship_section;  // at length_pp / 2
  SectionArea largest_section;

  FormCoefficients project;   // on the project's dimensions and the midship section
  FormCoefficients immersed;  // on immersed length, beam and draft and the largest section

  // Between the centre plane and the waterline's tangent at its forward end, rad: 90° where the
  // waterline is round or flat there. Both angles are zero when heeled: the sides differ.
  double half_angle_of_entrance = 0.0;
  // The same of the chord from the forward end to the half breadth 5 % of Lwl abaft it, for bows
  // that are round in the small but fine as a whole.
  double entrance_chord_angle = 0.0;

  double lateral_area = 0.0;                // m², of the underwater profile; see profile_area.h
  double lateral_x = 0.0, lateral_z = 0.0;  // its centre
  double wind_area = 0.0;                   // m², of the profile above the water
  double wind_x = 0.0, wind_z = 0.0;        // its centre

  double volume_error = 0.0, wetted_surface_error = 0.0;  // estimates of the quadrature: m³, m²
  // The volume once more, from ∫ y n_y. Upright, it differs where the shell is open below the water
  // otherwise than across the ship or along its centre plane, and where faces are turned inwards.
  double volume_from_breadths = 0.0;
};

// Throws std::invalid_argument if a number is not finite, trim is 90° or more, a dimension is
// negative or the density is not positive, and as HullBody::immersion() does; and for stations that
// are kept of another body.
Hydrostatics hydrostatics(const HullBody& body, const FloatingPosition& position,
                          const ProjectDimensions& project, double water_density = kSeaWaterDensity,
                          KeptStations* kept = nullptr);

// A table: one row per draft for the first trim, then for the next; drafts measured at the midship
// of the project.
std::vector<Hydrostatics> hydrostatic_table(const HullBody& body, const std::vector<double>& drafts,
                                            const std::vector<double>& trims,
                                            const ProjectDimensions& project,
                                            double water_density = kSeaWaterDensity);

// For a single upright draft, without project dimensions. `mirrored`: as for HullBody.
Hydrostatics upright_hydrostatics(const surface::LimitSurface& surface, double draft,
                                  bool mirrored);

}  // namespace hull::analysis
