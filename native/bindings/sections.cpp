// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/sections.h"

#include <pybind11/stl.h>

#include <stdexcept>
#include <string>

#include "bindings/arrays.h"
#include "bindings/classes.h"

namespace hull::bindings {
namespace {

Axis axis_from(const std::string& name) {
  if (name == "x") return Axis::kX;
  if (name == "y") return Axis::kY;
  if (name == "z") return Axis::kZ;
  throw std::invalid_argument("axis is \"x\", \"y\" or \"z\", not \"" + name + "\".");
}

}  // namespace

void bind_sections(py::module_& module) {
  py::class_<SectionCurve>(module, "SectionCurve", "One branch of a plane section.")
      .def_property_readonly(
          "points", [](const SectionCurve& c) { return to_array(c.points); },
          "(k, 3), m, in order; the first is repeated at the end of a closed curve.")
      .def_property_readonly(
          "cells", [](const SectionCurve& c) { return to_array(c.cells); }, "(k,).")
      .def_property_readonly(
          "uv", [](const SectionCurve& c) { return to_array(c.uv); }, "(k, 2).")
      .def_property_readonly(
          "knuckles", [](const SectionCurve& c) { return to_array(c.knuckles); },
          "(n,) indices of the points on creases.")
      .def_readonly("closed", &SectionCurve::closed);
  module.def(
      "section",
      [](const LimitSurface& surface, const std::string& axis, double position,
         const std::optional<double>& chord_tolerance) {
        const Axis chosen = axis_from(axis);
        const py::gil_scoped_release release;
        return section(surface, chosen, position,
                       chord_tolerance.value_or(1e-5 * surface.mesh().size()));
      },
      py::arg("surface"), py::arg("axis"), py::arg("position"),
      py::arg("chord_tolerance") = py::none(),
      "The section by the plane across axis (\"x\": a station, \"y\": a buttock, \"z\": a "
      "waterline) at position (m), as a list of SectionCurve. Points lie on surface and plane; no "
      "chord is further than chord_tolerance (m; default 1e-5 of the mesh's size) from the curve. "
      "A surface lying in the plane has no section there.");
}

}  // namespace hull::bindings
