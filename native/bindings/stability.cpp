// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <optional>

#include "analysis/immersion/floating_position.h"
#include "analysis/stability/cross_curves.h"
#include "analysis/stability/righting_levers.h"
#include "bindings/arrays.h"
#include "bindings/loads.h"
#include "bindings/progress.h"

namespace hull::bindings {
namespace {

// One number of each state.
template <typename Number>
py::array_t<double> column(const analysis::RightingLevers& levers, Number number) {
  py::array_t<double> result(static_cast<py::ssize_t>(levers.states.size()));
  auto out = result.mutable_unchecked<1>();
  py::ssize_t i = 0;
  for (const analysis::HeeledState& state : levers.states) out(i++) = number(state);
  return result;
}

py::array_t<double> drafts_at(const analysis::RightingLevers& levers, double x) {
  return column(levers, [x](const analysis::HeeledState& s) {
    return analysis::draft_in(s.immersion.water, x);
  });
}

void bind_righting_levers_class(py::module_& module) {
  using L = analysis::RightingLevers;
  py::class_<L>(module, "RightingLevers",
                "Righting levers over the heel; angles in rad, heel to starboard. What is not in "
                "the range of heels from 0 to the greatest asked for is None.")
      .def_property_readonly(
          "heels", [](const L& l) { return column(l, [](const auto& s) { return s.heel; }); },
          "(n,) rad.")
      .def_property_readonly(
          "levers",
          [](const L& l) { return column(l, [](const auto& s) { return s.righting_lever; }); },
          "(n,) GZ, m: positive rights a heel to starboard.")
      .def_property_readonly(
          "slopes", [](const L& l) { return column(l, [](const auto& s) { return s.slope; }); },
          "(n,) dGZ/dheel, m/rad.")
      .def_property_readonly(
          "trims", [](const L& l) { return column(l, [](const auto& s) { return s.trim; }); },
          "(n,) rad, by the stern.")
      .def("drafts", &drafts_at, py::arg("x"),
           "(n,) m, at x (m) on the ship's vertical; without meaning at 90° of heel.")
      .def_property_readonly(
          "immersions",
          [](const L& l) {
            std::vector<analysis::Immersion> all;
            for (const analysis::HeeledState& s : l.states) all.push_back(s.immersion);
            return all;
          },
          "A list of Immersion, one for each heel.")
      .def_readonly("gm", &L::gm, "dGZ/dheel upright, m.")
      .def_property_readonly(
          "greatest_lever",
          [](const L& l) {
            return l.greatest ? std::optional<double>(l.greatest->lever) : std::nullopt;
          },
          "m.")
      .def_property_readonly(
          "greatest_lever_heel",
          [](const L& l) {
            return l.greatest ? std::optional<double>(l.greatest->heel) : std::nullopt;
          },
          "rad.")
      .def_property_readonly(
          "greatest_lever_at_end", [](const L& l) { return l.greatest && l.greatest->at_end; },
          "Whether that is the range's end instead of a maximum.")
      .def_readonly("vanishing_heel", &L::vanishing_heel,
                    "rad: where the lever, positive before, is zero.")
      .def_readonly("deck_edge_heel", &L::deck_edge_heel,
                    "rad: where the deck edge comes under water.")
      .def_readonly("has_deck_edge", &L::has_deck_edge,
                    "Whether there is an edge to look for: a border along the ship, or one given.")
      .def_readonly(
          "downflooding_heel", &L::downflooding_heel,
          "rad: where a downflooding point, or an opening of the shell, comes under water.")
      .def_readonly("can_flood", &L::can_flood, "Whether there are any to look for.")
      .def_property_readonly(
          "areas", [](const L& l) { return to_array(l.areas); },
          "(k,) m·rad, one for each of the intervals asked for.")
      .def_readonly("curve_evaluations", &L::curve_evaluations,
                    "Immersions computed for the levers.")
      .def_readonly("evaluations", &L::evaluations, "Immersions computed in all.");
}

// A table of numbers, one row for each curve.
py::array_t<double> rows(const std::vector<analysis::CrossCurve>& curves,
                         std::vector<double> analysis::CrossCurve::*numbers) {
  const std::size_t width = curves.empty() ? 0 : (curves[0].*numbers).size();
  py::array_t<double> result({curves.size(), width});
  auto out = result.mutable_unchecked<2>();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (std::size_t j = 0; j < width; ++j) out(i, j) = (curves[i].*numbers)[j];
  }
  return result;
}

struct CrossCurves {
  std::vector<analysis::CrossCurve> curves;
  std::vector<double> displacements, heels;
};

void bind_cross_curves(py::module_& module) {
  using C = CrossCurves;
  py::class_<C>(module, "CrossCurves",
                "KN, righting levers about the base line, over displacements and heels.")
      .def_property_readonly(
          "displacements_t", [](const C& c) { return to_array(c.displacements); }, "(n,) t.")
      .def_property_readonly(
          "heels", [](const C& c) { return to_array(c.heels); }, "(k,) rad, to starboard.")
      .def_property_readonly(
          "levers", [](const C& c) { return rows(c.curves, &analysis::CrossCurve::levers); },
          "(n, k) KN, m. GZ = KN - KG sin(heel).")
      .def_property_readonly(
          "trims", [](const C& c) { return rows(c.curves, &analysis::CrossCurve::trims); },
          "(n, k) rad, by the stern.")
      .def_property_readonly(
          "lcg",
          [](const C& c) {
            std::vector<double> all;
            for (const analysis::CrossCurve& curve : c.curves) all.push_back(curve.lcg);
            return to_array(all);
          },
          "(n,) m: the centre of gravity under which trim was balanced, that of buoyancy upright.");
  module.def(
      "cross_curves",
      [](const analysis::HullBody& body, const DoubleArray& displacements, const DoubleArray& heels,
         double water_density, bool free_trim, double trim, double assumed_kg,
         const py::object& progress) {
        C result{{}, numbers_from(displacements, "displacements_t"), numbers_from(heels, "heels")};
        const surface::Progress told = progress_from(progress);
        const py::gil_scoped_release release;
        std::vector<double> volumes;
        for (double mass : result.displacements) {
          volumes.push_back(
              analysis::LoadCase{mass, Vector3d::Zero(), water_density}.displaced_volume());
        }
        result.curves = analysis::cross_curves(body, volumes, result.heels,
                                               {mode_of(free_trim), trim, assumed_kg, told});
        return result;
      },
      py::arg("body"), py::kw_only(), py::arg("displacements_t"), py::arg("heels"),
      py::arg("water_density") = analysis::kSeaWaterDensity, py::arg("free_trim") = true,
      py::arg("trim") = 0.0, py::arg("assumed_kg") = 0.0, py::arg("progress") = py::none(),
      "CrossCurves of a HullBody for displacements_t (n,) in t and heels (k,) in rad.\n\nWith free "
      "trim the ship is balanced on a centre of gravity at the x of the buoyancy upright at zero "
      "trim, at the height assumed_kg (m); levers are about the base line whatever that is. With "
      "free_trim=False trim (rad) is held. progress: a callable that takes the share done, 0 to 1; "
      "what it raises ends the work.");
}

}  // namespace

void bind_stability(py::module_& module) {
  bind_righting_levers_class(module);
  module.def(
      "righting_levers",
      [](const analysis::HullBody& body, double mass_t, const DoubleArray& centre_of_gravity,
         const DoubleArray& heels, double water_density, bool free_trim, double trim,
         const std::optional<DoubleArray>& downflooding_points, const py::object& deck_edge,
         const std::vector<std::array<double, 2>>& area_intervals, double area_tolerance) {
        const analysis::LoadCase load = load_from(mass_t, centre_of_gravity, water_density);
        const analysis::RightingLeverOptions options{mode_of(free_trim), trim,
                                                     edges_from(downflooding_points, deck_edge),
                                                     area_intervals, area_tolerance};
        const std::vector<double> all_heels = numbers_from(heels, "heels");
        const py::gil_scoped_release release;
        return analysis::righting_levers(body, load, all_heels, options);
      },
      py::arg("body"), py::kw_only(), py::arg("mass_t"), py::arg("centre_of_gravity"),
      py::arg("heels"), py::arg("water_density") = analysis::kSeaWaterDensity,
      py::arg("free_trim") = true, py::arg("trim") = 0.0,
      py::arg("downflooding_points") = py::none(), py::arg("deck_edge") = py::none(),
      py::arg("area_intervals") = std::vector<std::array<double, 2>>{},
      py::arg("area_tolerance") = 1e-9,
      "Righting levers of a HullBody at heels (n,), rad to starboard, as RightingLevers.\n\nmass_t "
      "in t, centre_of_gravity (x, y, z) in m, water_density in t/m³. The trim adjusts itself, or "
      "with free_trim=False is held at trim (rad). downflooding_points: (n, 3), m, of both sides. "
      "deck_edge: control points of whole creases or borders; by default the borders along the "
      "ship. area_intervals: pairs of heels (rad) between which GZ is integrated, to "
      "area_tolerance (m·rad). Raises ValueError where the ship sinks or stands on end.");
  bind_cross_curves(module);
}

}  // namespace hull::bindings
