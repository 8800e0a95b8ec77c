// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <stdexcept>
#include <string>

#include "analysis/fairness/knuckle_angles.h"
#include "bindings/arrays.h"
#include "bindings/move_limits.h"
#include "modelling/knuckle_setting.h"

namespace hull::bindings {
namespace {

surface::CreaseCurve curve_of(const surface::LimitSurface& surface, int knuckle) {
  std::vector<surface::CreaseCurve> curves = surface::crease_curves(surface);
  if (knuckle < 0 || knuckle >= static_cast<int>(curves.size())) {
    throw std::invalid_argument("There is no knuckle " + std::to_string(knuckle) +
                                ": the surface has " + std::to_string(curves.size()) +
                                " creases and borders, as crease_curves() gives them.");
  }
  return std::move(curves[knuckle]);
}

void bind_angles(py::module_& module) {
  py::class_<analysis::KnuckleAngles>(
      module, "KnuckleAngles",
      "The angle along a knuckle, rad: 0 where the surface is smooth, "
      "positive where it is bent away from the water, negative in a hollow.")
      .def_property_readonly(
          "t", [](const analysis::KnuckleAngles& a) { return to_array(a.t); },
          "(n,) the samples' places on the CreaseCurve.")
      .def_property_readonly(
          "arc_lengths", [](const analysis::KnuckleAngles& a) { return to_array(a.arc_lengths); },
          "(n,), m, over the edges measured.")
      .def_property_readonly(
          "angles", [](const analysis::KnuckleAngles& a) { return to_array(a.angles); },
          "(n,), rad, from the surface's exact normals on both sides; NaN where there is none.")
      .def_readonly("length", &analysis::KnuckleAngles::length, "Of the edges measured, m.")
      .def_readonly("least", &analysis::KnuckleAngles::least, "rad")
      .def_readonly("mean", &analysis::KnuckleAngles::mean, "By arc length, rad.")
      .def_readonly("largest", &analysis::KnuckleAngles::largest, "rad");
  module.def(
      "knuckle_angles",
      [](const surface::LimitSurface& surface, int knuckle, const py::object& edges,
         int samples_per_edge) {
        const std::vector<int> measured = integers_from(edges, "edges");
        const py::gil_scoped_release release;
        return analysis::knuckle_angles(surface, curve_of(surface, knuckle), measured,
                                        samples_per_edge);
      },
      py::arg("surface"), py::arg("knuckle"), py::kw_only(), py::arg("edges") = py::tuple(),
      py::arg("samples_per_edge") = 8,
      "The KnuckleAngles along a crease, by its number in crease_curves(), or along those of its "
      "edges (k,), rising, that are named (Greshake 2021, 5.1). ValueError for a border, or edges "
      "that are none.");
}

void bind_setting(py::module_& module) {
  py::class_<modelling::KnuckleSetting>(module, "KnuckleSetting",
                                        "Moves of control points that give a knuckle its angle.")
      .def_property_readonly(
          "points", [](const modelling::KnuckleSetting& s) { return to_array(s.points); },
          "(m,) control points that move, rising.")
      .def_property_readonly(
          "moves", [](const modelling::KnuckleSetting& s) { return to_array(s.moves); },
          "(m, 3), m.")
      .def_property_readonly(
          "edges", [](const modelling::KnuckleSetting& s) { return to_array(s.edges); },
          "Edges that were set: those asked for, but such as end in darts.")
      .def_readonly("deviation", &modelling::KnuckleSetting::deviation,
                    "The largest, from the angle asked for, of 16 samples an edge, rad.")
      .def_readonly("met", &modelling::KnuckleSetting::met, "Whether that is within the tolerance.")
      .def_readonly("steps", &modelling::KnuckleSetting::steps);
  module.def(
      "set_knuckle_angle",
      [](const surface::LimitSurface& surface, int knuckle, double angle, const py::object& edges,
         double tolerance, const py::object& locked, const py::object& held_points,
         const DoubleArray& held_normals, const py::object& tied,
         const DoubleArray& tied_directions, const py::iterable& kept) {
        modelling::KnuckleOptions options;
        options.edges = integers_from(edges, "edges");
        options.tolerance = tolerance;
        const modelling::ReshapeLimits limits =
            limits_from(locked, held_points, held_normals, tied, tied_directions, kept);
        const py::gil_scoped_release release;
        return modelling::set_knuckle_angle(surface, curve_of(surface, knuckle), angle, limits,
                                            options);
      },
      py::arg("surface"), py::arg("knuckle"), py::arg("angle"), py::kw_only(),
      py::arg("edges") = py::tuple(), py::arg("tolerance") = modelling::KnuckleOptions{}.tolerance,
      py::arg("locked") = py::tuple(), py::arg("held_points") = py::tuple(),
      py::arg("held_normals") = py::tuple(), py::arg("tied") = py::tuple(),
      py::arg("tied_directions") = py::tuple(), py::arg("kept") = py::tuple(),
      "The KnuckleSetting that brings the angle along a crease, or along those of its edges (k,) "
      "that are named, to `angle`, rad: the curve stays, and control points beside it move, with "
      "the least sum of squares. Limits are those of pull_surface(). The surface itself is left as "
      "it is.\n\nOne angle is as near as the control points allow: `deviation` and `met` tell. "
      "ValueError for a border, an angle outside of ±170°, edges that all end in darts, or where "
      "no point beside them may move.");
}

}  // namespace

void bind_knuckles(py::module_& module) {
  bind_angles(module);
  bind_setting(module);
}

}  // namespace hull::bindings
