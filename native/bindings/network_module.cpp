// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/companion_module.h"
#include "bindings/network_classes.h"
#include "bindings/unmade_instances.h"

PYBIND11_MODULE(_network, module) {
  using namespace hull::bindings;
  module.doc() = "Networks of curves, and the surfaces between them.";
  join_core(module);
  bind_network_curves(module);
  bind_transfinite_patch(module);
  bind_curve_network(module);
  bind_network_patches(module);
  refuse_unmade_instances(module);
}
