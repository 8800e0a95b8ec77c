// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/tessellation.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "bindings/arrays.h"

namespace hull::bindings {

namespace {

py::array_t<int> row_array(const std::vector<std::array<int, 4>>& rows) {
  py::array_t<int> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{4}});
  if (!rows.empty()) std::memcpy(array.mutable_data(), rows.data(), rows.size() * sizeof(rows[0]));
  return array;
}

py::array_t<double> corner_normals(const surface::Tessellation& t) {
  py::array_t<double> normals(
      {static_cast<py::ssize_t>(t.corner_normals.size()), py::ssize_t{4}, py::ssize_t{3}});
  double* out = normals.mutable_data();
  for (const auto& corners : t.corner_normals) {
    for (int normal : corners) out = std::copy_n(t.normals[normal].data(), 3, out);
  }
  return normals;
}

surface::Tessellation tessellate_as_asked(const surface::LimitSurface& surface,
                                          std::optional<int> n,
                                          std::optional<double> chord_tolerance) {
  if (n.has_value() == chord_tolerance.has_value()) {
    throw std::invalid_argument("tessellate() takes either n or chord_tolerance.");
  }
  return n ? surface::tessellate(surface, *n)
           : surface::tessellate_to_tolerance(surface, *chord_tolerance);
}

}  // namespace

void bind_tessellation(py::module_& module) {
  py::class_<surface::Tessellation>(
      module, "Tessellation", "Points of a limit surface joined by quadrilaterals, without gaps.")
      .def_property_readonly(
          "points", [](const surface::Tessellation& t) { return to_array(t.points); }, "(m, 3), m.")
      .def_property_readonly(
          "cells", [](const surface::Tessellation& t) { return to_array(t.cells); },
          "(m,) a cell that each point lies in.")
      .def_property_readonly(
          "uv", [](const surface::Tessellation& t) { return to_array(t.uv); },
          "(m, 2) where in that cell.")
      .def_property_readonly(
          "quads", [](const surface::Tessellation& t) { return row_array(t.quads); },
          "(k, 4) points, counter-clockwise; those of one cell follow one another.")
      .def_property_readonly(
          "normals", [](const surface::Tessellation& t) { return to_array(t.normals); },
          "(l, 3) exact unit normals; zero where there is no tangent plane. One for each point, or "
          "several where creases split it.")
      .def_property_readonly(
          "normal_cells", [](const surface::Tessellation& t) { return to_array(t.normal_cells); },
          "(l,) a cell that has each normal.")
      .def_property_readonly(
          "normal_uv", [](const surface::Tessellation& t) { return to_array(t.normal_uv); },
          "(l, 2) where in that cell.")
      .def_property_readonly(
          "normal_indices",
          [](const surface::Tessellation& t) { return row_array(t.corner_normals); },
          "(k, 4) which of `normals` each corner of each quadrilateral has. Corners share one "
          "where "
          "the surface is smooth between them.")
      .def_property_readonly("corner_normals", &corner_normals,
                             "(k, 4, 3) the same, normals[normal_indices].");

  const py::object surface = module.attr("LimitSurface");
  // Added to the class that is bound elsewhere, as in curvature.cpp.
  surface.attr("tessellate") = py::cpp_function(
      &tessellate_as_asked, py::name("tessellate"), py::is_method(surface),
      py::arg("n") = py::none(), py::arg("chord_tolerance") = py::none(),
      py::call_guard<py::gil_scoped_release>(),
      "A Tessellation of n x n quadrilaterals per cell (1 to 256); or, with chord_tolerance=, in "
      "m, "
      "of as many as it takes for every point of the surface to be within that of its "
      "quadrilateral, whichever way this is cut into triangles. Then ValueError names a tolerance "
      "that would do where more than 256 divisions of a cell or 2^24 quadrilaterals were needed.");
}

}  // namespace hull::bindings
