// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace hull::bindings {

// Sheets of figures that are laid out in Python, and pictures of triangles for them.
void bind_figure_sheet(pybind11::module_& module);

}  // namespace hull::bindings
