// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/cad_options.h"

#include <stdexcept>

namespace hull::exchange {
namespace {

struct UnitEntry {
  CadUnit unit;
  const char* name;
  double millimetres;
};

constexpr UnitEntry kUnits[] = {{CadUnit::kMetre, "m", 1000.0},
                                {CadUnit::kCentimetre, "cm", 10.0},
                                {CadUnit::kMillimetre, "mm", 1.0},
                                {CadUnit::kFoot, "ft", 304.8},
                                {CadUnit::kInch, "in", 25.4}};

const UnitEntry& entry_of(CadUnit unit) {
  for (const UnitEntry& entry : kUnits) {
    if (entry.unit == unit) return entry;
  }
  return kUnits[0];
}

}  // namespace

CadUnit cad_unit_from(const std::string& name) {
  for (const UnitEntry& entry : kUnits) {
    if (name == entry.name) return entry.unit;
  }
  throw std::invalid_argument("unit must be \"m\", \"cm\", \"mm\", \"ft\" or \"in\", not \"" +
                              name + "\".");
}

std::string name_of(CadUnit unit) { return entry_of(unit).name; }

double millimetres_in(CadUnit unit) { return entry_of(unit).millimetres; }

}  // namespace hull::exchange
