// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace hull::bindings {

// read_cad_geometry().
void bind_cad_geometry(pybind11::module_& module);

}  // namespace hull::bindings
