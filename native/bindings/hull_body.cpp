// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hull_body.h"

#include "bindings/classes.h"

namespace hull::bindings {

namespace py = pybind11;

void bind_hull_body(py::module_& module) {
  py::class_<HullBody>(module, "HullBody",
                       "A limit surface as the shell of a floating body. What does not depend on "
                       "the water is computed once, so that many waters cost little.")
      .def(py::init<const LimitSurface&, bool>(), py::arg("surface"), py::kw_only(),
           py::arg("mirrored"), py::keep_alive<1, 2>(), py::call_guard<py::gil_scoped_release>(),
           "mirrored: the mesh is the port half (y >= 0) and counts twice.")
      .def("update", &HullBody::update, py::call_guard<py::gil_scoped_release>(),
           "To be called after surface.set_points().")
      .def_property_readonly("surface", &HullBody::surface, py::return_value_policy::reference)
      .def_property_readonly("mirrored", &HullBody::mirrored);
}

}  // namespace hull::bindings
