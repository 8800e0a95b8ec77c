// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/michell_integral.h"

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <memory>

#include "bindings/arrays.h"
#include "bindings/resistance_classes.h"

namespace hull::bindings {
namespace {

using resistance::MichellIntegral;
using resistance::WaveResistance;

void bind_wave_resistance(py::module_& module) {
  py::class_<WaveResistance>(module, "WaveResistance", "Wave resistance at a speed.")
      .def_readonly("speed", &WaveResistance::speed, "m/s.")
      .def_readonly("resistance", &WaveResistance::resistance, "kN.")
      .def_readonly("error", &WaveResistance::error,
                    "kN: a bound of what waves shorter than the shortest one add; infinite where "
                    "too few waves were taken to tell.")
      .def_readonly("shortest", &WaveResistance::shortest,
                    "λ, 1 / cos of the wave's direction, up to which waves were taken.");
}

py::array_t<std::complex<double>> complex_array(const std::vector<std::complex<double>>& values) {
  py::array_t<std::complex<double>> array(static_cast<py::ssize_t>(values.size()));
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

}  // namespace

void bind_michell_integral(py::module_& module) {
  bind_wave_resistance(module);
  module.attr("GRAVITY") = resistance::kGravity;
  py::class_<MichellIntegral>(
      module, "MichellIntegral",
      "Michell's integral for the wave resistance of a thin ship over the exact wetted shell of a "
      "HullBody, upright: source strengths are the shell's slopes along the ship, put into the "
      "centre plane. Behind an open transom the water is taken to leave straight. Viscosity, "
      "sinkage and trim by the waves are left out. It is of the body as it is when made: after "
      "surface.set_points(), HullBody.update() and join() whatever is asked raises ValueError; "
      "make it anew.")
      .def(py::init([](const analysis::HullBody& body, double draft, double trim, double draft_at,
                       double water_density, double gravity, double tolerance) {
             const py::gil_scoped_release release;
             return std::make_unique<MichellIntegral>(
                 body, analysis::FloatingPosition{draft, trim, 0.0, draft_at}, water_density,
                 gravity, tolerance);
           }),
           py::arg("body"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
           py::arg("draft_at") = 0.0, py::arg("water_density") = analysis::kSeaWaterDensity,
           py::arg("gravity") = resistance::kGravity,
           py::arg("tolerance") = resistance::kWaveTolerance, py::keep_alive<1, 2>(),
           "draft in m at x = draft_at, trim in rad by the stern, water_density in t/m³, gravity "
           "in m/s². tolerance: part of the resistance that short waves may leave out. ValueError "
           "for a hull that is out of the water, and as hydrostatics().")
      .def_property_readonly("length", &MichellIntegral::length,
                             "m: what Froude numbers are checked on, the mesh's extent along.")
      .def(
          "resistance",
          [](const MichellIntegral& integral, const DoubleArray& speeds) {
            const std::vector<double> values = numbers_from(speeds, "speeds");
            const py::gil_scoped_release release;
            return integral.resistance(values);
          },
          py::arg("speeds"),
          "(n,) m/s: a list of WaveResistance. ValueError for speeds whose Froude number is below "
          "0.05 or above 5.")
      .def(
          "resistance_to",
          [](const MichellIntegral& integral, double speed, double shortest) {
            const py::gil_scoped_release release;
            return integral.resistance_to(speed, shortest);
          },
          py::arg("speed"), py::arg("shortest"),
          "The WaveResistance at a speed, m/s, of waves up to this λ, whatever is left then: "
          "smooth in the hull's form. ValueError where shortest is not above 1.")
      .def(
          "gradient",
          [](const MichellIntegral& integral, const analysis::BodyDerivatives& derivatives,
             double speed) {
            analysis::Gradient gradient;
            {
              const py::gil_scoped_release release;
              gradient = integral.gradient(derivatives, speed);
            }
            py::array_t<double> array({gradient.rows(), Eigen::Index{3}});
            std::copy_n(gradient.data(), gradient.size(), array.mutable_data());
            return array;
          },
          py::arg("derivatives"), py::arg("speed"),
          "(n, 3) kN/m: derivatives of the resistance at a speed by the n control points, the "
          "water staying as it is. derivatives: BodyDerivatives of the same HullBody, "
          "otherwise ValueError.")
      .def(
          "amplitudes",
          [](const MichellIntegral& integral, double speed, const DoubleArray& directions) {
            const std::vector<double> values = numbers_from(directions, "directions");
            std::vector<std::complex<double>> amplitudes;
            {
              const py::gil_scoped_release release;
              amplitudes = integral.amplitudes(speed, values);
            }
            return complex_array(amplitudes);
          },
          py::arg("speed"), py::arg("directions"),
          "(n,) complex, m: the free-wave spectrum A(θ) for directions θ (n,) in rad within 89°: "
          "far behind, the water is at Re ∫ A(θ) exp(-i ν (x cos θ + y sin θ) / cos² θ) dθ from "
          "-π/2 to π/2, ν = g / U², and the resistance is π/2 ρ U² ∫ |A|² cos³ θ dθ.");
}

}  // namespace hull::bindings
