// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace hull::analysis {

// What the 2008 IS Code (MSC.267(85)), Part A, 2.3.4, asks of a ship for her angle of roll.
struct RollingShip {
  double waterline_length = 0.0;   // Lwl, m
  double beam = 0.0;               // B, moulded, m
  double draft = 0.0;              // d, mean moulded, m
  double block_coefficient = 0.0;  // CB
  double kg = 0.0;                 // m, with the correction for free surfaces
  double gm = 0.0;                 // m, likewise
  // Ak, m²: of the bilge keels in all, or the lateral area of the bar keel, or both together.
  double keel_area = 0.0;
  bool sharp_bilges = false;     // then k = 0.7 whatever the keels
  std::optional<double> period;  // T, s; without one it is estimated
};

struct AngleOfRoll {
  double angle = 0.0;  // φ1 = 109° k X1 X2 √(r s), rad
  double k = 0.0, x1 = 0.0, x2 = 0.0;
  double r = 0.0;       // effective wave slope: 0.73 + 0.6 OG / d, OG = KG - d
  double s = 0.0;       // wave steepness, by the period
  double period = 0.0;  // T, s; estimated as 2 C B / √GM
  // A sentence if the ship is beyond those of which tables and formulae were made (2.3.5): B/d
  // below 3.5, KG/d - 1 between -0.3 and 0.5, T below 20 s. Empty else.
  std::string out_of_range;
};

// The tables 2.3.4-1 to 2.3.4-4, between their entries linear, beyond them constant: of B/d, of the
// block coefficient, of 100 Ak / (Lwl B), and of the period in s.
double roll_factor_x1(double beam_over_draft);
double roll_factor_x2(double block_coefficient);
double roll_factor_k(double keel_area_percent);
double wave_steepness(double period);

// Throws std::invalid_argument unless all lengths and the block coefficient are positive, the keel
// area is not negative, the period is positive, if given, and else GM, and OG is above -1.2 d,
// where the formula for r ends.
AngleOfRoll angle_of_roll(const RollingShip& ship);

}  // namespace hull::analysis
