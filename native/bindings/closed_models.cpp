// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <stdexcept>

#include "bindings/arrays.h"
#include "bindings/production_classes.h"
#include "bindings/progress.h"
#include "bindings/rows.h"
#include "production/models/closed_model.h"
#include "production/models/slices.h"
#include "production/segments/axis_rays.h"

namespace hull::bindings {
namespace {

using production::ClosedModel;
using production::ModelLayers;
using production::ModelSlice;

// (n, 3) of finite numbers.
std::vector<Vector3d> places_from(const DoubleArray& given, const char* name) {
  std::vector<Vector3d> places = points_from(given, name);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].allFinite()) continue;
    throw std::invalid_argument(std::string(name) + "[" + std::to_string(i) +
                                "] is not of finite numbers; leave it out, or set it anew.");
  }
  return places;
}

ClosedModel faces_from(const DoubleArray& points, const py::object& triangles) {
  ClosedModel model;
  model.points = places_from(points, "points");
  model.triangles = triangles_from(triangles, model.points.size());
  return model;
}

py::array_t<bool> covered_by(const ClosedModel& model, const DoubleArray& points,
                             const char* name) {
  const std::vector<Vector3d> places = places_from(points, name);
  py::array_t<bool> result(static_cast<py::ssize_t>(places.size()));
  bool* const covered = result.mutable_data();
  const py::gil_scoped_release release;
  // Along z. Until it is returned nobody else has the array, so it may be written without the GIL.
  const production::AxisRays rays(model, 2);
  for (std::size_t i = 0; i < places.size(); ++i) covered[i] = rays.meets_above(places[i]);
  return result;
}

ClosedModel model_from(const DoubleArray& points, const py::object& triangles) {
  ClosedModel model = faces_from(points, triangles);
  const int open = production::open_sides(model);
  if (open > 0 || model.triangles.empty()) {
    throw std::invalid_argument("The triangles do not enclose a body: " + std::to_string(open) +
                                " sides do not belong to two of them.");
  }
  return model;
}

void bind_slices(py::module_& module) {
  py::class_<ModelSlice>(module, "ModelSlice", "The section of a ClosedModel at a height.")
      .def_readonly("height", &ModelSlice::height)
      .def_property_readonly(
          "contours",
          [](const ModelSlice& slice) {
            py::list list;
            for (const auto& contour : slice.contours) list.append(to_array(contour));
            return list;
          },
          "A list of arrays (n, 2), x and y of closed contours, whose first point is not "
          "repeated: counter-clockwise around the model, clockwise around what is hollow.")
      .def_property_readonly("area", &ModelSlice::area);
  py::class_<ModelLayers>(module, "ModelLayers", "A ClosedModel in layers of one thickness.")
      .def_readonly("thickness", &ModelLayers::thickness)
      .def_readonly("bottom", &ModelLayers::bottom, "z of the model's lowest point.")
      .def_property_readonly(
          "tops", [](const ModelLayers& layers) { return to_array(layers.tops); },
          "(n,) z of the layers' upper surfaces; the last is the model's highest point.")
      .def_property_readonly("volume", &ModelLayers::volume,
                             "The sum of the slices' areas times the layers' thickness.")
      .def_readonly("slices", &ModelLayers::slices,
                    "A list of ModelSlice, at the middle of each layer, from below.");
}

}  // namespace

void bind_closed_models(py::module_& module) {
  bind_slices(module);
  py::class_<ClosedModel>(
      module, "ClosedModel",
      "Triangles that enclose a body: every side belongs to two of them, which run through it in "
      "opposite directions.")
      .def(py::init(&model_from), py::arg("points"), py::arg("triangles"),
           "points (n, 3), triangles (m, 3), counter-clockwise seen from outside. ValueError where "
           "they do not enclose a body, and for points that are not finite.")
      .def_property_readonly(
          "points", [](const ClosedModel& model) { return to_array(model.points); }, "(n, 3).")
      .def_property_readonly(
          "triangles", [](const ClosedModel& model) { return rows_of(model.triangles); },
          "(m, 3), counter-clockwise seen from outside.")
      .def_property_readonly(
          "cells", [](const ClosedModel& model) { return to_array(model.cells); },
          "(m,) the surface's cell that each triangle is of, on either side; -1 on closings. Empty "
          "where it is not known: of models that were cut, hollowed or given.")
      .def_property_readonly("volume", &ClosedModel::volume)
      .def_property_readonly("area", &ClosedModel::area)
      .def_property_readonly("open_sides", &production::open_sides,
                             "How many sides do not belong to just two triangles: none.")
      .def("scaled", &production::scaled, py::arg("factor"),
           py::call_guard<py::gil_scoped_release>(),
           "A ClosedModel with all lengths times factor, in the single precision of files; what "
           "vanishes by that is left out, and it stays closed. ValueError unless the factor is "
           "positive, where points would not be finite in that precision, and where nothing is "
           "left.")
      .def(
          "layers",
          [](const ClosedModel& model, double thickness, const py::object& progress) {
            const surface::Progress told = progress_from(progress);
            const py::gil_scoped_release release;
            return production::layers(model, thickness, told);
          },
          py::arg("thickness"), py::kw_only(), py::arg("progress") = py::none(),
          "ModelLayers of that thickness, from the lowest point up. Areas times thickness sum to "
          "the volume but for the thickness squared. ValueError for what is no thickness, and "
          "for more than 100 000 layers.")
      .def(
          "slices",
          [](const ClosedModel& model, const DoubleArray& heights) {
            const std::vector<double> values = numbers_from(heights, "heights");
            const py::gil_scoped_release release;
            return production::slices(model, values);
          },
          py::arg("heights"),
          "A list of ModelSlice at heights (n,), which must rise. Points at a height count as "
          "above it.")
      .def(
          "covers",
          [](const ClosedModel& model, const DoubleArray& points) {
            return covered_by(model, points, "points");
          },
          py::arg("points"),
          "(n,) whether a triangle is above each of points (n, 3), towards +z. ValueError for "
          "points that are not finite.");

  module.def(
      "places_covered",
      [](const DoubleArray& points, const py::object& triangles, const DoubleArray& places) {
        const ClosedModel faces = faces_from(points, triangles);
        return covered_by(faces, places, "places");
      },
      py::arg("points"), py::arg("triangles"), py::arg("places"),
      "(n,) whether one of triangles (m, 3) of points, which need not enclose anything, is above "
      "each of places (n, 3), towards +z. ValueError for triangles of points that there are not, "
      "and for points and places that are not finite.");
  module.def(
      "closed_model",
      [](const analysis::HullBody& body, double tolerance, const py::object& progress) {
        const surface::Progress told = progress_from(progress);
        const py::gil_scoped_release release;
        return production::closed_model(body, tolerance, told);
      },
      py::arg("body"), py::arg("chord_tolerance"), py::kw_only(), py::arg("progress") = py::none(),
      "A ClosedModel of a whole HullBody, both sides, with its closings, in m. Every point "
      "of the shell is within chord_tolerance, m, of the triangles, and the volume within "
      "that times the area. progress: called with the share done; what it raises ends the "
      "work. ValueError names a tolerance that would do where this is too "
      "fine.");
}

}  // namespace hull::bindings
