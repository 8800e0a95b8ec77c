// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/derivatives/form_numbers.h"

#include <pybind11/stl.h>

#include <memory>
#include <optional>

#include "bindings/arrays.h"

namespace hull::bindings {
namespace {

using analysis::FormNumbers;
using analysis::Gradient;

py::array_t<double> gradient_array(const Gradient& gradient) {
  py::array_t<double> array({gradient.rows(), Eigen::Index{3}});
  // Gradients are stored row by row, as NumPy has them.
  std::copy_n(gradient.data(), gradient.size(), array.mutable_data());
  return array;
}

void bind_body_derivatives(py::module_& module) {
  py::class_<analysis::BodyDerivatives>(
      module, "BodyDerivatives",
      "What the numbers of a HullBody gain by shifts of its surface's control points, exactly. "
      "Closings move with their borders; of a mirrored body both sides count. What depends on "
      "topology alone is prepared here, once; the body may get other points (HullBody.update()).")
      .def(py::init([](const analysis::HullBody& body) {
             const py::gil_scoped_release release;
             return std::make_unique<analysis::BodyDerivatives>(body);
           }),
           py::arg("body"), py::keep_alive<1, 2>());
}

}  // namespace

void bind_form_numbers(py::module_& module) {
  bind_body_derivatives(module);
  module.attr("FORM_NUMBERS") = py::cast(analysis::form_number_names());
  py::class_<FormNumbers>(
      module, "FormNumbers",
      "Numbers of a body in a floating position without heel, by the names that they have in "
      "Hydrostatics (FORM_NUMBERS: \"lcb\", \"project.block\", \"midship_section.area\", …), and "
      "their derivatives by the control points, water and project dimensions staying as they "
      "are. Only what is asked for is computed. Extents have the derivatives of the point that is "
      "farthest. They are of the body as it is when made: after surface.set_points(), "
      "HullBody.update() and join() whatever is asked raises ValueError; make them anew.")
      .def(py::init([](const analysis::BodyDerivatives& derivatives, double draft, double trim,
                       std::optional<double> draft_at, std::optional<double> length_pp,
                       std::optional<double> beam, std::optional<double> design_draft,
                       double water_density) {
             const analysis::ProjectDimensions project{length_pp.value_or(0.0), beam.value_or(0.0),
                                                       design_draft.value_or(0.0)};
             const double at = draft_at.value_or(0.5 * project.length_pp);
             return std::make_unique<FormNumbers>(derivatives,
                                                  analysis::FloatingPosition{draft, trim, 0.0, at},
                                                  project, water_density);
           }),
           py::arg("derivatives"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
           py::arg("draft_at") = py::none(), py::arg("length_pp") = py::none(),
           py::arg("beam") = py::none(), py::arg("design_draft") = py::none(),
           py::arg("water_density") = analysis::kSeaWaterDensity, py::keep_alive<1, 2>(),
           "As hydrostatics() has them. ValueError as there, also for a body that is out of date.")
      .def(
          "value",
          [](FormNumbers& numbers, const std::string& name) {
            const analysis::FormNumber number = analysis::form_number_named(name);
            const py::gil_scoped_release release;
            return numbers.value(number);
          },
          py::arg("name"), "ValueError for a name that is none.")
      .def(
          "gradient",
          [](FormNumbers& numbers, const std::string& name) {
            const analysis::FormNumber number = analysis::form_number_named(name);
            Gradient gradient;
            {
              const py::gil_scoped_release release;
              gradient = numbers.gradient(number);
            }
            return gradient_array(gradient);
          },
          py::arg("name"),
          "(n, 3): derivatives by x, y and z of the n control points. ValueError for a name that "
          "is none, and where a section's area jumps.")
      .def("section_area", &FormNumbers::section_area, py::arg("position"),
           py::call_guard<py::gil_scoped_release>(), "m², of the station at x = position.")
      .def(
          "section_area_gradient",
          [](FormNumbers& numbers, double position) {
            Gradient gradient;
            {
              const py::gil_scoped_release release;
              gradient = numbers.section_area_gradient(position);
            }
            return gradient_array(gradient);
          },
          py::arg("position"),
          "(n, 3). ValueError where a flat or a border lies in the station's plane: the area jumps "
          "there.");
}

}  // namespace hull::bindings
