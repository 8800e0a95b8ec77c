// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/afloat/patch_body.h"

#include <pybind11/stl.h>

#include <memory>

#include "bindings/classes.h"
#include "bindings/planes.h"
#include "conversion/afloat/patch_sections.h"

namespace hull::bindings {

namespace py = pybind11;

namespace {

// A body, and what it is of.
struct OwnPatchBody {
  // Before the body, which refers to it: members are made in this order. For the same reason it is
  // never moved, and is made by address.
  conversion::PatchPieces pieces;
  conversion::PatchBody body;

  OwnPatchBody(const conversion::PatchSet& set, bool mirrored)
      : pieces(set), body(pieces, mirrored) {}
};

}  // namespace

void bind_patch_body(py::module_& module) {
  py::class_<OwnPatchBody>(
      module, "PatchBody",
      "A PatchSet as the shell of a floating body, closed from its borders by straight "
      "athwartships lines to the centre plane.")
      .def(py::init([](const conversion::PatchSet& set, bool mirrored) {
             const py::gil_scoped_release release;
             return std::make_unique<OwnPatchBody>(set, mirrored);
           }),
           py::arg("patches"), py::kw_only(), py::arg("mirrored"),
           "mirrored: the patches are the port half (y >= 0) and count twice. ValueError, telling "
           "where, for a border that such lines do not close, and for patches that are turned "
           "inwards.")
      .def(
          "immersion",
          [](const OwnPatchBody& own, const DoubleArray& up, double offset) {
            const Vector3d normal = point_from(up, "normal");
            const double length = normal.norm();
            if (!(length > 0.0)) throw std::invalid_argument("normal must not be zero.");
            const py::gil_scoped_release release;
            return own.body.immersion({normal / length, offset / length});
          },
          py::arg("normal"), py::arg("offset"),
          "Immersion in water whose surface is normal · p = offset, normal (3,) pointing up; its "
          "flux_forms are left at zero.");
  module.def(
      "patch_sections",
      [](const conversion::PatchSet& set, const DoubleArray& planes,
         const std::optional<double>& chord_tolerance,
         const std::optional<double>& flat_tolerance) {
        const std::vector<analysis::Plane> wanted = planes_from(planes);
        const py::gil_scoped_release release;
        const conversion::PatchPieces pieces(set);
        const double chord = chord_tolerance.value_or(kChordTolerance * pieces.size());
        return conversion::patch_sections(pieces, wanted, {chord, flat_tolerance});
      },
      py::arg("patches"), py::arg("planes"), py::arg("chord_tolerance") = py::none(), py::kw_only(),
      py::arg("flat_tolerance") = py::none(),
      "The sections of a PatchSet by planes (n, 4), as sections() gives those of a surface: a list "
      "of n lists of SectionCurve, whose cells are patches and uv places on them. Seams that turn "
      "by less than 0.6 degrees make no knuckle.");
}

}  // namespace hull::bindings
