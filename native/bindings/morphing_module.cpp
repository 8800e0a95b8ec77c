// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/companion_module.h"
#include "bindings/morphing_classes.h"
#include "bindings/unmade_instances.h"

PYBIND11_MODULE(_morphing, module) {
  using namespace hull::bindings;
  module.doc() = "Hulls and shapes between parents.";
  join_core(module);
  bind_disc_map(module);
  bind_merged_discs(module);
  bind_hull_families(module);
  bind_hull_features(module);
  refuse_unmade_instances(module);
}
