// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace hull::bindings {

// Plots, their layout and their files.
void bind_plot(pybind11::module_& module);

}  // namespace hull::bindings
