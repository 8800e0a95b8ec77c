// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/light_lines.h"

#include <pybind11/stl.h>

#include <optional>
#include <stdexcept>

#include "bindings/arrays.h"

namespace hull::bindings {
namespace {

constexpr double kLightLineTolerance = 1e-4;  // of the mesh's size, unless given

using Vector = std::optional<DoubleArray>;

analysis::LevelOptions options_from(const surface::LimitSurface& surface, int divisions,
                                    const std::optional<double>& chord_tolerance) {
  return {divisions, chord_tolerance.value_or(kLightLineTolerance * surface.mesh().size())};
}

analysis::Eye eye_from(const Vector& direction, const Vector& point) {
  if (direction.has_value() == point.has_value()) {
    throw std::invalid_argument(
        "Give either eye_direction (3,), from the hull to an eye far away, or eye (3,), a point.");
  }
  analysis::Eye eye;
  if (direction) eye.direction = point_from(*direction, "eye_direction");
  if (point) eye.point = point_from(*point, "eye");
  return eye;
}

analysis::LightBank bank_from(const DoubleArray& line_direction, const DoubleArray& light_direction,
                              double spacing, const Vector& eye_direction, const Vector& eye,
                              std::optional<double> distance, double phase,
                              std::optional<int> lines) {
  return {point_from(line_direction, "line_direction"),
          point_from(light_direction, "light_direction"),
          distance,
          spacing,
          phase,
          eye_from(eye_direction, eye),
          lines};
}

void bind_light_line(py::module_& module) {
  py::class_<analysis::LevelCurve>(
      module, "LevelCurve",
      "A curve on the surface along which something has one value: an "
      "isophote, a reflection line or an outline. It runs with greater values "
      "on its left, seen from outside.")
      .def_readonly("level", &analysis::LevelCurve::level,
                    "Angle of an isophote (rad), number of a line of light; 0 of an outline.")
      .def_property_readonly(
          "points", [](const analysis::LevelCurve& c) { return to_array(c.points); },
          "(k, 3), m, in order; the first is repeated at the end of a closed curve.")
      .def_property_readonly(
          "cells", [](const analysis::LevelCurve& c) { return to_array(c.cells); }, "(k,).")
      .def_property_readonly(
          "uv", [](const analysis::LevelCurve& c) { return to_array(c.uv); }, "(k, 2).")
      .def_readonly("closed", &analysis::LevelCurve::closed);
}

void bind_curves_of_normals(py::module_& module) {
  module.def(
      "isophotes",
      [](const surface::LimitSurface& surface, const DoubleArray& direction,
         const DoubleArray& angles, int divisions, std::optional<double> chord_tolerance) {
        const Vector3d along = point_from(direction, "direction");
        const std::vector<double> wanted = numbers_from(angles, "angles");
        const py::gil_scoped_release release;
        return analysis::isophotes(surface, along, wanted,
                                   options_from(surface, divisions, chord_tolerance));
      },
      py::arg("surface"), py::kw_only(), py::arg("direction"), py::arg("angles"),
      py::arg("divisions") = 8, py::arg("chord_tolerance") = py::none(),
      "Curves along which the exact normal has one of the angles (n,), rad from 0 to pi, to "
      "direction (3,), of any length: a list of LevelCurve, angle by angle.\n\n"
      "Looked for on divisions x divisions squares of each cell (1 to 64): what comes and goes "
      "within one is not found. Points are exact to rounding, as many as keep the surface's curve "
      "within chord_tolerance (m; default 1e-4 of the mesh's size). Curves end at creases, where "
      "the normal jumps. ValueError for a direction of no length and numbers out of range.");
  module.def(
      "silhouette",
      [](const surface::LimitSurface& surface, const Vector& eye_direction, const Vector& eye,
         int divisions, std::optional<double> chord_tolerance) {
        const analysis::Eye from = eye_from(eye_direction, eye);
        const py::gil_scoped_release release;
        return analysis::silhouette(surface, from,
                                    options_from(surface, divisions, chord_tolerance));
      },
      py::arg("surface"), py::kw_only(), py::arg("eye_direction") = py::none(),
      py::arg("eye") = py::none(), py::arg("divisions") = 8,
      py::arg("chord_tolerance") = py::none(),
      "The outline of the surface seen from far away in eye_direction (3,), from the hull to the "
      "eye, or from the point eye (3,): a list of LevelCurve, as isophotes() gives them for a "
      "right angle, and the parts of creases between a side turned to the eye and one turned away. "
      "Parts that others hide are there; borders are not.");
}

void bind_reflections(py::module_& module) {
  module.def(
      "reflection_lines",
      [](const surface::LimitSurface& surface, const DoubleArray& line_direction,
         const DoubleArray& light_direction, double spacing, const Vector& eye_direction,
         const Vector& eye, std::optional<double> distance, double phase, std::optional<int> lines,
         int divisions, std::optional<double> chord_tolerance) {
        const analysis::LightBank bank = bank_from(line_direction, light_direction, spacing,
                                                   eye_direction, eye, distance, phase, lines);
        const py::gil_scoped_release release;
        return analysis::reflection_lines(surface, bank,
                                          options_from(surface, divisions, chord_tolerance));
      },
      py::arg("surface"), py::kw_only(), py::arg("line_direction"), py::arg("light_direction"),
      py::arg("spacing"), py::arg("eye_direction") = py::none(), py::arg("eye") = py::none(),
      py::arg("distance") = py::none(), py::arg("phase") = 0.0, py::arg("lines") = py::none(),
      py::arg("divisions") = 8, py::arg("chord_tolerance") = py::none(),
      "Parallel straight lines of light as they are seen mirrored in the surface: a list of "
      "LevelCurve, whose level is the number of the line.\n\n"
      "line_direction (3,): of the lines; light_direction (3,): from the hull to line 0, the part "
      "of it across the lines. distance: m from the origin to the plane of the lines, spacing in "
      "m; by default they are infinitely far away, spacing is the angle between them (rad). phase: "
      "moves all by so many spacings. lines: how many there are to each side of line 0; by default "
      "20, or all above the horizon. The eye is far away in eye_direction (3,), from the hull, or "
      "the point eye (3,). divisions and chord_tolerance as for isophotes().\n\n"
      "A surface without breaks of its normal has unbroken lines; one whose curvature jumps has "
      "lines with corners. ValueError for directions of no length, light along the lines, a "
      "spacing or distance that is not above zero.");
  module.def(
      "reflection_field",
      [](const surface::Tessellation& tessellation, const DoubleArray& line_direction,
         const DoubleArray& light_direction, double spacing, const Vector& eye_direction,
         const Vector& eye, std::optional<double> distance, double phase) {
        const analysis::LightLines lines(bank_from(line_direction, light_direction, spacing,
                                                   eye_direction, eye, distance, phase,
                                                   std::nullopt));
        return to_array(analysis::normal_field(tessellation, lines));
      },
      py::arg("tessellation"), py::kw_only(), py::arg("line_direction"), py::arg("light_direction"),
      py::arg("spacing"), py::arg("eye_direction") = py::none(), py::arg("eye") = py::none(),
      py::arg("distance") = py::none(), py::arg("phase") = 0.0,
      "The number, with fractions, of the line of light seen at each of the tessellation's normals "
      "(l,); parameters as for reflection_lines(). Stripes are floor(2 * field) % 2. NaN where no "
      "light is seen: where the ray goes away from the plane of the lines, or along them.");
}

}  // namespace

void bind_light_lines(py::module_& module) {
  bind_light_line(module);
  bind_curves_of_normals(module);
  bind_reflections(module);
}

}  // namespace hull::bindings
