// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "files/atomic_file.h"

namespace hull::bindings {

// What every module beside the core needs first: the core's classes, from the same package, and
// FileError raised as OSError.
inline void join_core(pybind11::module_& module) {
  const auto full_name = module.attr("__name__").cast<std::string>();
  pybind11::module_::import((full_name.substr(0, full_name.rfind('.') + 1) + "_core").c_str());
  pybind11::register_local_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const files::FileError& failure) {
      PyErr_SetString(PyExc_OSError, failure.what());
    }
  });
}

}  // namespace hull::bindings
