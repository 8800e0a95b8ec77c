// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/overlay/merged_discs.h"

#include <memory>
#include <stdexcept>

#include "bindings/discs.h"

namespace hull::bindings {
namespace {

using morphing::DiscMap;
using morphing::MergedDiscs;

}  // namespace

void bind_merged_discs(py::module_& module) {
  py::class_<MergedDiscs>(
      module, "MergedDiscs",
      "Two discs that were mapped onto one polygon as one mesh, with the points and edges of both "
      "and points where edges cross: two surfaces of the same triangles, and those between them "
      "(Kang & Lee 2012). Which there are follows from exact predicates; discs in the other order "
      "give the same mesh in another order.")
      .def(py::init<const DiscMap&, const DiscMap&>(), py::arg("first"), py::arg("second"),
           py::call_guard<py::gil_scoped_release>(),
           "first, second: DiscMaps onto the same polygon. ValueError for different polygons, and "
           "for a triangle at the border that is too thin.")
      .def_property_readonly(
          "triangles", [](const MergedDiscs& m) { return triangle_array(m.triangles()); },
          "(f, 3), counter-clockwise in the plane.")
      .def_property_readonly(
          "parents", [](const MergedDiscs& m) { return to_array(m.parents()); },
          "(f, 2) the triangles of `disc` of both maps that each is part of.")
      .def_property_readonly(
          "origins", [](const MergedDiscs& m) { return to_array(m.origins()); },
          "(v, 2) the points of both discs that each is, or -1; crossings have -1 twice.")
      .def_property_readonly(
          "places", [](const MergedDiscs& m) { return to_array(m.places()); }, "(v, 2)")
      .def_property_readonly(
          "first_points", [](const MergedDiscs& m) { return to_array(m.points_on(0)); },
          "(v, 3), m, on the first disc.")
      .def_property_readonly(
          "second_points", [](const MergedDiscs& m) { return to_array(m.points_on(1)); },
          "(v, 3), m, on the second disc.")
      .def(
          "points", [](const MergedDiscs& m, double t) { return to_array(m.points(t)); },
          py::arg("t"),
          "(v, 3), m: (1 - t) times the first and t times the second; t may lie outside of 0 and "
          "1.")
      .def_property_readonly("shared_count", &MergedDiscs::shared_count, "Points of both discs.")
      .def_property_readonly("crossing_count", &MergedDiscs::crossing_count,
                             "Of inner edges of the first with inner edges of the second.");
}

}  // namespace hull::bindings
