// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/equilibrium.h"

#include <pybind11/stl.h>

#include <stdexcept>
#include <string>

#include "bindings/arrays.h"

namespace hull::bindings {
namespace {

const char* name_of(analysis::EquilibriumStatus status) {
  switch (status) {
    case analysis::EquilibriumStatus::kStable:
      return "stable";
    case analysis::EquilibriumStatus::kNeutral:
      return "neutral";
    case analysis::EquilibriumStatus::kUnstable:
      return "unstable";
    case analysis::EquilibriumStatus::kFloods:
      return "floods";
    case analysis::EquilibriumStatus::kSinks:
      return "sinks";
    case analysis::EquilibriumStatus::kNotConverged:
      break;
  }
  return "not converged";
}

analysis::EquilibriumOptions options_from(bool free_trim, bool free_heel, double trim, double heel,
                                          double draft_at, bool leave_unstable) {
  analysis::EquilibriumOptions options;
  options.free_trim = free_trim;
  options.free_heel = free_heel;
  options.start.trim = trim;
  options.start.heel = heel;
  options.start.draft_at = draft_at;
  options.leave_unstable = leave_unstable;
  return options;
}

std::vector<analysis::LoadCase> loads_from(const DoubleArray& masses, const DoubleArray& centres,
                                           double water_density) {
  const std::vector<double> all_masses = numbers_from(masses, "masses_t");
  const std::vector<Eigen::Vector3d> all_centres = points_from(centres, "centres_of_gravity");
  if (all_masses.size() != all_centres.size()) {
    throw std::invalid_argument("masses_t holds " + std::to_string(all_masses.size()) +
                                " numbers, but centres_of_gravity " +
                                std::to_string(all_centres.size()) + " points.");
  }
  std::vector<analysis::LoadCase> loads;
  for (std::size_t i = 0; i < all_masses.size(); ++i) {
    loads.push_back({all_masses[i], all_centres[i], water_density});
  }
  return loads;
}

void bind_equilibrium_results(py::module_& module) {
  py::class_<analysis::UnstableEquilibrium>(module, "UnstableEquilibrium",
                                            "An equilibrium that a ship leaves when disturbed.")
      .def_property_readonly(
          "draft", [](const analysis::UnstableEquilibrium& r) { return r.position.draft; },
          "m, at draft_at.")
      .def_property_readonly(
          "trim", [](const analysis::UnstableEquilibrium& r) { return r.position.trim; },
          "rad, by the stern.")
      .def_property_readonly(
          "heel", [](const analysis::UnstableEquilibrium& r) { return r.position.heel; },
          "rad, to starboard.")
      .def_readonly("gm_transverse", &analysis::UnstableEquilibrium::gm_transverse, "m.")
      .def_readonly("gm_longitudinal", &analysis::UnstableEquilibrium::gm_longitudinal, "m.");
  using E = analysis::Equilibrium;
  py::class_<E>(module, "Equilibrium", "A ship in equilibrium under a load, or why there is none.")
      .def_property_readonly(
          "status", [](const E& e) { return name_of(e.status); },
          "\"stable\", \"neutral\", \"unstable\", \"floods\", \"sinks\" or \"not converged\".")
      .def_readonly("message", &E::message, "The status as a sentence, with its reason.")
      .def_property_readonly(
          "draft_mean", [](const E& e) { return e.position.draft; }, "m, at draft_at.")
      .def_property_readonly(
          "draft_at", [](const E& e) { return e.position.draft_at; }, "m.")
      .def_property_readonly(
          "trim", [](const E& e) { return e.position.trim; }, "rad, by the stern.")
      .def_property_readonly(
          "heel", [](const E& e) { return e.position.heel; }, "rad, to starboard.")
      .def("draft", &E::draft, py::arg("x"),
           "m, at x (m) on the ship's own vertical in the centre plane.")
      .def_readonly("immersion", &E::immersion)
      .def_readonly("gm_transverse", &E::gm_transverse,
                    "m, for turns about the horizontal axis forward.")
      .def_readonly("gm_longitudinal", &E::gm_longitudinal,
                    "m, for turns about the horizontal axis across.")
      .def_readonly("left", &E::left,
                    "The UnstableEquilibrium that was left for this one, None if there was none.")
      .def_readonly("whole_volume", &E::whole_volume,
                    "m³, what the body displaces when wholly under water.")
      .def_readonly("volume_residual", &E::volume_residual, "Relative, of the displaced volume.")
      .def_readonly("lever_residual", &E::lever_residual, "m, between weight and buoyancy.")
      .def_readonly("iterations", &E::iterations, "Newton steps tried.")
      .def_readonly("evaluations", &E::evaluations, "Immersions computed.");
}

}  // namespace

void bind_equilibrium(py::module_& module) {
  bind_equilibrium_results(module);
  module.def(
      "equilibrium",
      [](const analysis::HullBody& body, double mass_t, const DoubleArray& centre_of_gravity,
         double water_density, bool free_trim, bool free_heel, double trim, double heel,
         double draft_at, bool leave_unstable) {
        const analysis::LoadCase load{mass_t, point_from(centre_of_gravity, "centre_of_gravity"),
                                      water_density};
        const py::gil_scoped_release release;
        return analysis::equilibrium(
            body, load, options_from(free_trim, free_heel, trim, heel, draft_at, leave_unstable));
      },
      py::arg("body"), py::kw_only(), py::arg("mass_t"), py::arg("centre_of_gravity"),
      py::arg("water_density") = analysis::kSeaWaterDensity, py::arg("free_trim") = true,
      py::arg("free_heel") = true, py::arg("trim") = 0.0, py::arg("heel") = 0.0,
      py::arg("draft_at") = 0.0, py::arg("leave_unstable") = true,
      "The Equilibrium of a HullBody of mass_t (t) with its centre_of_gravity (x, y, z in m) in "
      "water of water_density (t/m³).\n\nFound by descent of the energy from trim (by the stern) "
      "and heel "
      "(to starboard), in rad, at which what is not free is held. Where the equilibrium is "
      "unstable the ship is pushed to starboard and followed to a stable one, the angle of loll; "
      "leave_unstable=False leaves her there. draft_at (m): x where the mean draft is measured. "
      "Raises ValueError unless mass and density are positive.");
  module.def(
      "equilibria",
      [](const analysis::HullBody& body, const DoubleArray& masses, const DoubleArray& centres,
         double water_density, bool free_trim, bool free_heel, double trim, double heel,
         double draft_at, bool leave_unstable) {
        const std::vector<analysis::LoadCase> loads = loads_from(masses, centres, water_density);
        const py::gil_scoped_release release;
        return analysis::equilibria(
            body, loads, options_from(free_trim, free_heel, trim, heel, draft_at, leave_unstable));
      },
      py::arg("body"), py::kw_only(), py::arg("masses_t"), py::arg("centres_of_gravity"),
      py::arg("water_density") = analysis::kSeaWaterDensity, py::arg("free_trim") = true,
      py::arg("free_heel") = true, py::arg("trim") = 0.0, py::arg("heel") = 0.0,
      py::arg("draft_at") = 0.0, py::arg("leave_unstable") = true,
      "A list with equilibrium() of each load case: masses_t (n,) in t, centres_of_gravity (n, 3) "
      "in m; the rest as there.");
}

}  // namespace hull::bindings
