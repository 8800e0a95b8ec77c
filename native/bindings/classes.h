// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

// One function per class or group of functions, each in a file of its own. The module alone
// includes this, so that one more leaves the others as they are.
namespace hull::bindings {

void bind_tolerances(pybind11::module_& module);
void bind_control_mesh(pybind11::module_& module);
void bind_limit_surface(pybind11::module_& module);
void bind_curvature(pybind11::module_& module);
void bind_crease_curves(pybind11::module_& module);
void bind_tessellation(pybind11::module_& module);
void bind_shown_points(pybind11::module_& module);
void bind_move_watch(pybind11::module_& module);
void bind_surface_tree(pybind11::module_& module);
void bind_feature_curves(pybind11::module_& module);
void bind_appendages(pybind11::module_& module);
void bind_hull_body(pybind11::module_& module);
void bind_hydrostatics(pybind11::module_& module);
void bind_form_numbers(pybind11::module_& module);
void bind_section_areas(pybind11::module_& module);
void bind_equilibrium(pybind11::module_& module);
void bind_stability(pybind11::module_& module);
void bind_stability_criteria(pybind11::module_& module);
void bind_offset_table(pybind11::module_& module);
void bind_sections(pybind11::module_& module);
void bind_curve_fairness(pybind11::module_& module);
void bind_comb_arrays(pybind11::module_& module);
void bind_surface_fields(pybind11::module_& module);
void bind_light_lines(pybind11::module_& module);
void bind_flatness(pybind11::module_& module);
void bind_patch_set(pybind11::module_& module);
void bind_patch_body(pybind11::module_& module);
void bind_quality_report(pybind11::module_& module);
void bind_pull(pybind11::module_& module);
void bind_fit(pybind11::module_& module);
void bind_surface_places(pybind11::module_& module);
void bind_reshape(pybind11::module_& module);
void bind_shape_fields(pybind11::module_& module);
void bind_targets(pybind11::module_& module);
void bind_transformation(pybind11::module_& module);
void bind_fairing(pybind11::module_& module);
void bind_bend_sums(pybind11::module_& module);
void bind_bilge_arc(pybind11::module_& module);
void bind_knuckles(pybind11::module_& module);

}  // namespace hull::bindings
