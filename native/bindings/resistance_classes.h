// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

// As classes.h, of the module of resistance.
namespace hull::bindings {

void bind_friction_line(pybind11::module_& module);
void bind_michell_integral(pybind11::module_& module);

}  // namespace hull::bindings
