// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/targets/targets.h"

#include <pybind11/stl.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

#include "bindings/arrays.h"
#include "bindings/move_limits.h"
#include "bindings/openings.h"
#include "bindings/progress.h"

namespace hull::bindings {
namespace {

using modelling::FormTarget;
using modelling::TargetOutcome;
using modelling::TargetsReached;

using Place = std::tuple<int, double, double>;

FormTarget target_of(const std::string& name, std::optional<double> station,
                     std::optional<double> speed, const std::optional<Place>& place,
                     const std::array<double, 3>& direction) {
  FormTarget target;
  target.is_section = name == "section_area";
  // Given with another name it would be left unused in silence.
  if (target.is_section != station.has_value()) {
    throw std::invalid_argument("A station is given with \"section_area\", and with it only.");
  }
  if ((name == "coordinate") != place.has_value()) {
    throw std::invalid_argument("A place is given with \"coordinate\", and with it only.");
  }
  if ((name == "wave_resistance") != speed.has_value()) {
    throw std::invalid_argument("A speed is given with \"wave_resistance\", and with it only.");
  }
  if (speed) {
    target.wave_speed = speed;
  } else if (target.is_section) {
    target.station = *station;
  } else if (place) {
    const auto& [cell, u, v] = *place;
    target.coordinate = FormTarget::Coordinate{cell, {u, v}, Eigen::Vector3d(direction.data())};
  } else {
    target.number = analysis::form_number_named(name);
  }
  return target;
}

FormTarget target_from(const std::string& name, double value, double tolerance,
                       const std::string& sense, std::optional<double> station,
                       std::optional<double> speed, const std::optional<Place>& place,
                       const std::array<double, 3>& direction, double weight) {
  FormTarget target = target_of(name, station, speed, place, direction);
  if (!std::isfinite(value) || !(tolerance >= 0.0) || !std::isfinite(tolerance)) {
    throw std::invalid_argument("The wanted value of " + name +
                                " must be a number, and its tolerance 0 or more.");
  }
  if (sense != "equal" && sense != "at least" && sense != "at most") {
    throw std::invalid_argument(
        "A target's sense is \"equal\", \"at least\" or \"at most\", not \"" + sense + "\".");
  }
  if (sense != "at most") target.low = value - tolerance;
  if (sense != "at least") target.high = value + tolerance;
  target.weight = weight;
  return target;
}

modelling::ScaleBounds bounds_from(const std::array<double, 2>& bounds) {
  return {bounds[0], bounds[1]};
}

const char* name_of(modelling::TargetStatus status) {
  switch (status) {
    case modelling::TargetStatus::kMet:
      return "met";
    case modelling::TargetStatus::kUnreachable:
      return "unreachable";
    case modelling::TargetStatus::kFolded:
      return "folded";
    default:
      return "unsettled";
  }
}

template <class Get>
py::array_t<double> of_targets(const TargetsReached& reached, const Get& get) {
  std::vector<double> values;
  for (const TargetOutcome& target : reached.targets) values.push_back(get(target));
  return to_array(values);
}

void bind_target(py::module_& module) {
  py::class_<FormTarget>(module, "FormTarget", "A number of a hull's form and what it is to be.")
      .def(py::init(&target_from), py::arg("name"), py::arg("value"), py::kw_only(),
           py::arg("tolerance") = 0.0, py::arg("sense") = "equal", py::arg("station") = py::none(),
           py::arg("speed") = py::none(), py::arg("place") = py::none(),
           py::arg("direction") = std::array<double, 3>{0.0, 1.0, 0.0}, py::arg("weight") = 1.0,
           "name: one of FORM_NUMBERS, \"section_area\" of the station at x = station, "
           "\"wave_resistance\" by Michell's integral at a speed in m/s, kN, or "
           "\"coordinate\" of the surface along a direction at place = (cell, u, v), before "
           "dimensions are scaled. sense: \"equal\", \"at least\" or \"at most\" the value, by the "
           "tolerance more or less. "
           "weight: where not all targets can be met those of more weight are rather met. "
           "ValueError for what is none.")
      .def_readonly("low", &FormTarget::low)
      .def_readonly("high", &FormTarget::high)
      .def_readonly("weight", &FormTarget::weight);
}

void bind_reached(py::module_& module) {
  py::class_<TargetsReached>(module, "TargetsReached", "How reach_targets() ended.")
      .def_property_readonly(
          "status", [](const TargetsReached& r) { return name_of(r.status); },
          "\"met\": all targets, at the least cost. \"unreachable\": not all can be met, and what "
          "is reached is nearest. \"folded\": further moves would turn the surface over. "
          "\"unsettled\": no progress any longer.")
      .def_readonly("iterations", &TargetsReached::iterations)
      .def_property_readonly(
          "moves", [](const TargetsReached& r) { return to_array(r.moves); },
          "(n, 3), m: of all control points, scaling included.")
      .def_property_readonly(
          "scale", [](const TargetsReached& r) { return py::array_t<double>(3, r.scale.data()); },
          "(3,): by which length, beam and draft are scaled.")
      .def_property_readonly(
          "before",
          [](const TargetsReached& r) {
            return of_targets(r, [](const TargetOutcome& t) { return t.before; });
          },
          "(t,): the targets' numbers before.")
      .def_property_readonly(
          "reached",
          [](const TargetsReached& r) {
            return of_targets(r, [](const TargetOutcome& t) { return t.reached; });
          },
          "(t,): and as they are reached.")
      .def_property_readonly(
          "misses",
          [](const TargetsReached& r) {
            return of_targets(r, [](const TargetOutcome& t) { return t.miss; });
          },
          "(t,): how far out of their bounds, with sign; 0 where met.")
      .def_property_readonly(
          "prices",
          [](const TargetsReached& r) {
            return of_targets(r, [](const TargetOutcome& t) { return t.price; });
          },
          "(t,): what the cost would rise by per unit of the bound, m²; 0 for those that do not "
          "bind.")
      .def_property_readonly(
          "most_prices",
          [](const TargetsReached& r) {
            return of_targets(r, [](const TargetOutcome& t) { return t.most_price; });
          },
          "(t,): what is paid for a miss at most, m² per unit: what is reached has the least sum "
          "of "
          "the cost and of the misses at these prices.")
      .def_readonly("scale_prices", &TargetsReached::scale_prices,
                    "Of the limits of length, beam and draft; 0 for those that do not bind.")
      .def_readonly("cost", &TargetsReached::cost,
                    "Half the mean squared shift, bending and scaling added, m².")
      .def_readonly("rms", &TargetsReached::rms,
                    "Root mean square, by area, of the surface's shift but for scaling, m.")
      .def_property_readonly(
          "folded_place",
          [](const TargetsReached& r) -> py::object {
            if (!r.folded_place) return py::none();
            return py::array_t<double>(3, r.folded_place->data());
          },
          "(3,), m: where the surface would be turned over, or None.");
}

}  // namespace

void bind_targets(py::module_& module) {
  bind_target(module);
  bind_reached(module);
  module.def(
      "reach_targets",
      [](const surface::LimitSurface& surface, const std::vector<FormTarget>& targets,
         bool mirrored, double draft, const std::string& openings, double trim,
         std::optional<double> draft_at, std::optional<double> length_pp,
         std::optional<double> beam, std::optional<double> design_draft, double water_density,
         const py::object& locked, const py::object& held_points, const DoubleArray& held_normals,
         const py::object& tied, const DoubleArray& tied_directions, const py::iterable& kept,
         const py::iterable& modes, double stiffness, const std::array<double, 2>& length_scale,
         const std::array<double, 2>& beam_scale, const std::array<double, 2>& draft_scale,
         double scale_cost, const modelling::SurfacePlaces* places, const py::object& progress) {
        modelling::TargetOptions options;
        options.water.mirrored = mirrored;
        options.water.openings = openings_from(openings);
        options.water.project = {length_pp.value_or(0.0), beam.value_or(0.0),
                                 design_draft.value_or(0.0)};
        const double at = draft_at.value_or(0.5 * options.water.project.length_pp);
        options.water.position = {draft, trim, 0.0, at};
        options.water.density = water_density;
        options.limits =
            limits_from(locked, held_points, held_normals, tied, tied_directions, kept);
        for (const py::handle mode : modes) {
          options.modes.push_back(
              points_from(DoubleArray(py::reinterpret_borrow<py::object>(mode)), "modes"));
        }
        options.stiffness = stiffness;
        options.scales = {bounds_from(length_scale), bounds_from(beam_scale),
                          bounds_from(draft_scale)};
        options.scale_cost = scale_cost;
        if (places) options.weights = places->weights();
        const surface::Progress told = progress_from(progress);
        const py::gil_scoped_release release;
        return modelling::reach_targets(surface, targets, options, told);
      },
      py::arg("surface"), py::arg("targets"), py::kw_only(), py::arg("mirrored"), py::arg("draft"),
      py::arg("openings") = "closed", py::arg("trim") = 0.0, py::arg("draft_at") = py::none(),
      py::arg("length_pp") = py::none(), py::arg("beam") = py::none(),
      py::arg("design_draft") = py::none(), py::arg("water_density") = analysis::kSeaWaterDensity,
      py::arg("locked") = py::tuple(), py::arg("held_points") = py::tuple(),
      py::arg("held_normals") = py::tuple(), py::arg("tied") = py::tuple(),
      py::arg("tied_directions") = py::tuple(), py::arg("kept") = py::tuple(),
      py::arg("modes") = py::tuple(), py::arg("stiffness") = 0.05,
      py::arg("length_scale") = std::array<double, 2>{1.0, 1.0},
      py::arg("beam_scale") = std::array<double, 2>{1.0, 1.0},
      py::arg("draft_scale") = std::array<double, 2>{1.0, 1.0}, py::arg("scale_cost") = 0.01,
      py::arg("places") = py::none(), py::arg("progress") = py::none(),
      "The TargetsReached of the least change of a hull by which the targets, FormTargets, are "
      "met. "
      "The surface stays as it is.\n\n"
      "Water, openings and project dimensions as hydrostatics() has them. locked, held_points, "
      "held_normals, tied, tied_directions, kept: as Reshape has them. modes: moves (n, 3) of all "
      "control points; if there are any, sums of these are taken instead, without limits. "
      "stiffness: its square, times the squared size of the mesh, times the thin-plate energy of "
      "the moves is added to the mean squared shift. length_scale, beam_scale, draft_scale: "
      "limits of factors that hull, water and project dimensions are scaled by together, from the "
      "after perpendicular, the centre plane and the base line; scale_cost times the mean squared "
      "shift that it makes is added. places: the SurfacePlaces, three a side, of a surface that "
      "differs in its control points only, by which all is sooner prepared, with the same result. "
      "progress: called with the share of what was missing that is met; what it raises ends the "
      "task.\n\n"
      "ValueError for what is none of these: a hull that floods, limits by which nothing may move, "
      "scaling with trim or with locked points, places of another surface.");
}

}  // namespace hull::bindings
