// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/companion_module.h"
#include "bindings/resistance_classes.h"
#include "bindings/unmade_instances.h"

PYBIND11_MODULE(_resistance, module) {
  using namespace hull::bindings;
  module.doc() = "Resistance of hulls.";
  join_core(module);
  bind_friction_line(module);
  bind_michell_integral(module);
  refuse_unmade_instances(module);
}
