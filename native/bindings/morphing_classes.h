// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

// As classes.h, of the module of morphing.
namespace hull::bindings {

void bind_disc_map(pybind11::module_& module);
void bind_merged_discs(pybind11::module_& module);
void bind_hull_families(pybind11::module_& module);
void bind_hull_features(pybind11::module_& module);

}  // namespace hull::bindings
