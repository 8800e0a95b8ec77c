// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/tessellation.h"

#include <cstring>

#include "bindings/arrays.h"
#include "bindings/classes.h"

namespace hull::bindings {

void bind_tessellation(py::module_& module) {
  py::class_<Tessellation>(module, "Tessellation",
                           "Points of a limit surface joined by quadrilaterals, without gaps.")
      .def_property_readonly(
          "points", [](const Tessellation& t) { return to_array(t.points); }, "(m, 3), m.")
      .def_property_readonly(
          "cells", [](const Tessellation& t) { return to_array(t.cells); },
          "(m,) a cell that each point lies in.")
      .def_property_readonly(
          "uv", [](const Tessellation& t) { return to_array(t.uv); }, "(m, 2) where in that cell.")
      .def_property_readonly(
          "quads",
          [](const Tessellation& t) {
            py::array_t<int> quads({static_cast<py::ssize_t>(t.quads.size()), py::ssize_t{4}});
            if (!t.quads.empty()) {
              std::memcpy(quads.mutable_data(), t.quads.data(),
                          t.quads.size() * sizeof(t.quads[0]));
            }
            return quads;
          },
          "(k, 4) points, counter-clockwise; those of one cell follow one another.")
      .def_property_readonly(
          "corner_normals",
          [](const Tessellation& t) {
            py::array_t<double> normals({static_cast<py::ssize_t>(t.corner_normals.size()),
                                         py::ssize_t{4}, py::ssize_t{3}});
            if (!t.corner_normals.empty()) {
              std::memcpy(normals.mutable_data(), t.corner_normals.data(),
                          t.corner_normals.size() * sizeof(t.corner_normals[0]));
            }
            return normals;
          },
          "(k, 4, 3) exact unit normals of each quadrilateral's corners, differing across creases; "
          "zero where there is no tangent plane.");

  module.attr("LimitSurface").attr("tessellate") =
      py::cpp_function([](const LimitSurface& surface, int n) { return tessellate(surface, n); },
                       py::name("tessellate"), py::is_method(module.attr("LimitSurface")),
                       py::arg("n"), py::call_guard<py::gil_scoped_release>(),
                       "n x n quadrilaterals per cell (1 to 256), as a Tessellation.");
}

}  // namespace hull::bindings
