// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/bilge_arc.h"

#include <numbers>

#include "bindings/arrays.h"
#include "bindings/classes.h"

namespace hull::bindings {

void bind_bilge_arc(py::module_& module) {
  py::class_<BilgeArc>(module, "BilgeArc",
                       "Control points of a section's bilge, nearest to a circle of radius 1.")
      .def_property_readonly(
          "points", [](const BilgeArc& a) { return to_array(a.points); },
          "(count + 2, 2), from the border of the flat bottom to that of the flat side.")
      .def_readonly("deviation", &BilgeArc::deviation,
                    "Largest distance from bottom, circle and side, in radii.")
      .def_readonly("least_curvature", &BilgeArc::least_curvature,
                    "Of the middle half of the curve, in 1/radius.")
      .def_readonly("greatest_curvature", &BilgeArc::greatest_curvature, "In 1/radius.");
  module.def(
      "bilge_arc",
      [](int count, double angle, bool move_borders) {
        const py::gil_scoped_release release;
        return bilge_arc(
            count, angle,
            move_borders ? BilgeBorders::kWhereBest : BilgeBorders::kWhereTheCircleTouches);
      },
      py::arg("count"), py::arg("angle") = 0.5 * std::numbers::pi, py::kw_only(),
      py::arg("move_borders") = false,
      "The BilgeArc with the least deviation: `count` control points (3 to 8) between two creases, "
      "the first in the plane of the bottom and the last in that of the side. The circle is around "
      "the origin; the bottom is the line from (-1, -1) to (0, -1), where the circle touches it; "
      "the section turns left by `angle` (radians, 10° to 170°) from there to the side. "
      "move_borders: the borders are not where the circle touches the flats, but a little further "
      "out, where the deviation is the least. ValueError for other counts and angles.");
}

}  // namespace hull::bindings
