// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/load_case.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hull::analysis {
namespace {

void refuse_unless_positive(double value, const char* what, const char* unit) {
  if (value > 0.0 && std::isfinite(value)) return;
  std::ostringstream words;
  words << "The " << what << " must be a positive number of " << unit << ", not " << value << ".";
  throw std::invalid_argument(words.str());
}

}  // namespace

double LoadCase::displaced_volume() const {
  refuse_unless_positive(mass_t, "mass", "tonnes");
  refuse_unless_positive(water_density, "water's density", "t/m³");
  if (!centre_of_gravity.allFinite()) {
    throw std::invalid_argument("The centre of gravity must be given by three finite numbers.");
  }
  return mass_t / water_density;
}

}  // namespace hull::analysis
