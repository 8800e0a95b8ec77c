// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

// As classes.h, of the module of production.
namespace hull::bindings {

void bind_wetted_panels(pybind11::module_& module);
void bind_closed_models(pybind11::module_& module);
void bind_model_parts(pybind11::module_& module);
void bind_developable(pybind11::module_& module);
void bind_developable_rows(pybind11::module_& module);
void bind_hull_curves(pybind11::module_& module);
void bind_plates(pybind11::module_& module);

}  // namespace hull::bindings
