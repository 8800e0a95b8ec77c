// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/reshape.h"

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>

#include "bindings/arrays.h"
#include "bindings/move_limits.h"
#include "modelling/reshape/square_ties.h"

namespace hull::bindings {
namespace {

using modelling::Reshape;
using modelling::Reshaped;

// Whoever solves needs the places' positions to know what to wish.
struct BoundReshaped {
  Reshaped result;
  Vector3d largest_place;
  std::optional<Vector3d> folded_place;
};

std::vector<modelling::MoveCondition> conditions_from(const py::iterable& conditions) {
  std::vector<modelling::MoveCondition> result;
  for (const py::handle item : conditions) {
    const std::string name = "conditions[" + std::to_string(result.size()) + "]";
    try {
      const auto [points, slopes] = item.cast<std::tuple<py::object, DoubleArray>>();
      result.push_back({integers_from(points, (name + "[0]").c_str()),
                        points_from(slopes, (name + "[1]").c_str())});
    } catch (const py::cast_error&) {
      throw std::invalid_argument(name + " must be (control points (k,), slopes (k, 3)).");
    }
  }
  return result;
}

template <class Value, class Get>
std::vector<Value> of_places(const Reshape& reshape, const Get& get) {
  std::vector<Value> result;
  for (int k = 0; k < reshape.places().count(); ++k) result.push_back(get(reshape.places(), k));
  return result;
}

BoundReshaped solved(const Reshape& reshape, const DoubleArray& shifts,
                     const DoubleArray& prescribed, const DoubleArray& values) {
  const std::vector<Vector3d> wanted = points_from(shifts, "shifts"),
                              told = points_from(prescribed, "prescribed");
  const std::vector<double> of_conditions = numbers_from(values, "values");
  const py::gil_scoped_release release;
  BoundReshaped bound{reshape.solve(wanted, told, of_conditions), Vector3d::Zero(), {}};
  const Reshaped& result = bound.result;
  bound.largest_place = reshape.places().position(result.largest_place);
  if (result.folded_place >= 0) {
    bound.folded_place = reshape.places().position(result.folded_place);
  }
  return bound;
}

py::array_t<double> as_array(const Vector3d& point) { return py::array_t<double>(3, point.data()); }

void bind_result(py::module_& module) {
  py::class_<BoundReshaped>(module, "Reshaped", "How a surface comes to lie: Reshape.solve().")
      .def_property_readonly(
          "moves", [](const BoundReshaped& r) { return to_array(r.result.moves); },
          "(n, 3), m: of all control points.")
      .def_property_readonly(
          "rms", [](const BoundReshaped& r) { return r.result.rms; },
          "Root of the mean, by area, of the squared residual: of the wanted shifts less what the "
          "surface does, m.")
      .def_property_readonly(
          "largest", [](const BoundReshaped& r) { return r.result.largest; },
          "The largest residual, m.")
      .def_property_readonly(
          "largest_place", [](const BoundReshaped& r) { return as_array(r.largest_place); },
          "(3,), m: where on the surface, as it was, that is.")
      .def_property_readonly(
          "folded_place",
          [](const BoundReshaped& r) -> py::object {
            return r.folded_place ? py::object(as_array(*r.folded_place)) : py::none();
          },
          "(3,), m: where on the surface, as it was, it is turned over then; None: nowhere.");
}

}  // namespace

void bind_reshape(py::module_& module) {
  bind_result(module);
  py::class_<Reshape>(
      module, "Reshape",
      "Shifts of an exact surface, brought about by its control points: of all their moves within "
      "the limits those with the least mean squared residual by area, (1/A) ∫ |shift of the "
      "surface - wanted shift|² dA. Linear least squares, factored once, so that solve() may "
      "follow a slider.")
      .def(py::init([](const surface::LimitSurface& surface, const py::object& locked,
                       const py::object& held_points, const DoubleArray& held_normals,
                       const py::object& tied, const DoubleArray& tied_directions,
                       const py::object& prescribed, const py::iterable& conditions,
                       double stiffness) {
             modelling::ReshapeOptions options;
             options.limits.limits = limits_from(locked, held_points, held_normals);
             options.limits.tied = ties_from(tied, tied_directions);
             options.limits.prescribed = integers_from(prescribed, "prescribed");
             options.conditions = conditions_from(conditions);
             options.stiffness = stiffness;
             const py::gil_scoped_release release;
             return std::make_unique<Reshape>(surface, options);
           }),
           py::arg("surface"), py::kw_only(), py::arg("locked") = py::tuple(),
           py::arg("held_points") = py::tuple(), py::arg("held_normals") = py::tuple(),
           py::arg("tied") = py::tuple(), py::arg("tied_directions") = py::tuple(),
           py::arg("prescribed") = py::tuple(), py::arg("conditions") = py::tuple(),
           py::arg("stiffness") = 0.0,
           "locked (l,): control points that stay, bit by bit. held_points (h,), held_normals "
           "(h, 3): points that move across their normal only; a point may be there several times. "
           "tied (t, 2), tied_directions (t, 3): points, each with its leader, that move along the "
           "direction as much as that does. prescribed (p,): points that move as solve() is told. "
           "conditions: tuples (control points (k,), slopes (k, 3)): sums of slope · move to which "
           "solve() gives values. stiffness: its square, times the squared size of the mesh, times "
           "the thin-plate energy of the moves is added to the mean squared residual.\n\n"
           "The surface is read here and not kept. ValueError for what is none of these, and for "
           "conditions that depend on one another.")
      .def_property_readonly(
          "positions",
          [](const Reshape& r) {
            return to_array(of_places<Vector3d>(
                r, [](const auto& places, int k) { return places.position(k); }));
          },
          "(k, 3), m: the places where shifts are wanted.")
      .def_property_readonly(
          "cells",
          [](const Reshape& r) {
            return to_array(
                of_places<int>(r, [](const auto& places, int k) { return places.cell(k); }));
          },
          "(k,) their cells.")
      .def_property_readonly(
          "areas",
          [](const Reshape& r) {
            return to_array(
                of_places<double>(r, [](const auto& places, int k) { return places.area(k); }));
          },
          "(k,), m²: what each place stands for.")
      .def("solve", &solved, py::arg("shifts"), py::kw_only(), py::arg("prescribed") = py::tuple(),
           py::arg("values") = py::tuple(),
           "The Reshaped for shifts (k, 3), m, wanted at positions; prescribed (p, 3), m: moves of "
           "these points; values: of the conditions. ValueError where counts differ, and where the "
           "limits contradict the prescribed moves.");
  module.def(
      "square_ties",
      [](const surface::LimitSurface& surface) {
        std::vector<std::array<int, 2>> tied;
        std::vector<Vector3d> directions;
        for (const modelling::TiedPoint& tie : modelling::square_ties(surface)) {
          tied.push_back({tie.point, tie.leader});
          directions.push_back(tie.direction);
        }
        return py::make_tuple(to_array(tied), to_array(directions));
      },
      py::arg("surface"),
      "What keeps a half hull's surface square to the centre plane where it is so, as tied (t, 2) "
      "and tied_directions (t, 3) of Reshape: the neighbours of border points of two "
      "quadrilaterals. Points in the plane are to be held in it besides.");
}

}  // namespace hull::bindings
