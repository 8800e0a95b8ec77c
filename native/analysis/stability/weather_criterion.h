// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/stability/angle_of_roll.h"
#include "analysis/stability/criterion.h"
#include "analysis/stability/stability_criteria.h"

namespace hull::analysis {

// A part of the projected lateral area above the water: a deckhouse, deck cargo.
struct WindArea {
  double area = 0.0;  // m²
  double z = 0.0;     // m: its centre's height above the base line
};

struct WeatherOptions {
  StabilityOptions stability;
  bool hull_profile = true;          // the profile of the body above the water counts
  std::vector<WindArea> wind_areas;  // and what else there is
  // Z, m, of all areas together, where it is known otherwise than from their centres.
  std::optional<double> wind_lever;
  // Pa; for ships in restricted service the Administration may approve less.
  double wind_pressure = 504.0;
  double midship = 0.0;    // m: the x at which the mean draft is measured
  double beam = 0.0;       // B, moulded, m; 0: that of the waterline
  double keel_area = 0.0;  // Ak of RollingShip, and what follows too
  bool sharp_bilges = false;
  std::optional<double> roll_period;
};

// The ship under the wind. Angles in rad, to starboard, the wind from port; areas in m·rad. What
// could not be had has no value, and the notes of the criteria say why.
struct WeatherCriterion {
  double wind_area = 0.0;     // A, m²
  double wind_lever = 0.0;    // Z, m: from the centre of A down to that of the underwater profile
  double steady_lever = 0.0;  // lw1 = P A Z / (1000 g Δ), m
  double gust_lever = 0.0;    // lw2 = 1.5 lw1, m
  double draft = 0.0, beam = 0.0, waterline_length = 0.0, block_coefficient = 0.0;
  std::optional<AngleOfRoll> roll;
  std::optional<double> steady_heel;        // φ0, of equilibrium under lw1
  std::optional<double> windward_heel;      // φ0 - φ1
  std::optional<double> gust_heel;          // first intercept of lw2 and GZ
  std::optional<double> second_intercept;   // φc, of these two
  std::optional<double> downflooding_heel;  // φf
  std::optional<double> last_heel;          // φ2, the least of φf, 50° and φc
  std::optional<double> deck_edge_heel;
  std::optional<double> area_a, area_b;
  std::vector<Criterion> criteria;  // heel under the steady wind; area b against area a
  bool passes = false;              // both of them
  int evaluations = 0;              // immersions computed for the curve
};

// The severe wind and rolling criterion (weather criterion) of the International Code on Intact
// Stability, 2008 (IMO resolution MSC.267(85)), Part A, 2.3. A steady wind heels the ship to φ0, no
// more than 16° and 80 % of the deck edge's immersion; she rolls back by φ1 to windward (2.3.4),
// and a gust drives her to leeward. Area b, between GZ and lw2 from their first intercept to φ2,
// has to be no less than area a, between lw2 and GZ from φ0 - φ1 to that intercept. Areas of the
// exact curve, to 1e-8 m·rad.
//
// A and the centre of the underwater area are those of the exact profile at the upright position
// (lateral_profile.h). Lwl and CB = ∇ / (Lwl B d) are of that position, as is d; GM is the slope of
// GZ upright. Free surfaces are to be in the height of the centre of gravity.
//
// Throws std::invalid_argument as righting_levers() does for the load and the deck edge; for areas,
// levers and pressures that are not positive, and as angle_of_roll() does for what is given of it.
WeatherCriterion weather_criterion(const HullBody& body, const LoadCase& load,
                                   const WeatherOptions& options);

}  // namespace hull::analysis
