// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/move_watch.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "bindings/arrays.h"
#include "bindings/planes.h"

namespace hull::bindings {
namespace {

py::array_t<bool> comes_near(const analysis::MoveWatch& watch, const DoubleArray& planes,
                             double margin) {
  if (!(margin >= 0.0) || !std::isfinite(margin)) {
    throw std::invalid_argument("A margin is a length of 0 m or more, not " +
                                std::to_string(margin) + " m.");
  }
  const std::vector<analysis::Plane> all = planes_from(planes);
  py::array_t<bool> flags(static_cast<py::ssize_t>(all.size()));
  bool* out = flags.mutable_data();
  for (const analysis::Plane& plane : all) *out++ = watch.comes_near(plane, margin);
  return flags;
}

}  // namespace

void bind_move_watch(py::module_& module) {
  py::class_<analysis::MoveWatch>(
      module, "MoveWatch",
      "Where a surface was and is that has moved last: sections by planes that do not come near "
      "need not be cut again. They are what a new cut would give, as long as it is cut to the same "
      "tolerances.")
      .def(py::init<const surface::LimitSurface&>(), py::arg("surface"), py::keep_alive<1, 2>(),
           "Nothing has moved yet.")
      .def("update", &analysis::MoveWatch::update, py::call_guard<py::gil_scoped_release>(),
           "After surface.set_points(): what has moved since the last update, or the beginning, is "
           "what counts from now on. Until then comes_near() and cells raise ValueError.")
      .def("comes_near", &comes_near, py::arg("planes"), py::kw_only(), py::arg("margin"),
           "planes: (n, 4), as for sections(). Returns (n,): whether a cell that has moved comes, "
           "or came, nearer to the plane than margin, m. True of all planes where the size of the "
           "mesh has changed, of which the rounding of a section is a part.")
      .def_property_readonly(
          "cells", [](const analysis::MoveWatch& watch) { return to_array(watch.cells()); },
          "(k,) the cells that have moved, in order.");
}

}  // namespace hull::bindings
