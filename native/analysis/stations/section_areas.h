// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/immersion/floating_position.h"
#include "analysis/immersion/hull_body.h"

namespace hull::analysis {

// What of a station x = position is under water: both sides, closed by the water and, where a
// border is immersed, by straight lines athwartships, to the centre plane or to the border's other
// side. All zero where nothing is.
struct SectionArea {
  double position = 0.0;                 // x, m
  double area = 0.0;                     // m²
  Vector3d centroid = Vector3d::Zero();  // m, in the plane of the station
  double girth = 0.0;                    // wetted length of the shell's outline, m
  double breadth = 0.0;                  // length of the station's waterline, m
  double area_error = 0.0;               // estimate of the quadrature's error, m²
};

// The immersed part of a body's stations, exact but for a quadrature along the outline. The
// integral of the areas over x is the displaced volume.
//
// Where the area jumps, at a transom or another flat in the plane of the station, it is the larger
// of the two areas on either side.
//
// Throws std::invalid_argument if a position is not finite, or if the body floods.
std::vector<SectionArea> section_areas(const HullBody& body, const std::vector<double>& positions,
                                       const FloatingPosition& position);
std::vector<SectionArea> section_areas(const HullBody& body, const std::vector<double>& positions,
                                       const Plane& water);

// Throws as section_areas() does.
void check_stations(const HullBody& body, const std::vector<double>& positions, const Plane& water);

// A station takes some 50 microseconds: so many are worth a thread.
inline constexpr std::size_t kStationGrain = 2;

}  // namespace hull::analysis
