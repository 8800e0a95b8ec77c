// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/pull/pull.h"

#include <stdexcept>

#include "bindings/arrays.h"
#include "bindings/move_limits.h"
#include "bindings/places.h"
#include "surface/pieces/point_weights.h"

namespace hull::bindings {
namespace {

py::tuple weights_at(const surface::LimitSurface& surface, const py::object& cells,
                     const DoubleArray& uv) {
  const Places places = places_from(surface, cells, uv);
  std::vector<int> begin{0}, points;
  std::vector<double> weights;
  {
    const py::gil_scoped_release release;
    surface::PointWeights rows(surface);
    for (std::size_t i = 0; i < places.cells.size(); ++i) {
      for (const surface::PointWeight& w :
           rows.at(places.cells[i], places.uv[i].x(), places.uv[i].y())) {
        points.push_back(w.point);
        weights.push_back(w.weight);
      }
      begin.push_back(static_cast<int>(points.size()));
    }
  }
  return py::make_tuple(to_array(begin), to_array(points), to_array(weights));
}

std::vector<modelling::PullTarget> targets_from(const surface::LimitSurface& surface,
                                                const py::object& cells, const DoubleArray& uv,
                                                const DoubleArray& targets) {
  const Places places = places_from(surface, cells, uv);
  const std::vector<Vector3d> points = points_from(targets, "targets");
  if (points.size() != places.cells.size()) {
    throw std::invalid_argument("There must be as many targets as cells, " +
                                std::to_string(places.cells.size()) + ", not " +
                                std::to_string(points.size()) + ".");
  }
  std::vector<modelling::PullTarget> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back({places.cells[i], places.uv[i].x(), places.uv[i].y(), points[i]});
  }
  return result;
}

}  // namespace

void bind_pull(py::module_& module) {
  py::class_<modelling::Pull>(module, "Pull",
                              "Moves of control points that pull the surface to targets.")
      .def_property_readonly(
          "points", [](const modelling::Pull& p) { return to_array(p.points); },
          "(m,) control points that move, rising.")
      .def_property_readonly(
          "moves", [](const modelling::Pull& p) { return to_array(p.moves); }, "(m, 3), m.")
      .def_readonly("miss", &modelling::Pull::miss,
                    "Largest distance of a target from where its place comes to lie, m.")
      .def_readonly("reach", &modelling::Pull::reach,
                    "The largest move of a control point, divided by the largest pull.");
  module.def("point_weights", &weights_at, py::arg("surface"), py::arg("cells"), py::arg("uv"),
             "Points of the surface as sums of control points, exact. cells: (k,), uv: (k, 2). "
             "Returns begin (k + 1,), points and weights (begin[k],): place i is the sum over "
             "begin[i] <= j < begin[i + 1] of weights[j] times control point points[j].");
  module.def(
      "pull_surface",
      [](const surface::LimitSurface& surface, const py::object& cells, const DoubleArray& uv,
         const DoubleArray& targets, const py::object& locked, const py::object& held_points,
         const DoubleArray& held_normals, const py::object& tied,
         const DoubleArray& tied_directions, const py::iterable& kept, double radius,
         bool mirrored) {
        const std::vector<modelling::PullTarget> wanted = targets_from(surface, cells, uv, targets);
        const modelling::ReshapeLimits limits =
            limits_from(locked, held_points, held_normals, tied, tied_directions, kept);
        const py::gil_scoped_release release;
        return modelling::pull(surface, wanted, limits, {radius, mirrored});
      },
      py::arg("surface"), py::arg("cells"), py::arg("uv"), py::arg("targets"), py::kw_only(),
      py::arg("locked") = py::tuple(), py::arg("held_points") = py::tuple(),
      py::arg("held_normals") = py::tuple(), py::arg("tied") = py::tuple(),
      py::arg("tied_directions") = py::tuple(), py::arg("kept") = py::tuple(),
      py::arg("radius") = 0.0, py::arg("mirrored") = false,
      "The Pull that takes the places cells (k,), uv (k, 2) to targets (k, 3), m, with the least "
      "sum of squared moves of the control points that have a weight there. locked (n,): control "
      "points that stay. held_points (h,), held_normals (h, 3): points that move across their "
      "normal only; a point may be there several times. tied, tied_directions, kept: as for "
      "Reshape.\n\n"
      "With a radius (m) the control points within it follow, the less the farther they are from "
      "the place, and fade out towards points that are held; the targets are met all the same. "
      "mirrored: the mesh is half of a hull, and what is pulled on the other side of y = 0 "
      "reaches over, so that the surface stays smooth across it.\n\n"
      "The surface itself is left as it is. ValueError naming the target where these limits allow "
      "no such move, or targets contradict one another.");
}

}  // namespace hull::bindings
