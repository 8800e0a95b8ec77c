// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/panels/wetted_panels.h"

#include <pybind11/eigen.h>

#include "bindings/arrays.h"
#include "bindings/production_classes.h"
#include "bindings/progress.h"
#include "bindings/rows.h"

namespace hull::bindings {

using production::PanelMesh;

void bind_wetted_panels(py::module_& module) {
  py::class_<PanelMesh>(
      module, "PanelMesh",
      "The wetted hull as flat panels for programs that compute waves and motions, in the water's "
      "axes: z up from its surface, x forward along it, y to port.")
      .def_property_readonly(
          "points", [](const PanelMesh& mesh) { return to_array(mesh.points); }, "(n, 3), m.")
      .def_property_readonly(
          "panels", [](const PanelMesh& mesh) { return rows_of(mesh.panels); },
          "(k, 4) points, counter-clockwise seen from the water; the last corner of a triangle is "
          "there twice.")
      .def_property_readonly(
          "at_water",
          [](const PanelMesh& mesh) {
            py::array_t<bool> array(static_cast<py::ssize_t>(mesh.at_water.size()));
            std::copy(mesh.at_water.begin(), mesh.at_water.end(), array.mutable_data());
            return array;
          },
          "(n,) whether each point is in the water's surface: z is exactly 0 there.")
      .def_readonly("half", &PanelMesh::half,
                    "Whether this is the port half alone, of a ship that is symmetric in the "
                    "water.")
      .def_readonly("origin", &PanelMesh::origin, "(3,) of the water's axes, in the ship's, m.")
      .def_readonly("axes", &PanelMesh::axes,
                    "(3, 3): a point p of the ship is at axes @ (p - origin).")
      .def_readonly(
          "displaced_volume", &PanelMesh::displaced_volume,
          "Of the exact hull that has these panels, both sides, m³: without what is joined "
          "to it; its own bodies add up.")
      .def_property_readonly("volumes", &PanelMesh::volumes,
                             "(3,) m³: the fluxes of (x, 0, 0), (0, y, 0) and (0, 0, z) through "
                             "all panels, both sides. All three are the volume that the panels "
                             "and the water's surface enclose.")
      .def_property_readonly("area", &PanelMesh::area, "Of all panels, both sides, m².");

  module.def(
      "wetted_panels",
      [](const analysis::HullBody& body, double size, double draft, double trim, double heel,
         double draft_at, double grading, double origin_x, const py::object& progress) {
        const surface::Progress told = progress_from(progress);
        const py::gil_scoped_release release;
        return production::wetted_panels(body, {draft, trim, heel, draft_at}, {size, grading},
                                         origin_x, told);
      },
      py::arg("body"), py::arg("size"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
      py::arg("heel") = 0.0, py::arg("draft_at") = 0.0, py::arg("grading") = 0.5,
      py::arg("origin_x") = 0.0, py::arg("progress") = py::none(),
      "A PanelMesh of the part of a HullBody below the water, closings included where they are in "
      "it; without what join() joins to it, and with all of bodies that overlap (own_overlaps). "
      "size: the most that panels' sides measure, m; at the water's surface and at the ends "
      "they have `grading` times that. draft in m at x = draft_at, trim in rad by the stern, heel "
      "in rad to starboard. origin_x: the origin is the water's nearest point to (origin_x, 0, 0) "
      "of the ship. A half hull that does not heel is one half with its symmetry. Panels end "
      "exactly at the waterline; volumes are off by the square of the size. progress: called with "
      "the share done; what it raises ends the work. ValueError for sizes "
      "that are none or give more than 2^20 panels, for a hull out of the water, and as "
      "hydrostatics().");
}

}  // namespace hull::bindings
