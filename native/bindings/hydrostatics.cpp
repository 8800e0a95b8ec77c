// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hydrostatics.h"

#include "bindings/classes.h"

namespace hull::bindings {

namespace py = pybind11;

void bind_hydrostatics(py::module_& module) {
  using H = UprightHydrostatics;
  py::class_<H>(module, "UprightHydrostatics",
                "Particulars of a hull floating upright, of both sides; lengths in m from x = 0, "
                "y = 0 and z = 0.")
      .def_readonly("draft", &H::draft, "m, of the water above z = 0.")
      .def_readonly("displaced_volume", &H::displaced_volume, "m³, moulded.")
      .def_readonly("lcb", &H::lcb, "x of the centre of buoyancy, m.")
      .def_readonly("tcb", &H::tcb, "y of the centre of buoyancy, m.")
      .def_readonly("kb", &H::kb, "z of the centre of buoyancy, m.")
      .def_readonly("wetted_surface", &H::wetted_surface, "m².")
      .def_readonly("waterplane_area", &H::waterplane_area, "m².")
      .def_readonly("lcf", &H::lcf, "x of the centre of flotation, m.")
      .def_readonly("tcf", &H::tcf, "y of the centre of flotation, m.")
      .def_readonly("waterplane_inertia_transverse", &H::waterplane_inertia_transverse,
                    "m⁴, about the fore-and-aft axis through the centre of flotation.")
      .def_readonly("waterplane_inertia_longitudinal", &H::waterplane_inertia_longitudinal,
                    "m⁴, about the transverse axis through the centre of flotation.")
      .def_readonly("bm_transverse", &H::bm_transverse, "Metacentric radius, m.")
      .def_readonly("bm_longitudinal", &H::bm_longitudinal, "Metacentric radius, m.")
      .def_readonly("km_transverse", &H::km_transverse, "Metacentre above base, m.")
      .def_readonly("km_longitudinal", &H::km_longitudinal, "Metacentre above base, m.")
      .def_readonly("volume_error", &H::volume_error, "Estimated error of integration, m³.")
      .def_readonly("wetted_surface_error", &H::wetted_surface_error,
                    "Estimated error of integration, m².")
      .def_readonly("volume_from_breadths", &H::volume_from_breadths,
                    "m³, the volume from breadths instead of depths; it differs where the shell is "
                    "open below the water.");
  module.def("upright_hydrostatics", &upright_hydrostatics, py::arg("surface"), py::kw_only(),
             py::arg("draft"), py::arg("mirrored"), py::call_guard<py::gil_scoped_release>(),
             "Particulars of the surface floating upright at a draft (m above z = 0), integrated "
             "over the exact surface.\n\nmirrored: the mesh is the port half (y >= 0) and counts "
             "twice. Openings below the water are closed by vertical planes. Raises ValueError if "
             "the faces are turned inwards.");
}

}  // namespace hull::bindings
