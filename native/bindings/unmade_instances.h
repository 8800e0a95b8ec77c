// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace hull::bindings {

// Instances of a Python subclass whose `__init__` does not call, or has not yet called, that of the
// bound class, and those of `cls.__new__(cls)`, hold no C++ object. Makes every use of one, of any
// class that the module holds, as self or as argument, raise TypeError. To be called when all
// classes are bound.
void refuse_unmade_instances(pybind11::module_& module);

}  // namespace hull::bindings
