// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/feature_curves.h"

#include <pybind11/stl.h>

#include "bindings/arrays.h"

namespace hull::bindings {

void bind_feature_curves(py::module_& module) {
  py::class_<analysis::FeatureCurve>(module, "FeatureCurve",
                                     "A chain of creases or borders as a curve.")
      .def_property_readonly("kind",
                             [](const analysis::FeatureCurve& c) {
                               return c.kind == surface::CreaseKind::kBorder ? "border" : "crease";
                             })
      .def_property_readonly(
          "vertices", [](const analysis::FeatureCurve& c) { return to_array(c.vertices); },
          "(k,) the chain's control points.")
      .def_property_readonly(
          "points", [](const analysis::FeatureCurve& c) { return to_array(c.points); },
          "(n, 3), m; the first is repeated at the end of a closed curve.")
      .def_readonly("closed", &analysis::FeatureCurve::closed);
  module.def("feature_curves", &analysis::feature_curves, py::arg("surface"),
             py::arg("samples_per_edge") = 16, py::call_guard<py::gil_scoped_release>(),
             "Creases and borders as a list of FeatureCurve, ending at corners and darts.");
}

}  // namespace hull::bindings
