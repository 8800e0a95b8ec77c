// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <stdexcept>

#include "bindings/arrays.h"
#include "bindings/casts.h"
#include "bindings/planes.h"
#include "bindings/production_classes.h"
#include "bindings/progress.h"
#include "production/models/hollow.h"
#include "production/models/model_cut.h"
#include "production/segments/segments.h"

namespace hull::bindings {
namespace {

using production::ClosedModel;
using production::HollowModel;
using production::ModelSegment;
using production::ModelSegments;

production::SegmentMaking making_from(const std::string& name) {
  if (name == "milling") return production::SegmentMaking::kMilling;
  if (name == "thick_layers") return production::SegmentMaking::kThickLayers;
  throw std::invalid_argument("Segments are made by \"milling\" or of \"thick_layers\", not \"" +
                              name + "\".");
}

std::string direction_name(const ModelSegment& segment) {
  const int direction = segment.verdict.direction;
  // Numbered +x, -x, +y, -y, +z, -z.
  return std::string(1, "+-"[direction % 2]) + "xyz"[direction / 2];
}

void bind_segment_classes(py::module_& module) {
  py::class_<ModelSegment>(module, "ModelSegment", "A part of a ClosedModel that is made alone.")
      .def_readonly("model", &ModelSegment::model, "ClosedModel, where it is in the whole.")
      .def_property_readonly("direction", &direction_name,
                             "From where the tool comes: \"+z\", \"-y\"; of thick layers the "
                             "normal of these, \"+x\".")
      .def_property_readonly(
          "box", [](const ModelSegment& one) { return std::pair(one.box[0], one.box[1]); },
          "Two points (3,): between which planes it was cut.")
      .def_property_readonly(
          "inaccessible", [](const ModelSegment& one) { return one.verdict.inaccessible; },
          "Area that the tool does not reach.")
      .def_property_readonly(
          "has_back", [](const ModelSegment& one) { return one.verdict.has_back; },
          "Whether it has a plane to lie on, away from the tool.")
      .def_property_readonly(
          "fits", [](const ModelSegment& one) { return one.verdict.fits; },
          "Whether it is within the machine's sizes.")
      .def_property_readonly(
          "can_be_made", [](const ModelSegment& one) { return one.verdict.penalty == 0.0; },
          "Whether nothing is against it.");
  py::class_<ModelSegments>(module, "ModelSegments", "A ClosedModel in segments.")
      .def_readonly("segments", &ModelSegments::segments, "A list of ModelSegment.")
      .def_readonly("holes", &ModelSegments::holes, "For dowels, two for each.")
      .def_readonly("holes_volume", &ModelSegments::holes_volume, "Of all holes.")
      .def_readonly("bare_joints", &ModelSegments::bare_joints,
                    "Joints that no dowel has room in.");
}

ModelSegments segments_of(const ClosedModel& model, const Vector3d& machine, double least,
                          int planes, const std::string& making, double dowel, double dowel_depth,
                          const py::object& progress) {
  production::SegmentRules rules;
  rules.making = making_from(making);
  rules.machine = machine;
  rules.least = least;
  rules.planes = planes;
  const surface::Progress told = progress_from(progress);
  const py::gil_scoped_release release;
  return production::segmented(model, rules, {0.5 * dowel, dowel_depth}, told);
}

}  // namespace

void bind_model_parts(py::module_& module) {
  bind_segment_classes(module);
  py::class_<HollowModel>(module, "HollowModel", "A ClosedModel with a wall around hollows.")
      .def_readonly("model", &HollowModel::model, "ClosedModel, the hollows' surfaces included.")
      .def_readonly("hollows", &HollowModel::hollows, "How many are apart from one another.")
      .def_readonly("hollow_volume", &HollowModel::hollow_volume,
                    "What the model is lighter than the solid one.");
  module.def(
      "hollowed",
      [](const ClosedModel& model, double wall, const py::object& cell,
         const py::object& progress) {
        const double side =
            cell.is_none() ? wall
                           : cast_or_refuse<double>(cell, "cell must be a length in m, or None.");
        const surface::Progress told = progress_from(progress);
        const py::gil_scoped_release release;
        return production::hollowed(model, wall, side, told);
      },
      py::arg("model"), py::arg("wall"), py::arg("cell") = py::none(), py::kw_only(),
      py::arg("progress") = py::none(),
      "A HollowModel: the ClosedModel with all that is further than wall from its surface taken "
      "out; what is nowhere thicker than twice that stays solid, so that the inner surface never "
      "meets itself. cell (the wall's thickness by default, and at most): the grid's side by which "
      "the "
      "inner surface is found. Its corners are wall from the surface but for the square of what "
      "interpolation in a cube is off; where it is smooth with radius r its triangles are within "
      "cell² / r of it, and knuckles are cut off within a cube, on the thick side. progress: "
      "called "
      "with the share done; what it raises ends the work. ValueError where nothing is thick "
      "enough, for a cell larger than the wall, and for more than 3 000 000 cubes, naming what "
      "would do.");
  module.def("wall_volume", &production::wall_volume, py::arg("model"), py::arg("wall"),
             "The volume of a wall of this thickness inside a ClosedModel by Steiner's formula: "
             "area wall - M wall², M the sum over its edges of length tan(theta / 2), theta the "
             "angle between the triangles' normals, of theta length / 2 with its sign where it is "
             "hollow: of a smooth surface the integral of the mean curvature. It is off by the "
             "cube of the wall where the inner surface does not meet itself.");
  module.def(
      "cut_model",
      [](const ClosedModel& model, const std::string& axis, double at) {
        const int number = static_cast<int>(axis_from(axis));
        const py::gil_scoped_release release;
        production::CutModel parts = production::cut(model, number, at);
        return std::pair(std::move(parts.below), std::move(parts.above));
      },
      py::arg("model"), py::arg("axis"), py::arg("at"),
      "(below, above): the parts of a ClosedModel on both sides of the plane across axis \"x\", "
      "\"y\" or \"z\" at a place, closed; one without triangles where there is nothing. Their "
      "volumes sum to the model's but for rounding. ValueError where the model touches itself in "
      "the plane.");
  module.def(
      "segmented", &segments_of, py::arg("model"), py::kw_only(), py::arg("machine"),
      py::arg("least") = 0.0, py::arg("planes") = 16, py::arg("making") = "milling",
      py::arg("dowel") = 0.0, py::arg("dowel_depth") = 0.0, py::arg("progress") = py::none(),
      "ModelSegments of a ClosedModel for a machine that takes pieces of sizes machine (3,), the "
      "last along the tool. Segments are between planes across the axes, of a grid with about so "
      "many layers along the longest side, fewer where it has more than 200 000 boxes; of all ways "
      "to cut, and to cut parts again, the best is taken: with the least to be said against (1000 "
      "for a segment that has no plane to lie on, "
      "1 for a face that the tool does not reach, 250 for sizes outside least to machine; Koelman "
      "1999, 5.5.1.2), of these with the fewest segments, of these with the most equal ones. "
      "Whether a face is reached is decided for the segment alone. making \"thick_layers\": faces "
      "that are within 45° of a layer's normal count in place of those that are not reached. "
      "dowel: "
      "diameter of holes in the joints, up to two a joint, 0 for none. progress: called with the "
      "share done. ValueError for what is no machine, and for too many planes.");
}

}  // namespace hull::bindings
