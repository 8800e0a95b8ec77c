// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/hull_body.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <stdexcept>
#include <string>

#include "analysis/appendages/appendage.h"
#include "analysis/appendages/joined_shells.h"
#include "analysis/appendages/own_overlaps.h"
#include "bindings/arrays.h"
#include "bindings/openings.h"

namespace hull::bindings {

namespace py = pybind11;

namespace {

void bind_immersion(py::module_& module) {
  using I = analysis::Immersion;
  py::class_<I>(module, "Immersion",
                "What the water does to a body that lies in it, both sides, in the body's axes.")
      .def_property_readonly(
          "water_normal", [](const I& i) { return i.water.normal; }, "(3,), up.")
      .def_property_readonly(
          "water_offset", [](const I& i) { return i.water.offset; },
          "m: points of the water's surface have this product with water_normal.")
      .def_readonly("volume", &I::volume, "Displaced volume, m³.")
      .def_readonly("centre_of_buoyancy", &I::centre_of_buoyancy, "(3,), m.")
      .def_readonly("wetted_surface", &I::wetted_surface, "m², without closings.")
      .def_readonly("waterplane_area", &I::waterplane_area, "m².")
      .def_readonly("centre_of_flotation", &I::centre_of_flotation, "(3,), m.")
      .def_readonly("waterplane_second", &I::waterplane_second,
                    "(3, 3), m⁴: second moments of the waterplane about its centre.")
      .def_readonly("flux_forms", &I::flux_forms,
                    "(3,), m³: the fluxes of (x, 0, 0), (0, y, 0) and (0, 0, z) through the "
                    "immersed shell, without closings and waterplane.")
      .def_readonly("volume_error", &I::volume_error, "Estimated, m³.")
      .def_readonly("wetted_surface_error", &I::wetted_surface_error, "Estimated, m².");
}

void warn_of_idle_cut(const std::string& name) {
  const std::string words = (name.empty() ? std::string("A body to be cut out") : name) +
                            " cuts nothing out of the hull, beside which it lies: move it into the "
                            "hull, or leave it out.";
  if (PyErr_WarnEx(PyExc_UserWarning, words.c_str(), 1) != 0) throw py::error_already_set();
}

}  // namespace

void bind_hull_body(py::module_& module) {
  bind_immersion(module);
  py::class_<analysis::HullBody>(
      module, "HullBody",
      "A limit surface as the shell of a floating body. What does not depend on "
      "the water is computed once, so that many waters cost little.\n\n"
      "Its openings are closed by straight athwartships lines where that closes "
      "the body, else by the fan from the border's centroid.")
      .def(
          py::init([](const surface::LimitSurface& surface, bool mirrored,
                      const std::string& openings, double tolerance) {
            const analysis::Openings chosen = openings_from(openings);
            const py::gil_scoped_release release;
            return std::make_unique<analysis::HullBody>(surface, mirrored, chosen, tolerance);
          }),
          py::arg("surface"), py::kw_only(), py::arg("mirrored"), py::arg("openings") = "closed",
          py::arg("tolerance") = analysis::kFinest, py::keep_alive<1, 2>(),
          "mirrored: the mesh is the port half (y >= 0) and counts twice. openings: \"closed\", as "
          "by a weathertight deck, or \"open\": then water above one raises ValueError (\"floods "
          "at\"). Transoms in planes across the ship are closed in any case. tolerance: error "
          "relative "
          "to the whole that integrals may have, between 0 and 0.01; 1e-8 serves for numbers that "
          "follow the mouse. Raises ValueError for others.")
      .def("update", &analysis::HullBody::update, py::call_guard<py::gil_scoped_release>(),
           "To be called after surface.set_points(); until then whatever is asked of the body, "
           "also by hydrostatics() and its like, raises ValueError. Only what has moved is "
           "computed again.")
      .def(
          "join",
          [](analysis::HullBody& body, std::vector<analysis::Appendage> appendages, bool warn) {
            {
              const py::gil_scoped_release release;
              body.join(std::move(appendages));
            }
            if (!warn) return;
            // Warnings may run Python's code, so the GIL is held again.
            for (const std::string& name : body.joined()->idle_cuts()) warn_of_idle_cut(name);
          },
          py::arg("appendages"), py::kw_only(), py::arg("warn") = true,
          "From now on the body is (its own bodies and appendages that are added) without those "
          "that are cut out, each point of space counted once: in immersion(), hydrostatics(), "
          "levers, equilibrium. Section areas, extents, offsets and form numbers stay those of the "
          "hull. [] counts the hull's own bodies once where they overlap. ValueError where "
          "surfaces lie in one another. warn: a UserWarning names what is to be cut out and lies "
          "beside the hull (idle_cuts).")
      .def_property_readonly(
          "idle_cuts",
          [](const analysis::HullBody& b) {
            return b.joined() ? b.joined()->idle_cuts() : std::vector<std::string>();
          },
          "Names of bodies to be cut out that join() was given and that cut nothing out, since "
          "they lie beside the hull.")
      .def_property_readonly(
          "joined_volume",
          [](const analysis::HullBody& b) -> std::optional<double> {
            if (!b.joined()) return std::nullopt;
            return b.joined()->whole_change().first.trace() / 3.0;
          },
          "m³: by how much join() changes the whole body's volume; None without it.")
      .def_property_readonly(
          "appendages",
          [](const analysis::HullBody& b) -> std::optional<std::vector<analysis::Appendage>> {
            if (!b.joined()) return std::nullopt;
            std::vector<analysis::Appendage> all;
            for (const analysis::JoinedMember& member : b.joined()->members()) {
              if (member.appendage) all.push_back(*member.appendage);
            }
            return all;
          },
          "A list of what join() was given; None without it.")
      .def_property_readonly("may_overlap", &analysis::may_overlap,
                             "Whether boxes around two of the hull's own bodies have space in "
                             "common; if not, and with "
                             "one body, own_overlaps is empty.")
      .def_property_readonly(
          "own_overlaps",
          [](const analysis::HullBody& body) {
            std::vector<analysis::OwnOverlap> found;
            {
              const py::gil_scoped_release release;
              found = analysis::own_overlaps(body);
            }
            const auto face = [&](int own) {
              return body.surface().mesh().topology().face(body.bodies().first_cell[own]);
            };
            py::list list;
            for (const analysis::OwnOverlap& one : found) {
              list.append(py::make_tuple(face(one.first_body), face(one.second_body), one.volume,
                                         one.is_countable));
            }
            return list;
          },
          "Tuples of a face of each of two of the hull's own bodies that overlap, m³ that they "
          "have in common, and whether join([]) counts that once; where surfaces lie in one "
          "another along an area it can't, and the volume is an estimate. What encloses nothing "
          "overlaps nothing.")
      // The very object that it was made of, which it keeps alive.
      .def_property_readonly("surface", &analysis::HullBody::surface,
                             py::return_value_policy::reference)
      .def_property_readonly("mirrored", &analysis::HullBody::mirrored)
      .def_property_readonly("tolerance", &analysis::HullBody::tolerance)
      .def_property_readonly("openings",
                             [](const analysis::HullBody& b) {
                               return b.openings() == analysis::Openings::kOpen ? "open" : "closed";
                             })
      .def_property_readonly(
          "shell_area", [](const analysis::HullBody& b) { return b.shell_moments().area; },
          "m², of the whole shell without closings, both sides.")
      .def_property_readonly(
          "shell_flux_forms",
          [](const analysis::HullBody& b) -> Vector3d {
            return b.shell_moments().first.diagonal();
          },
          "(3,), m³: the fluxes of (x, 0, 0), (0, y, 0) and (0, 0, z) through the whole shell "
          "without closings; each is the volume of a closed shell.")
      .def(
          "immersion",
          [](const analysis::HullBody& body, const DoubleArray& up, double offset) {
            const Vector3d normal = point_from(up, "normal");
            const double length = normal.norm();
            if (!(length > 0.0)) throw std::invalid_argument("normal must not be zero.");
            const py::gil_scoped_release release;
            // The same plane, its normal of unit length.
            return body.immersion({normal / length, offset / length});
          },
          py::arg("normal"), py::arg("offset"),
          "In water whose surface is normal · p = offset, normal (3,) pointing up. Raises "
          "ValueError where the body floods or faces are turned inwards.");
}

}  // namespace hull::bindings
