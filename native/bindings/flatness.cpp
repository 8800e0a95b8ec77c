// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/flatness.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "analysis/fairness/flat_regions.h"
#include "bindings/arrays.h"
#include "bindings/planes.h"
#include "mesh/tolerances.h"

namespace hull::bindings {
namespace {

std::optional<analysis::Plane> plane_if_given(const std::optional<DoubleArray>& plane) {
  return plane ? std::optional<analysis::Plane>(plane_from(*plane, "plane")) : std::nullopt;
}

py::array_t<double> cubics_of(const analysis::FlatBorder& border) {
  py::array_t<double> array(
      {static_cast<py::ssize_t>(border.cubics.size()), py::ssize_t{4}, py::ssize_t{3}});
  double* out = array.mutable_data();
  for (const auto& cubic : border.cubics) {
    for (const Vector3d& p : cubic) out = std::copy_n(p.data(), 3, out);
  }
  return array;
}

std::vector<Vector3d> points_on(const analysis::FlatBorder& border, int samples) {
  if (samples < 1 || samples > 1024) {
    throw std::invalid_argument("A cubic takes 1 to 1024 samples, not " + std::to_string(samples) +
                                ".");
  }
  std::vector<Vector3d> points;
  for (const auto& c : border.cubics) {
    for (int i = 0; i < samples; ++i) {
      const double t = static_cast<double>(i) / samples, s = 1.0 - t;
      points.push_back(s * s * s * c[0] + 3.0 * s * s * t * c[1] + 3.0 * s * t * t * c[2] +
                       t * t * t * c[3]);
    }
  }
  if (!border.cubics.empty()) points.push_back(border.cubics.front()[0]);
  return points;
}

void bind_regions(py::module_& module) {
  py::class_<analysis::FlatBorder>(
      module, "FlatBorder",
      "A closed curve around a flat region, which is on its left, seen from "
      "outside.")
      .def_property_readonly("cubics", &cubics_of, "(m, 4, 3) Bézier points, m, in order.")
      .def(
          "points",
          [](const analysis::FlatBorder& b, int samples) {
            return to_array(points_on(b, samples));
          },
          py::arg("samples") = 8,
          "(k, 3), m: `samples` (1 to 1024) of each cubic; the first is repeated at the end.");
  py::class_<analysis::FlatRegion>(module, "FlatRegion",
                                   "Part of the surface that lies in one plane.")
      .def_property_readonly(
          "plane", [](const analysis::FlatRegion& r) { return to_array(r.plane); },
          "(4,): unit normal, to the side of the surface's, and offset; normal·p = offset.")
      .def_property_readonly(
          "cells", [](const analysis::FlatRegion& r) { return to_array(r.cells); }, "(n,), rising.")
      .def_readonly("area", &analysis::FlatRegion::area, "m².")
      .def_readonly("borders", &analysis::FlatRegion::borders, "List of FlatBorder.");
  module.def(
      "flat_regions",
      [](const surface::LimitSurface& surface, const std::optional<DoubleArray>& plane,
         std::optional<double> tolerance, double smallest_area) {
        const std::optional<analysis::Plane> wanted = plane_if_given(plane);
        const py::gil_scoped_release release;
        return analysis::flat_regions(
            surface, wanted, tolerance.value_or(kInPlane * surface.mesh().size()), smallest_area);
      },
      py::arg("surface"), py::kw_only(), py::arg("plane") = py::none(),
      py::arg("tolerance") = py::none(), py::arg("smallest_area") = 0.0,
      "Flat of bottom, flat of side and the like: regions of cells whose control points are no "
      "further than tolerance (m; default 1e-6 of the mesh's size) from one plane, and so is the "
      "surface. A list of FlatRegion, the largest first; those below smallest_area (m²) are left "
      "out. plane (4,), normal·p = offset: regions in that plane only. Borders are the exact sides "
      "of cells. ValueError for what is no plane, a tolerance that is not above zero.");
}

}  // namespace

void bind_flatness(py::module_& module) {
  bind_regions(module);
  py::class_<analysis::Flatness>(module, "Flatness", "How flat a part of the surface is.")
      .def_property_readonly(
          "plane", [](const analysis::Flatness& f) { return to_array(f.plane); },
          "(4,): unit normal and offset; normal·p = offset.")
      .def_readonly("surface_distance", &analysis::Flatness::surface_distance,
                    "Largest distance of the part's surface from the plane, m.")
      .def_property_readonly(
          "surface_point",
          [](const analysis::Flatness& f) {
            return to_array(
                std::vector<double>{f.surface_point.x(), f.surface_point.y(), f.surface_point.z()});
          },
          "(3,), m: where; zero if no whole face is in the part.")
      .def_readonly("control_distance", &analysis::Flatness::control_distance,
                    "Largest distance of the part's control points, m.")
      .def_property_readonly(
          "vertices", [](const analysis::Flatness& f) { return to_array(f.vertices); },
          "(n,) the part's control points, rising.")
      .def_property_readonly(
          "distances", [](const analysis::Flatness& f) { return to_array(f.distances); },
          "(n,), m: how high each is above the plane, on its normal's side.")
      .def_property_readonly(
          "at_fault", [](const analysis::Flatness& f) { return to_array(f.at_fault); },
          "(k,) those further from the plane than the tolerance.")
      .def_property_readonly(
          "neighbours_at_fault",
          [](const analysis::Flatness& f) { return to_array(f.neighbours_at_fault); },
          "(k,) control points around the part, not beyond creases, that bend its rim: further "
          "from the plane than the tolerance.");
  module.def(
      "flatness",
      [](const surface::LimitSurface& surface, const std::optional<py::object>& faces,
         const std::optional<py::object>& vertices, const std::optional<DoubleArray>& plane,
         std::optional<double> tolerance) {
        if (faces.has_value() == vertices.has_value()) {
          throw std::invalid_argument("flatness() takes either faces or vertices.");
        }
        const analysis::FlatPart part =
            faces ? analysis::flat_part_of_faces(surface, integers_from(*faces, "faces"))
                  : analysis::flat_part_of_vertices(surface, integers_from(*vertices, "vertices"));
        const std::optional<analysis::Plane> wanted = plane_if_given(plane);
        const py::gil_scoped_release release;
        return analysis::flatness(surface, part, wanted,
                                  tolerance.value_or(kInPlane * surface.mesh().size()));
      },
      py::arg("surface"), py::kw_only(), py::arg("faces") = py::none(),
      py::arg("vertices") = py::none(), py::arg("plane") = py::none(),
      py::arg("tolerance") = py::none(),
      "Flatness of a part of the surface that is meant to be flat: faces (n,) of the control mesh, "
      "or the faces all of whose corners are among vertices (n,). plane (4,), normal·p = offset; "
      "by default that in which most of the part's control points lie, so that a few at fault do "
      "not tilt it. tolerance: m, default 1e-6 of the mesh's size. ValueError for indices that the "
      "mesh has not, no selection, control points without one plane.");
}

}  // namespace hull::bindings
