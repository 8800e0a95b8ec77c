// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit.h"

#include <pybind11/stl.h>

#include <stdexcept>
#include <string>
#include <tuple>

#include "bindings/arrays.h"
#include "bindings/move_limits.h"
#include "bindings/progress.h"

namespace hull::bindings {
namespace {

std::vector<modelling::FitCurve> curves_from(const py::iterable& curves) {
  std::vector<modelling::FitCurve> result;
  for (const py::handle item : curves) {
    const std::string name = "curves[" + std::to_string(result.size()) + "]";
    try {
      const auto [points, chain, whole] = item.cast<std::tuple<DoubleArray, py::object, bool>>();
      result.push_back({points_from(points, (name + "[0]").c_str()),
                        chain.is_none() ? modelling::FitCurve::kNearest : chain.cast<int>(),
                        whole});
    } catch (const py::cast_error&) {
      throw std::invalid_argument(name +
                                  " must be (points, number of a crease curve or None, "
                                  "whether its ends are the curve's ends).");
    }
  }
  return result;
}

modelling::FitTarget target_from(const DoubleArray& targets, const py::object& normals,
                                 const py::object& weights) {
  modelling::FitTarget target{points_from(targets, "targets"), {}, {}};
  if (!normals.is_none()) target.normals = points_from(DoubleArray(normals), "normals");
  if (!weights.is_none()) target.weights = numbers_from(DoubleArray(weights), "weights");
  return target;
}

std::vector<modelling::FitSum> sums_from(const py::iterable& sums) {
  std::vector<modelling::FitSum> result;
  for (const py::handle item : sums) {
    const std::string name = "sums[" + std::to_string(result.size()) + "]";
    try {
      const auto [points, weights, rest] =
          item.cast<std::tuple<py::object, DoubleArray, DoubleArray>>();
      result.push_back({integers_from(points, (name + "[0]").c_str()),
                        numbers_from(weights, (name + "[1]").c_str()),
                        point_from(rest, (name + "[2]").c_str())});
    } catch (const py::cast_error&) {
      throw std::invalid_argument(name + " must be (points, weights, rest).");
    }
  }
  return result;
}

void bind_fit_result(py::module_& module) {
  py::class_<modelling::Fit>(module, "Fit", "A surface drawn onto targets: fit_surface().")
      .def_property_readonly(
          "points", [](const modelling::Fit& f) { return to_array(f.points); },
          "(n, 3), m: the control points.")
      .def_property_readonly(
          "distances", [](const modelling::Fit& f) { return to_array(f.distances); },
          "(k,), m: of the targets from the surface, positive on the side of its normals; NaN for "
          "those left out.")
      .def_readonly("counted", &modelling::Fit::counted, "How many targets were not left out.")
      .def_readonly("rms", &modelling::Fit::rms, "Root of the mean squared distance of these, m.")
      .def_readonly("largest", &modelling::Fit::largest, "The largest distance of these, m.")
      .def_readonly("largest_target", &modelling::Fit::largest_target,
                    "Its target; -1 without any.")
      .def_property_readonly(
          "largest_place",
          [](const modelling::Fit& f) { return py::array_t<double>(3, f.largest_place.data()); },
          "(3,), m: where on the surface that is.")
      .def_property_readonly(
          "curve_distances", [](const modelling::Fit& f) { return to_array(f.curve_distances); },
          "Of the points of all curves, in order, from the creases, m; NaN for those left out.")
      .def_readonly("curve_rms", &modelling::Fit::curve_rms, "m.")
      .def_readonly("curve_largest", &modelling::Fit::curve_largest, "m.")
      .def_readonly("energy", &modelling::Fit::energy,
                    "Thin-plate energy of the surface, the integral of the squared principal "
                    "curvatures: a number.")
      .def_readonly("steps", &modelling::Fit::steps)
      .def_readonly("settled", &modelling::Fit::settled,
                    "Whether the fit ended by itself, not by most_steps.");
}

}  // namespace

void bind_fit(py::module_& module) {
  bind_fit_result(module);
  module.def(
      "fit_surface",
      [](const surface::LimitSurface& surface, const DoubleArray& targets,
         const py::object& normals, const py::object& weights, const py::iterable& curves,
         const py::object& locked, const py::object& held_points, const DoubleArray& held_normals,
         const py::object& tied, const DoubleArray& tied_directions, const py::iterable& kept,
         double fairness, double stiffness, double curve_weight, const py::iterable& sums,
         double reach, bool draw_border, int most_steps, double least_move,
         const py::object& progress) {
        const modelling::FitTarget target = target_from(targets, normals, weights);
        const std::vector<modelling::FitCurve> along = curves_from(curves);
        modelling::FitOptions options;
        options.limits =
            limits_from(locked, held_points, held_normals, tied, tied_directions, kept);
        options.fairness = fairness;
        options.stiffness = stiffness;
        options.curve_weight = curve_weight;
        options.sums = sums_from(sums);
        options.reach = reach;
        options.draw_border = draw_border;
        options.most_steps = most_steps;
        options.least_move = least_move;
        options.progress = progress_from(progress);
        const py::gil_scoped_release release;
        return modelling::fit(surface, target, along, options);
      },
      py::arg("surface"), py::arg("targets"), py::kw_only(), py::arg("normals") = py::none(),
      py::arg("weights") = py::none(), py::arg("curves") = py::tuple(),
      py::arg("locked") = py::tuple(), py::arg("held_points") = py::tuple(),
      py::arg("held_normals") = py::tuple(), py::arg("tied") = py::tuple(),
      py::arg("tied_directions") = py::tuple(), py::arg("kept") = py::tuple(),
      py::arg("fairness") = modelling::FitOptions().fairness,
      py::arg("stiffness") = modelling::FitOptions().stiffness,
      py::arg("curve_weight") = modelling::FitOptions().curve_weight, py::arg("sums") = py::tuple(),
      py::arg("reach") = modelling::FitOptions().reach, py::arg("draw_border") = false,
      py::arg("most_steps") = modelling::FitOptions().most_steps,
      py::arg("least_move") = modelling::FitOptions().least_move, py::arg("progress") = py::none(),
      "The Fit of the surface to targets (k, 3), m: control points for which the mean squared "
      "distance of the targets from the exact surface, that of curves from creases, and the "
      "bending of the surface are the least. The surface itself is left as it is.\n\n"
      "normals (k, 3): the targets' own, turned as the surface's are; a target counts only where "
      "the surface's normal is within 60 degrees of it. weights (k,): what targets count for. "
      "curves: tuples (points (n, 3), number in "
      "crease_curves() or None, whole): creases and borders go along these lines; None takes, for "
      "each point, the nearest crease of the line's direction; whole brings the crease's ends to "
      "the line's ends. locked (n,): control points that stay. held_points (h,), held_normals "
      "(h, 3): points that move across their normal only; a point may be there several times. "
      "fairness: its square, times the squared size of the mesh, times the thin-plate energy is "
      "added to the mean squared distance; 0 for none. stiffness: the same for the energy "
      "of the moves, which keeps the control points' layout. curve_weight: of the curves' mean "
      "squared distance. sums: tuples (control points (k,), weights (k,), rest (3,)): the squared "
      "distance of each weighted sum from its rest, m, is added. reach, m: what is "
      "farther from the surface is left out. draw_border: whether targets beyond the surface's "
      "border draw it, rather than being left out. most_steps; least_move: of the mesh's size; the "
      "fit ends when no control point moves more. progress: a callable that takes the share done, "
      "0 to 1; what it raises ends the fit.\n\n"
      "ValueError for what is none of these, or when no target counts.");
}

}  // namespace hull::bindings
