// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/network_patches.h"

#include <pybind11/stl.h>

#include "bindings/arrays.h"
#include "bindings/network_classes.h"

namespace hull::bindings {

void bind_network_patches(py::module_& module) {
  using network::NetworkPatches;
  py::class_<NetworkPatches>(module, "NetworkPatches",
                             "The surface of a CurveNetwork as B-spline patches.")
      .def_readonly("patches", &NetworkPatches::set, "The PatchSet.")
      .def_property_readonly(
          "regions", [](const NetworkPatches& made) { return to_array(made.regions); },
          "(p,) the region of each patch.")
      .def_property_readonly(
          "edges", [](const NetworkPatches& made) { return to_array(made.edges); },
          "(e,) of each edge of the PatchSet the network's edge that it is along; -1: within a "
          "region.")
      .def_readonly("problems", &NetworkPatches::problems,
                    "NetworkProblems: regions left open, and curves that are missed.")
      .def_property_readonly(
          "curve_errors", [](const NetworkPatches& made) { return to_array(made.curve_errors); },
          "(c,), m: how far each curve is from the surface at most, but for parts that the network "
          "leaves out.")
      .def_property_readonly("largest_curve_error", &NetworkPatches::largest_curve_error,
                             "m: the largest of curve_errors.")
      .def_readonly("spoke_error", &NetworkPatches::spoke_error,
                    "m: how far borders of patches within a region are at most from the surface "
                    "that the region's patches stand for.");
  module.def(
      "network_patches",
      [](const network::CurveNetwork& curves, int spans, double tolerance,
         const NetworkPatches* before) {
        const py::gil_scoped_release release;
        return network::network_patches(curves, {spans, tolerance}, before);
      },
      py::arg("network"), py::kw_only(), py::arg("spans") = 4, py::arg("tolerance") = 0.0,
      py::arg("before") = nullptr,
      "NetworkPatches of a CurveNetwork: cubic patches, one in each region of four sides, as many "
      "as there are sides around a centre in others, with one tangent plane along their common "
      "borders but at knuckles. spans: how many a patch has each way at least; tolerance, m: how "
      "far patches may be from curves (0: a tenth of the network's). before: NetworkPatches of "
      "the network before a curve moved, whose patches are taken where nothing has changed. "
      "ValueError for spans that are not from 1 to 64, and a tolerance below zero.");
}

}  // namespace hull::bindings
