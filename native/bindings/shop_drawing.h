// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace hull::bindings {

void bind_shop_drawing(pybind11::module_& module);

}  // namespace hull::bindings
