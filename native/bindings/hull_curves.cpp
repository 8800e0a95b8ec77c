// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/hull_curves.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <stdexcept>

#include "bindings/arrays.h"
#include "bindings/planes.h"
#include "bindings/production_classes.h"
#include "production/plates/shell_plates.h"

namespace hull::bindings {

using production::HullCurves;
using production::SurfaceCurve;

namespace {

std::vector<SurfaceCurve> in_plane(const HullCurves& curves, const DoubleArray& plane,
                                   const std::string& name) {
  return curves.in_plane(plane_from(plane, "plane"), name);
}

void bind_surface_curve(py::module_& module) {
  py::class_<SurfaceCurve>(module, "SurfaceCurve",
                           "A curve on a LimitSurface: steps within single cells, each what the "
                           "surface makes of a straight line in (u, v). It lies on the surface "
                           "all along, as that is when the curve is made: after "
                           "surface.set_points() what takes curves raises ValueError for it.")
      .def_readwrite("name", &SurfaceCurve::name, "As it is called in lists and drawings.")
      .def_property_readonly(
          "points", [](const SurfaceCurve& c) { return to_array(c.points); },
          "(k + 1, 3), m, in order; a closed curve's first is repeated at the end.")
      .def_property_readonly(
          "cells",
          [](const SurfaceCurve& c) {
            std::vector<int> cells;
            for (const auto& step : c.steps) cells.push_back(step.cell);
            return to_array(cells);
          },
          "(k,) of the steps between points.")
      .def_property_readonly(
          "starts",
          [](const SurfaceCurve& c) {
            std::vector<Eigen::Vector2d> uv;
            for (const auto& step : c.steps) uv.push_back(step.from);
            return to_array(uv);
          },
          "(k, 2): (u, v) in its cell where each step begins …")
      .def_property_readonly(
          "ends",
          [](const SurfaceCurve& c) {
            std::vector<Eigen::Vector2d> uv;
            for (const auto& step : c.steps) uv.push_back(step.to);
            return to_array(uv);
          },
          "(k, 2): … and where it ends.")
      .def(
          "is_on",
          [](const SurfaceCurve& c, const surface::LimitSurface& s) {
            return production::is_on(s, c);
          },
          py::arg("surface"),
          "Whether it is on a LimitSurface as that is: not on another one, nor after "
          "set_points().");
}

}  // namespace

void bind_hull_curves(py::module_& module) {
  bind_surface_curve(module);
  py::class_<HullCurves>(
      module, "HullCurves",
      "Makes curves on a hull: seams, butts, marks. It is of the surface as it is "
      "when made: after surface.set_points() whatever is asked raises "
      "ValueError; make it anew.")
      .def(py::init([](const surface::LimitSurface& surface, std::optional<double> tolerance) {
             return HullCurves(surface, tolerance.value_or(1e-5 * surface.mesh().size()));
           }),
           py::arg("surface"), py::arg("chord_tolerance") = py::none(), py::keep_alive<1, 2>(),
           "chord_tolerance (m; default 1e-5 of the mesh's size): no chord between a curve's "
           "points is further from it. ValueError unless it is positive.")
      .def("in_plane", &in_plane, py::arg("plane"), py::arg("name") = "",
           "The curves in a plane (4,), its normal and offset, as plane_across() gives it: a list "
           "of SurfaceCurve, one a branch. ValueError for a plane that does not meet the hull.")
      .def(
          "on_cylinder",
          [](const HullCurves& curves, const DoubleArray& point, const DoubleArray& direction,
             double radius, const std::string& name) {
            return curves.on_cylinder(
                {point_from(point, "point"), point_from(direction, "direction"), radius}, name);
          },
          py::arg("point"), py::kw_only(), py::arg("direction"), py::arg("radius"),
          py::arg("name") = "",
          "Where a circular cylinder cuts the hull, a bow thruster's tunnel or a stern tube: its "
          "axis through a point (3,) along a direction (3,), without ends, its radius in m. A list "
          "of SurfaceCurve, one a branch, closed where the hull has no border within: points are "
          "on the hull, and off the cylinder by rounding, 1e-12 of the hull's size. ValueError for "
          "a cylinder that does not meet the hull, or touches it without a certain course.")
      .def(
          "at_girth",
          [](const HullCurves& curves, const SurfaceCurve& base, double girth,
             const DoubleArray& towards, const DoubleArray& across, const std::string& name) {
            const Vector3d side = point_from(towards, "towards");
            const Vector3d normal = point_from(across, "across");
            const py::gil_scoped_release release;
            return curves.at_girth(base, girth, side, normal, name);
          },
          py::arg("base"), py::arg("girth"), py::kw_only(), py::arg("towards"),
          py::arg("across") = py::make_tuple(1.0, 0.0, 0.0), py::arg("name") = "",
          "The curves at a girth (m) from a SurfaceCurve: from each of its points so far along the "
          "hull, in the plane through the point across the direction `across` (3,), by default "
          "the frame there, on the side that lies towards (3,). A list: one for each part of the "
          "base from which the hull reaches so far, to what does not lie in such a plane, as a "
          "transom; ends are on its border, or the latter's. ValueError where no "
          "part does, for a girth that is not positive, for a base in such planes, and for one "
          "that "
          "is not on the surface as it is.")
      .def(
          "projected",
          [](const HullCurves& curves, const DoubleArray& points, const DoubleArray& direction,
             const std::string& name) {
            return curves.projected(points_from(points, "points"),
                                    point_from(direction, "direction"), name);
          },
          py::arg("points"), py::kw_only(), py::arg("direction"), py::arg("name") = "",
          "A polyline (k, 3) projected onto the hull along a direction (3,): the first point that "
          "each ray from it meets. A list of SurfaceCurve, one for each part of the line that "
          "meets the hull. ValueError where none does.")
      .def(
          "projected_from",
          [](const HullCurves& curves, const DoubleArray& points, const DoubleArray& centre,
             const std::string& name) {
            return curves.projected_from(points_from(points, "points"),
                                         point_from(centre, "centre"), name);
          },
          py::arg("points"), py::kw_only(), py::arg("centre"), py::arg("name") = "",
          "The same with rays from a centre (3,) through the polyline's points.")
      .def("borders", &HullCurves::borders,
           "The surface's borders from corner to corner, as a list of SurfaceCurve named "
           "\"border\".")
      .def("knuckles", &HullCurves::knuckles, py::arg("least_angle") = production::kLargestKnuckle,
           "The knuckles whose angle exceeds least_angle (rad; default 0.5°) anywhere, as a list "
           "of SurfaceCurve named \"knuckle\". ValueError for one below 0 or not finite.")
      .def(
          "pieces",
          [](const HullCurves& curves, const SurfaceCurve& curve,
             const std::vector<SurfaceCurve>& by) {
            return production::pieces_between(curves.surface(), curve, by);
          },
          py::arg("curve"), py::arg("by"),
          "A curve cut where it crosses others: a list of SurfaceCurve, in order. ValueError for "
          "curves that are not on the surface as it is.");
}

}  // namespace hull::bindings
