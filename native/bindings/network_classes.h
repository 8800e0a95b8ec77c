// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

// As classes.h, of the module of networks of curves.
namespace hull::bindings {

void bind_network_curves(pybind11::module_& module);
void bind_transfinite_patch(pybind11::module_& module);
void bind_curve_network(pybind11::module_& module);
void bind_network_patches(pybind11::module_& module);

}  // namespace hull::bindings
