// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/bilge_arc.h"

#include <pybind11/stl.h>

#include <numbers>
#include <optional>

#include "bindings/arrays.h"

namespace hull::bindings {
namespace {

modelling::BilgeBorder border_from(bool is_moved, const std::optional<double>& outer) {
  if (outer) return {modelling::BilgeBorder::Kind::kSmooth, *outer};
  return {is_moved ? modelling::BilgeBorder::Kind::kBest : modelling::BilgeBorder::Kind::kTouching,
          0.0};
}

}  // namespace

void bind_bilge_arc(py::module_& module) {
  py::class_<modelling::BilgeArc>(
      module, "BilgeArc", "Control points of a section's bilge, nearest to a circle of radius 1.")
      .def_property_readonly(
          "points", [](const modelling::BilgeArc& a) { return to_array(a.points); },
          "(count + 2, 2), from the border of the flat bottom to that of the flat side.")
      .def_readonly("deviation", &modelling::BilgeArc::deviation,
                    "Largest distance from bottom, circle and side, in radii.")
      .def_readonly("least_curvature", &modelling::BilgeArc::least_curvature,
                    "Of the middle half of the curve, in 1/radius.")
      .def_readonly("greatest_curvature", &modelling::BilgeArc::greatest_curvature, "In 1/radius.");
  module.def(
      "bilge_arc",
      [](int count, double angle, bool move_borders, std::optional<double> outer_bottom,
         std::optional<double> outer_side) {
        const py::gil_scoped_release release;
        return modelling::bilge_arc(count, angle, border_from(move_borders, outer_bottom),
                                    border_from(move_borders, outer_side));
      },
      py::arg("count"), py::arg("angle") = 0.5 * std::numbers::pi, py::kw_only(),
      py::arg("move_borders") = false, py::arg("outer_bottom") = py::none(),
      py::arg("outer_side") = py::none(),
      "The BilgeArc with the least deviation: `count` control points (3 to 8) between two borders, "
      "the first in the plane of the bottom and the last in that of the side. The circle is around "
      "the origin; the bottom is the line from (-1, -1) to (0, -1), where the circle touches it; "
      "the section turns left by `angle` (radians, 10° to 170°) from there to the side. "
      "The borders are creases where the circle touches the flats. move_borders: they are not "
      "there but a little further "
      "out, where the deviation is the least. outer_bottom, outer_side: the border of this flat is "
      "no crease; the next control point is in the flat and stays, so far (radii) from where the "
      "circle touches it. ValueError for other counts and angles.");
}

}  // namespace hull::bindings
