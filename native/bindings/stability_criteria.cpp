// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_criteria.h"

#include <pybind11/stl.h>

#include <array>

#include "analysis/stability/weather_criterion.h"
#include "bindings/arrays.h"
#include "bindings/loads.h"

namespace hull::bindings {
namespace {

const char* name_of(analysis::CriterionOutcome outcome) {
  switch (outcome) {
    case analysis::CriterionOutcome::kPass:
      return "pass";
    case analysis::CriterionOutcome::kFail:
      return "fail";
    case analysis::CriterionOutcome::kNotComputed:
      break;
  }
  return "not computed";
}

void bind_criterion(py::module_& module) {
  using C = analysis::Criterion;
  py::class_<C>(module, "Criterion", "One requirement of a stability code.")
      .def_readonly("paragraph", &C::paragraph)
      .def_readonly("name", &C::name)
      .def_readonly("value", &C::value, "In `unit`; None where it is not computed.")
      .def_readonly("limit", &C::limit, "In `unit`.")
      .def_readonly("unit", &C::unit)
      .def_property_readonly(
          "bound",
          [](const C& c) { return c.bound == C::Bound::kAtLeast ? "at least" : "at most"; },
          "\"at least\" or \"at most\": how the value has to be to the limit.")
      .def_property_readonly(
          "outcome", [](const C& c) { return name_of(c.outcome); },
          "\"pass\", \"fail\" or \"not computed\".")
      .def_readonly("note", &C::note, "What else is to be said, or empty.");
}

void bind_report(py::module_& module) {
  using R = analysis::StabilityReport;
  py::class_<R>(module, "StabilityReport", "Requirements, and whether the ship meets all of them.")
      .def_readonly("criteria", &R::criteria, "A list of Criterion.")
      .def_readonly("passes", &R::passes)
      .def_readonly("downflooding_heel", &R::downflooding_heel, "rad; None if none below 90°.")
      .def_readonly("can_flood", &R::can_flood, "Whether there was anything that could flood her.")
      .def_readonly("deck_edge_heel", &R::deck_edge_heel,
                    "rad: where the deck edge comes under water; 0 if it is so upright.")
      .def_readonly("has_deck_edge", &R::has_deck_edge, "Whether there was an edge to look for.")
      .def_readonly("evaluations", &R::evaluations, "Immersions computed.");
}

void bind_roll(py::module_& module) {
  using A = analysis::AngleOfRoll;
  py::class_<A>(module, "AngleOfRoll", "By the 2008 IS Code, Part A, 2.3.4: 109° k X1 X2 √(r s).")
      .def_readonly("angle", &A::angle, "φ1, rad.")
      .def_readonly("k", &A::k)
      .def_readonly("x1", &A::x1)
      .def_readonly("x2", &A::x2)
      .def_readonly("r", &A::r)
      .def_readonly("s", &A::s)
      .def_readonly("period", &A::period, "T, s.")
      .def_readonly("out_of_range", &A::out_of_range,
                    "A sentence for a ship that the code's tables are not meant for, or empty.");
}

void bind_weather_class(py::module_& module) {
  using W = analysis::WeatherCriterion;
  py::class_<W>(module, "WeatherCriterion",
                "The ship under the wind; angles in rad, to starboard. None: could not be had.")
      .def_readonly("wind_area", &W::wind_area, "A, m².")
      .def_readonly("wind_lever", &W::wind_lever, "Z, m.")
      .def_readonly("steady_lever", &W::steady_lever, "lw1, m.")
      .def_readonly("gust_lever", &W::gust_lever, "lw2, m.")
      .def_readonly("draft", &W::draft, "d, m.")
      .def_readonly("beam", &W::beam, "B, m.")
      .def_readonly("waterline_length", &W::waterline_length, "Lwl, m.")
      .def_readonly("block_coefficient", &W::block_coefficient, "∇ / (Lwl B d).")
      .def_readonly("roll", &W::roll, "AngleOfRoll.")
      .def_readonly("steady_heel", &W::steady_heel, "φ0.")
      .def_readonly("windward_heel", &W::windward_heel, "φ0 - φ1.")
      .def_readonly("gust_heel", &W::gust_heel, "First intercept of GZ and lw2.")
      .def_readonly("second_intercept", &W::second_intercept, "φc, of the same.")
      .def_readonly("downflooding_heel", &W::downflooding_heel, "φf.")
      .def_readonly("last_heel", &W::last_heel, "φ2, the least of φf, 50° and φc.")
      .def_readonly("deck_edge_heel", &W::deck_edge_heel)
      .def_readonly("area_a", &W::area_a, "m·rad.")
      .def_readonly("area_b", &W::area_b, "m·rad.")
      .def_readonly("criteria", &W::criteria, "A list of two Criterion.")
      .def_readonly("passes", &W::passes)
      .def_readonly("evaluations", &W::evaluations, "Immersions computed for the curve.");
}

void bind_weather_criterion(py::module_& module) {
  bind_roll(module);
  bind_weather_class(module);
  module.def(
      "weather_criterion",
      [](const analysis::HullBody& body, double mass_t, const DoubleArray& centre_of_gravity,
         double water_density, bool free_trim, double trim,
         const std::optional<DoubleArray>& downflooding_points, const py::object& deck_edge,
         bool hull_profile, const std::vector<std::array<double, 2>>& wind_areas,
         std::optional<double> wind_lever, double wind_pressure, double midship,
         std::optional<double> beam, double keel_area, bool sharp_bilges,
         std::optional<double> roll_period) {
        const analysis::LoadCase load = load_from(mass_t, centre_of_gravity, water_density);
        analysis::WeatherOptions options;
        options.stability = {mode_of(free_trim), trim, edges_from(downflooding_points, deck_edge)};
        options.hull_profile = hull_profile;
        for (const auto& [area, z] : wind_areas) options.wind_areas.push_back({area, z});
        options.wind_lever = wind_lever;
        options.wind_pressure = wind_pressure;
        options.midship = midship;
        options.beam = beam.value_or(0.0);
        options.keel_area = keel_area;
        options.sharp_bilges = sharp_bilges;
        options.roll_period = roll_period;
        const py::gil_scoped_release release;
        return analysis::weather_criterion(body, load, options);
      },
      py::arg("body"), py::kw_only(), py::arg("mass_t"), py::arg("centre_of_gravity"),
      py::arg("water_density") = analysis::kSeaWaterDensity, py::arg("free_trim") = true,
      py::arg("trim") = 0.0, py::arg("downflooding_points") = py::none(),
      py::arg("deck_edge") = py::none(), py::arg("hull_profile") = true,
      py::arg("wind_areas") = std::vector<std::array<double, 2>>{},
      py::arg("wind_lever") = py::none(), py::arg("wind_pressure") = 504.0,
      py::arg("midship") = 0.0, py::arg("beam") = py::none(), py::arg("keel_area") = 0.0,
      py::arg("sharp_bilges") = false, py::arg("roll_period") = py::none(),
      "The severe wind and rolling criterion of the 2008 IS Code (MSC.267(85)), Part A, 2.3, for "
      "wind from port, as a WeatherCriterion.\n\nLoad, trim, downflooding_points and deck_edge as "
      "in righting_levers(). The wind area is the profile of the hull above the water "
      "(hull_profile) and wind_areas, pairs of an area (m²) and its centre's height above the base "
      "line (m). Its lever is from its centre to that of the underwater profile, or wind_lever "
      "(m). "
      "wind_pressure in Pa; midship (m): x of the mean draft; beam (m): moulded, else that of "
      "the "
      "waterline; keel_area (m²) of bilge and bar keels; roll_period (s), else estimated. Raises "
      "ValueError where the ship sinks, and for what is not positive.");
}

}  // namespace

void bind_stability_criteria(py::module_& module) {
  bind_criterion(module);
  bind_report(module);
  module.def(
      "stability_criteria",
      [](const analysis::HullBody& body, double mass_t, const DoubleArray& centre_of_gravity,
         double water_density, bool free_trim, double trim,
         const std::optional<DoubleArray>& downflooding_points, const py::object& deck_edge) {
        const analysis::LoadCase load = load_from(mass_t, centre_of_gravity, water_density);
        const analysis::StabilityOptions options{mode_of(free_trim), trim,
                                                 edges_from(downflooding_points, deck_edge)};
        const py::gil_scoped_release release;
        return analysis::stability_criteria(body, load, options);
      },
      py::arg("body"), py::kw_only(), py::arg("mass_t"), py::arg("centre_of_gravity"),
      py::arg("water_density") = analysis::kSeaWaterDensity, py::arg("free_trim") = true,
      py::arg("trim") = 0.0, py::arg("downflooding_points") = py::none(),
      py::arg("deck_edge") = py::none(),
      "The intact criteria of the 2008 IS Code (MSC.267(85)), Part A, 2.2, for heels to starboard, "
      "as a StabilityReport.\n\nmass_t in t, centre_of_gravity (x, y, z) in m, water_density in "
      "t/m³; downflooding_points (n, 3), m, of both sides; deck_edge as in righting_levers(). A "
      "ship that is not symmetric, or not so "
      "loaded, is to be asked for both sides, the second time mirrored.");
  bind_weather_criterion(module);
}

}  // namespace hull::bindings
