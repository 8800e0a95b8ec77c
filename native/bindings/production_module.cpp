// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/companion_module.h"
#include "bindings/production_classes.h"
#include "bindings/unmade_instances.h"

PYBIND11_MODULE(_production, module) {
  using namespace hull::bindings;
  module.doc() = "What is built, printed and computed of a hull: models, panels.";
  join_core(module);
  bind_wetted_panels(module);
  bind_closed_models(module);
  bind_model_parts(module);
  bind_developable(module);
  bind_developable_rows(module);
  bind_hull_curves(module);
  bind_plates(module);
  refuse_unmade_instances(module);
}
