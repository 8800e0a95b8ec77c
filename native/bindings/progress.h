// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "surface/progress.h"

namespace hull::bindings {

// A Python callable that takes the share, or None. It may be called where the GIL is released; what
// it raises ends the task. REQUIRES: the callable outlives the result.
inline surface::Progress progress_from(const pybind11::object& callable) {
  if (callable.is_none()) return {};
  return [handle = pybind11::handle(callable)](double share) {
    const pybind11::gil_scoped_acquire acquire;
    handle(share);
  };
}

}  // namespace hull::bindings
