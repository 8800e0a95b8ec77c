// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/sections.h"

#include <pybind11/stl.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/sections/kept_sections.h"
#include "analysis/sections/section_splines.h"
#include "bindings/arrays.h"
#include "bindings/casts.h"
#include "bindings/planes.h"

namespace hull::bindings {
namespace {

analysis::SectionOptions options_from(const surface::LimitSurface& surface,
                                      const std::optional<double>& chord_tolerance,
                                      const std::optional<double>& flat_tolerance) {
  return {chord_tolerance.value_or(kChordTolerance * surface.mesh().size()), flat_tolerance};
}

std::vector<analysis::SectionCurve> section_across(const surface::LimitSurface& surface,
                                                   const py::object& axis, double position,
                                                   const std::optional<double>& chord_tolerance,
                                                   const std::optional<double>& flat_tolerance) {
  // Of unit length first, so that the position is in metres whatever length was given.
  const analysis::Plane plane =
      py::isinstance<py::str>(axis)
          ? analysis::plane_across(axis_from(cast_or_refuse<std::string>(
                                       axis, "An axis is \"x\", \"y\" or \"z\", or a direction.")),
                                   position)
          : plane_from(point_from(DoubleArray(axis), "axis").normalized(), position, "axis");
  const analysis::SectionOptions options = options_from(surface, chord_tolerance, flat_tolerance);
  const py::gil_scoped_release release;
  return analysis::section(surface, plane, options);
}

// A stretch with the values that hold within it at its ends.
struct StretchArrays {
  std::vector<Vector3d> points, tangents;
  std::vector<double> curvatures;
  int first;
};

std::vector<StretchArrays> stretches_of(const analysis::SectionCurve& curve) {
  std::vector<StretchArrays> result;
  for (const analysis::SmoothStretch& s : analysis::smooth_stretches(curve)) {
    const auto part = [&s](const auto& values) {
      return std::decay_t<decltype(values)>(values.begin() + s.first, values.begin() + s.last + 1);
    };
    StretchArrays& arrays = result.emplace_back();
    arrays.first = s.first;
    arrays.points = part(curve.points);
    arrays.tangents = part(curve.tangents);
    arrays.curvatures = part(curve.curvatures);
    // At a knuckle the curve has the tangent before it; the stretch needs the one after.
    arrays.tangents.front() = s.first_tangent;
    arrays.curvatures.front() = s.first_curvature;
  }
  return result;
}

void bind_curves(py::module_& module) {
  py::class_<StretchArrays>(module, "SectionStretch",
                            "A stretch of a section from knuckle to knuckle, with the tangents "
                            "and curvatures that it has at its own ends.")
      .def_property_readonly(
          "points", [](const StretchArrays& s) { return bindings::to_array(s.points); },
          "(k, 3), m, in order.")
      .def_property_readonly(
          "tangents", [](const StretchArrays& s) { return bindings::to_array(s.tangents); },
          "(k, 3), of unit length.")
      .def_property_readonly(
          "curvatures", [](const StretchArrays& s) { return bindings::to_array(s.curvatures); },
          "(k,), 1/m.")
      .def_readonly("first", &StretchArrays::first, "Index of the first point in the curve.");
  py::class_<analysis::SectionCurve>(
      module, "SectionCurve",
      "One branch of a plane section. It runs with what is above the plane on its left, seen from "
      "the water: the body is on the left, seen against the plane's normal.")
      .def_property_readonly(
          "points", [](const analysis::SectionCurve& c) { return bindings::to_array(c.points); },
          "(k, 3), m, in order; the first is repeated at the end of a closed curve.")
      .def_property_readonly(
          "cells", [](const analysis::SectionCurve& c) { return bindings::to_array(c.cells); },
          "(k,).")
      .def_property_readonly(
          "uv", [](const analysis::SectionCurve& c) { return bindings::to_array(c.uv); }, "(k, 2).")
      .def_property_readonly(
          "tangents",
          [](const analysis::SectionCurve& c) { return bindings::to_array(c.tangents); },
          "(k, 3), of unit length; at knuckles those before them.")
      .def_property_readonly(
          "curvatures",
          [](const analysis::SectionCurve& c) { return bindings::to_array(c.curvatures); },
          "(k,), 1/m, in the plane: positive where the curve turns left, seen against the plane's "
          "normal, as a convex body does; at knuckles those before them.")
      .def_property_readonly(
          "knuckles",
          [](const analysis::SectionCurve& c) { return bindings::to_array(c.knuckles); },
          "(n,) indices of the points on creases, and where the tangent turns. A closed curve with "
          "knuckles starts at one, whose index is that of the last point.")
      .def_property_readonly(
          "knuckle_tangents",
          [](const analysis::SectionCurve& c) { return bindings::to_array(c.knuckle_tangents); },
          "(n, 3), after the knuckles.")
      .def_property_readonly(
          "knuckle_curvatures",
          [](const analysis::SectionCurve& c) { return bindings::to_array(c.knuckle_curvatures); },
          "(n,), 1/m, after the knuckles.")
      .def_property_readonly("stretches", &stretches_of,
                             "List of SectionStretch: the curve from knuckle to knuckle.")
      .def_readonly("closed", &analysis::SectionCurve::closed);
}

void bind_splines(py::module_& module) {
  py::class_<analysis::SectionSpline>(
      module, "SectionSpline",
      "A stretch of a section between knuckles as a cubic B-spline curve "
      "with two continuous derivatives, in the section's plane.")
      .def_property_readonly("degree", [](const analysis::SectionSpline&) { return 3; })
      .def_property_readonly(
          "knots",
          [](const analysis::SectionSpline& s) { return bindings::to_array(s.curve.knots()); },
          "(n + 4,), from 0 to about the length in m; the first and the last of them fourfold.")
      .def_property_readonly(
          "control_points",
          [](const analysis::SectionSpline& s) { return bindings::to_array(s.curve.points()); },
          "(n, 3), m.")
      .def_readonly("closed", &analysis::SectionSpline::closed,
                    "Whether it is a whole closed curve without knuckles.")
      .def_readonly("largest_distance", &analysis::SectionSpline::largest_distance,
                    "From the section, m, where it was measured.")
      .def(
          "evaluate",
          [](const analysis::SectionSpline& s, const DoubleArray& array) {
            std::vector<Vector3d> points;
            for (const double t : numbers_from(array, "t")) {
              if (!(t >= s.curve.begin() && t <= s.curve.end())) {
                throw std::invalid_argument("t has to lie between the first and the last knot.");
              }
              points.push_back(s.curve.evaluate(t, 0).point);
            }
            return bindings::to_array(points);
          },
          py::arg("t"), "t: (k,). Points (k, 3), m.");
  py::class_<analysis::SectionSplines>(module, "SectionSplines",
                                       "One branch of a section as splines.")
      .def_readonly("splines", &analysis::SectionSplines::splines,
                    "List of SectionSpline, in order.")
      .def_readonly("closed", &analysis::SectionSplines::closed);
}

}  // namespace

void bind_sections(py::module_& module) {
  bind_curves(module);
  bind_splines(module);
  module.def(
      "plane_across",
      [](const std::string& axis, double position) {
        return to_array(analysis::plane_across(axis_from(axis), position));
      },
      py::arg("axis"), py::arg("position"),
      "The plane across axis \"x\", \"y\" or \"z\" at position (m), as (4,): normal, offset.");
  module.def(
      "diagonal_plane",
      [](double height, double angle) { return to_array(analysis::diagonal_plane(height, angle)); },
      py::arg("height"), py::arg("angle"),
      "The plane of a diagonal, as (4,): normal, offset. It goes through y = 0, z = height (m) and "
      "falls to port by angle (radians) below the horizontal.");
  module.def("section", &section_across, py::arg("surface"), py::arg("axis"), py::arg("position"),
             py::arg("chord_tolerance") = py::none(), py::kw_only(),
             py::arg("flat_tolerance") = py::none(),
             "The section by the plane across axis (\"x\": a station, \"y\": a buttock, \"z\": a "
             "waterline; or a normal (3,) of any length) at position (m), as a list of "
             "SectionCurve. Points lie on surface and plane; no chord is further than "
             "chord_tolerance (m; default 1e-5 of the mesh's size) from the curve.\n\n"
             "Parts of the surface nearer to the plane than flat_tolerance (m; default 1e-10 of "
             "the size) lie in it: of flat regions the border belongs to the section, and so do "
             "creases, borders and lines between patches. Points that only touch the plane give "
             "nothing. ValueError for tolerances that are not positive, and what is no plane.");
  module.def(
      "sections",
      [](const surface::LimitSurface& surface, const DoubleArray& planes,
         const std::optional<double>& chord_tolerance,
         const std::optional<double>& flat_tolerance) {
        const std::vector<analysis::Plane> wanted = planes_from(planes);
        const analysis::SectionOptions options =
            options_from(surface, chord_tolerance, flat_tolerance);
        const py::gil_scoped_release release;
        return analysis::sections(surface, wanted, options);
      },
      py::arg("surface"), py::arg("planes"), py::arg("chord_tolerance") = py::none(), py::kw_only(),
      py::arg("flat_tolerance") = py::none(),
      "The sections by several planes: (n, 4), of each its normal, of any length, and offset, for "
      "normal·p = offset. A list of n lists of SectionCurve, as section() gives them; for many "
      "planes cheaper than one by one.");
  py::class_<analysis::KeptSections>(
      module, "KeptSections",
      "Sections of a surface whose points are moved: of each plane that was asked for the parts "
      "are "
      "kept, cell by cell, and only cells that have moved since are cut again.")
      .def(py::init<const surface::LimitSurface&>(), py::arg("surface"), py::keep_alive<1, 2>())
      .def(
          "sections",
          [](analysis::KeptSections& kept, const DoubleArray& planes, double chord_tolerance,
             const std::optional<double>& flat_tolerance) {
            // The lock is kept: what is kept is changed.
            return kept.sections(planes_from(planes), {chord_tolerance, flat_tolerance});
          },
          py::arg("planes"), py::arg("chord_tolerance"), py::kw_only(),
          py::arg("flat_tolerance") = py::none(),
          "What the function sections() gives of the surface as it is, to the last bit.");
  module.def(
      "section_splines",
      [](const surface::LimitSurface& surface, const DoubleArray& planes,
         const std::optional<double>& tolerance, const std::optional<double>& flat_tolerance) {
        const std::vector<analysis::Plane> wanted = planes_from(planes);
        const double chosen = tolerance.value_or(kChordTolerance * surface.mesh().size());
        const py::gil_scoped_release release;
        std::vector<std::vector<analysis::SectionSplines>> result;
        for (const analysis::Plane& plane : wanted) {
          result.push_back(analysis::section_splines(surface, plane, chosen, flat_tolerance));
        }
        return result;
      },
      py::arg("surface"), py::arg("planes"), py::arg("tolerance") = py::none(), py::kw_only(),
      py::arg("flat_tolerance") = py::none(),
      "The sections by planes (n, 4) as cubic B-spline curves no further than tolerance (m; "
      "default 1e-5 of the mesh's size) from them: a list of n lists of SectionSplines, one a "
      "branch.");
}

}  // namespace hull::bindings
