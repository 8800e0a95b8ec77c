// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/classes.h"
#include "bindings/unmade_instances.h"

PYBIND11_MODULE(_core, module) {
  using namespace hull::bindings;
  module.doc() = "Exact hull surfaces and their analysis: the core of hull_native.";
  bind_tolerances(module);
  bind_control_mesh(module);
  bind_limit_surface(module);
  bind_curvature(module);
  bind_crease_curves(module);
  bind_tessellation(module);
  bind_shown_points(module);
  bind_move_watch(module);
  bind_surface_tree(module);
  bind_feature_curves(module);
  bind_appendages(module);
  bind_hull_body(module);
  bind_section_areas(module);
  bind_hydrostatics(module);
  bind_form_numbers(module);
  bind_equilibrium(module);
  bind_stability(module);
  bind_stability_criteria(module);
  bind_offset_table(module);
  bind_sections(module);
  bind_curve_fairness(module);
  bind_comb_arrays(module);
  bind_surface_fields(module);
  bind_light_lines(module);
  bind_flatness(module);
  bind_patch_set(module);
  bind_patch_body(module);
  bind_quality_report(module);
  bind_pull(module);
  bind_fit(module);
  bind_surface_places(module);
  bind_reshape(module);
  bind_shape_fields(module);
  bind_targets(module);
  bind_transformation(module);
  bind_fairing(module);
  bind_bend_sums(module);
  bind_bilge_arc(module);
  bind_knuckles(module);
  refuse_unmade_instances(module);
}
