// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/angle_of_roll.h"

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "analysis/arithmetic/degree.h"

namespace hull::analysis {
namespace {

struct Entry {
  double at, value;
};

template <std::size_t N>
double interpolated(const std::array<Entry, N>& table, double at) {
  // Beyond its ends a table is constant: the code's first and last entries are meant so.
  if (at <= table.front().at) return table.front().value;
  for (std::size_t i = 1; i < N; ++i) {
    const Entry &a = table[i - 1], &b = table[i];
    if (at <= b.at) return a.value + (b.value - a.value) * ((at - a.at) / (b.at - a.at));
  }
  return table.back().value;
}

// The code leaves out B/d = 3.3, for which its forerunner, resolution A.562(14), has 0.84: what
// interpolation gives.
constexpr std::array<Entry, 11> kX1{{{2.4, 1.0},
                                     {2.5, 0.98},
                                     {2.6, 0.96},
                                     {2.7, 0.95},
                                     {2.8, 0.93},
                                     {2.9, 0.91},
                                     {3.0, 0.90},
                                     {3.1, 0.88},
                                     {3.2, 0.86},
                                     {3.4, 0.82},
                                     {3.5, 0.80}}};
// Table 2.3.4-2, by the block coefficient.
constexpr std::array<Entry, 6> kX2{
    {{0.45, 0.75}, {0.50, 0.82}, {0.55, 0.89}, {0.60, 0.95}, {0.65, 0.97}, {0.70, 1.0}}};
// Table 2.3.4-3, by 100 Ak / (Lwl B).
constexpr std::array<Entry, 8> kK{{{0.0, 1.0},
                                   {1.0, 0.98},
                                   {1.5, 0.95},
                                   {2.0, 0.88},
                                   {2.5, 0.79},
                                   {3.0, 0.74},
                                   {3.5, 0.72},
                                   {4.0, 0.70}}};
// Table 2.3.4-4, by the period in s.
constexpr std::array<Entry, 8> kS{{{6.0, 0.100},
                                   {7.0, 0.098},
                                   {8.0, 0.093},
                                   {12.0, 0.065},
                                   {14.0, 0.053},
                                   {16.0, 0.044},
                                   {18.0, 0.038},
                                   {20.0, 0.035}}};
constexpr double kSharpBilges = 0.7;

void refuse(const std::string& what, double value, const char* unit) {
  std::ostringstream words;
  words << "The angle of roll needs " << what << "; it is " << value << unit << ".";
  throw std::invalid_argument(words.str());
}

void check(const RollingShip& ship) {
  const auto positive = [](double value, const char* what, const char* unit) {
    if (!(value > 0.0) || !std::isfinite(value)) refuse(what, value, unit);
  };
  positive(ship.waterline_length, "a positive length of the waterline", " m");
  positive(ship.beam, "a positive beam", " m");
  positive(ship.draft, "a positive mean draft", " m");
  positive(ship.block_coefficient, "a positive block coefficient", "");
  if (!(ship.keel_area >= 0.0) || !std::isfinite(ship.keel_area)) {
    refuse("an area of bilge and bar keels that is not negative", ship.keel_area, " m²");
  }
  if (ship.period) {
    positive(*ship.period, "a positive period of roll", " s");
  } else {
    positive(ship.gm, "a positive GM to estimate the period of roll, or that period", " m");
  }
  if (!std::isfinite(ship.kg)) refuse("a height of the centre of gravity", ship.kg, " m");
}

double estimated_period(const RollingShip& ship) {
  const double c =
      0.373 + 0.023 * (ship.beam / ship.draft) - 0.043 * (ship.waterline_length / 100.0);
  // Of ships of more than some 900 m the estimate of the radius of gyration has no meaning.
  if (c <= 0.0) {
    refuse("a given period of roll for so long a ship: the code estimates none", c, "");
  }
  return 2.0 * c * ship.beam / std::sqrt(ship.gm);
}

std::string beyond_the_tables(const RollingShip& ship, double period) {
  std::ostringstream words;
  const char* next = "";
  const auto add = [&](const char* name, double value, const char* range) {
    words << next << name << " is " << value << ", not " << range;
    next = "; ";
  };
  words.precision(3);
  // KG / d - 1 is OG / d, as the code writes it in 2.3.5.
  const double breadth = ship.beam / ship.draft, height = ship.kg / ship.draft - 1.0;
  if (!(breadth < 3.5)) add("B/d", breadth, "below 3.5");
  if (!(height > -0.3 && height < 0.5)) add("KG/d - 1", height, "between -0.3 and 0.5");
  if (!(period < 20.0)) add("T", period, "below 20 s");
  if (words.str().empty()) return {};
  return "The code's angle of roll is not meant for this ship (2.3.5): " + words.str() +
         ". Model tests by MSC.1/Circ.1200 may take its place.";
}

}  // namespace

double roll_factor_x1(double beam_over_draft) { return interpolated(kX1, beam_over_draft); }
double roll_factor_x2(double block_coefficient) { return interpolated(kX2, block_coefficient); }
double roll_factor_k(double keel_area_percent) { return interpolated(kK, keel_area_percent); }
double wave_steepness(double period) { return interpolated(kS, period); }

AngleOfRoll angle_of_roll(const RollingShip& ship) {
  check(ship);
  AngleOfRoll roll;
  roll.x1 = roll_factor_x1(ship.beam / ship.draft);
  roll.x2 = roll_factor_x2(ship.block_coefficient);
  roll.k = ship.sharp_bilges
               ? kSharpBilges
               : roll_factor_k(100.0 * ship.keel_area / (ship.waterline_length * ship.beam));
  roll.period = ship.period ? *ship.period : estimated_period(ship);
  roll.s = wave_steepness(roll.period);
  // OG = KG - d is negative where the centre of gravity is under water.
  roll.r = 0.73 + 0.6 * (ship.kg - ship.draft) / ship.draft;
  if (!(roll.r > 0.0)) {
    refuse("a centre of gravity no lower than 1.2 drafts below the water: r is positive there",
           roll.r, "");
  }
  roll.angle = 109.0 * kDegree * roll.k * roll.x1 * roll.x2 * std::sqrt(roll.r * roll.s);
  roll.out_of_range = beyond_the_tables(ship, roll.period);
  return roll;
}

}  // namespace hull::analysis
