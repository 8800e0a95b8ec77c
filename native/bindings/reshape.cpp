// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/reshape.h"

#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "bindings/arrays.h"
#include "bindings/move_limits.h"
#include "bindings/surface_places.h"
#include "modelling/reshape/allowed_moves.h"
#include "modelling/reshape/crease_moves.h"
#include "modelling/reshape/square_sums.h"
#include "modelling/reshape/square_ties.h"

namespace hull::bindings {
namespace {

using modelling::Reshape;
using modelling::Reshaped;
using modelling::SurfacePlaces;

// Whoever solves needs the places' positions to know what to wish.
struct BoundReshaped {
  Reshaped result;
  Vector3d largest_place;
  std::optional<Vector3d> folded_place;
};

void refuse_folds(const Reshape& reshape, const std::vector<Eigen::Matrix3d>& gradients) {
  const modelling::SurfacePlaces& places = reshape.places();
  if (static_cast<int>(gradients.size()) != places.count()) {
    throw std::invalid_argument("There must be " + std::to_string(places.count()) +
                                " gradients, not " + std::to_string(gradients.size()) + ".");
  }
  const int folded = modelling::first_folded(gradients);
  if (folded < 0) return;
  const Vector3d& at = places.position(folded);
  std::ostringstream text;
  text << "The wanted shift folds the hull at x " << at.x() << ", y " << at.y() << ", z " << at.z()
       << " m: ask for less, or for a shift that reaches further.";
  throw std::invalid_argument(text.str());
}

BoundReshaped solved(const Reshape& reshape, const DoubleArray& shifts,
                     const DoubleArray& prescribed, const DoubleArray& values,
                     const py::object& gradients) {
  const std::vector<Vector3d> wanted = points_from(shifts, "shifts"),
                              told = points_from(prescribed, "prescribed");
  const std::vector<double> of_conditions = numbers_from(values, "values");
  if (!gradients.is_none()) {
    // Before anything is solved: the control points could only follow a shift that folds.
    refuse_folds(reshape, gradients_from(DoubleArray(gradients)));
  }
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

surface::CreaseCurve crease_of(const surface::LimitSurface& surface, int number) {
  const std::vector<surface::CreaseCurve> curves = surface::crease_curves(surface);
  if (number < 0 || number >= static_cast<int>(curves.size())) {
    throw std::invalid_argument("There is no crease " + std::to_string(number) + " among " +
                                std::to_string(curves.size()) + " of the surface.");
  }
  return curves[number];
}

void bind_reshaped(py::module_& module) {
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
  bind_reshaped(module);
  py::class_<Reshape>(
      module, "Reshape",
      "Shifts of an exact surface, brought about by its control points: of all their moves within "
      "the limits those with the least mean squared residual by area, (1/A) ∫ |shift of the "
      "surface - wanted shift|² dA. Linear least squares, factored once, so that solve() may "
      "follow a slider. It keeps to the surface as it is when made.")
      .def(
          py::init([](const surface::LimitSurface& surface, const py::object& locked,
                      const py::object& held_points, const DoubleArray& held_normals,
                      const py::object& tied, const DoubleArray& tied_directions,
                      const py::object& prescribed, const py::iterable& kept,
                      const py::iterable& conditions, double stiffness,
                      const SurfacePlaces* places) {
            modelling::ReshapeOptions options;
            options.limits =
                limits_from(locked, held_points, held_normals, tied, tied_directions, kept);
            options.limits.prescribed = integers_from(prescribed, "prescribed");
            options.conditions = conditions_from(conditions, "conditions");
            options.stiffness = stiffness;
            if (places) options.weights = places->weights();
            const py::gil_scoped_release release;
            return std::make_unique<Reshape>(surface, options);
          }),
          py::arg("surface"), py::kw_only(), py::arg("locked") = py::tuple(),
          py::arg("held_points") = py::tuple(), py::arg("held_normals") = py::tuple(),
          py::arg("tied") = py::tuple(), py::arg("tied_directions") = py::tuple(),
          py::arg("prescribed") = py::tuple(), py::arg("kept") = py::tuple(),
          py::arg("conditions") = py::tuple(), py::arg("stiffness") = 0.0,
          py::arg("places") = py::none(),
          "locked (l,): control points that stay, bit by bit. held_points (h,), held_normals "
          "(h, 3): points that move across their normal only; a point may be there several times. "
          "tied (t, 2), tied_directions (t, 3): points, each with its leader, that move along the "
          "direction as much as that does. prescribed (p,): points that move as solve() is told. "
          "kept: tuples (control points (k,), slopes (k, 3)): sums of slope · move that stay zero. "
          "conditions: tuples as these, to whose sums solve() gives values. stiffness: its square, "
          "times the squared size of the mesh, times the thin-plate energy of the moves is added "
          "to the mean squared residual. places: the SurfacePlaces of a surface that differs in "
          "its control points only, by which all is much sooner prepared.\n\n"
          "The surface is read here and not kept. ValueError for what is none of these, and for "
          "conditions that depend on one another.")
      .def_property_readonly(
          "places", [](const Reshape& r) { return r.places(); },
          "The SurfacePlaces where shifts are wanted.")
      .def_property_readonly(
          "positions", [](const Reshape& r) { return positions(r.places()); },
          "(k, 3), m: the places where shifts are wanted.")
      .def_property_readonly(
          "cells", [](const Reshape& r) { return cells(r.places()); }, "(k,) their cells.")
      .def_property_readonly(
          "areas", [](const Reshape& r) { return areas(r.places()); },
          "(k,), m²: what each place stands for.")
      .def("solve", &solved, py::arg("shifts"), py::kw_only(), py::arg("prescribed") = py::tuple(),
           py::arg("values") = py::tuple(), py::arg("gradients") = py::none(),
           "The Reshaped for shifts (k, 3), m, wanted at positions; prescribed (p, 3), m: moves of "
           "these points; values: of the conditions; gradients (k, 3, 3), where they are known: "
           "derivatives of the shifts' components (rows) by x, y and z. ValueError where counts "
           "differ, where the limits contradict the prescribed moves, and, with the place, where "
           "the wanted shift itself folds space, det(1 + gradient) <= 0.");
  module.def(
      "allowed_moves",
      [](const surface::LimitSurface& surface, const py::object& points, const DoubleArray& moves,
         const py::object& locked, const py::object& held_points, const DoubleArray& held_normals,
         const py::object& tied, const DoubleArray& tied_directions, const py::iterable& kept) {
        const modelling::MoveSpace space(
            limits_from(locked, held_points, held_normals, tied, tied_directions, kept),
            static_cast<int>(surface.mesh().points().size()));
        return to_array(modelling::allowed_moves(space, integers_from(points, "points"),
                                                 points_from(moves, "moves")));
      },
      py::arg("surface"), py::arg("points"), py::arg("moves"), py::kw_only(),
      py::arg("locked") = py::tuple(), py::arg("held_points") = py::tuple(),
      py::arg("held_normals") = py::tuple(), py::arg("tied") = py::tuple(),
      py::arg("tied_directions") = py::tuple(), py::arg("kept") = py::tuple(),
      "The moves (p, 3), m, of control points (p,) that are nearest to these moves, in least "
      "squares, of all that the limits allow, which are those of Reshape: prescribed there they "
      "are never refused.");
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
  module.def(
      "square_sums",
      [](const surface::LimitSurface& surface) {
        py::list sums;
        for (const modelling::MoveCondition& sum :
             modelling::square_sums(surface, modelling::square_ties(surface))) {
          sums.append(py::make_tuple(to_array(sum.points), to_array(sum.slopes)));
        }
        return sums;
      },
      py::arg("surface"),
      "What keeps it so, besides square_ties, beside border points in the plane of one, three or "
      "more faces, of other faces than quadrilaterals, and corners: as kept of Reshape.");
  module.def(
      "crease_moves",
      [](const surface::LimitSurface& surface, int crease, const DoubleArray& t,
         const DoubleArray& shifts, const py::object& staying) {
        const modelling::CreaseMoves found = modelling::crease_moves(
            surface, crease_of(surface, crease), numbers_from(t, "t"),
            points_from(shifts, "shifts"), integers_from(staying, "staying"));
        return py::make_tuple(to_array(found.points), to_array(found.moves), found.distance,
                              found.t);
      },
      py::arg("surface"), py::arg("crease"), py::arg("t"), py::arg("shifts"), py::kw_only(),
      py::arg("staying") = py::tuple(),
      "How the control points of one of crease_curves(), by its number, move so that its points "
      "at t (k,) shift by shifts (k, 3), m, in least squares: (points (p,), moves (p, 3), the "
      "largest distance left, m, and at which t). Prescribed in a Reshape they bring the crease "
      "there. A shift that is a spline of the crease's knots is met to rounding; ends that t names "
      "are met in any case. staying: control points that do not move. ValueError for a crease that "
      "ends in a dart.");
  module.def(
      "crease_shifts",
      [](const surface::LimitSurface& surface, int crease, const DoubleArray& t,
         const DoubleArray& moves) {
        return to_array(modelling::crease_shifts(surface, crease_of(surface, crease),
                                                 numbers_from(t, "t"),
                                                 points_from(moves, "moves")));
      },
      py::arg("surface"), py::arg("crease"), py::arg("t"), py::arg("moves"),
      "How far the points at t (k,) of one of crease_curves(), by its number, shift where its "
      "control points, in the order of its vertices (a corner where it both begins and ends once), "
      "move by moves (p, 3), m: (k, 3), m. "
      "ValueError for a crease that ends in a dart.");
}

}  // namespace hull::bindings
