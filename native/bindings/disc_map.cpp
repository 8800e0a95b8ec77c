// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/parametrisation/disc_map.h"

#include <pybind11/stl.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "bindings/discs.h"
#include "morphing/parametrisation/place_search.h"

namespace hull::bindings {
namespace {

using morphing::DiscMap;
using morphing::DiscPlace;
using morphing::PlaceSearch;
using morphing::TriangleDisc;

morphing::WeightKind kind_of(const std::string& weights) {
  if (weights == "shape_preserving") return morphing::WeightKind::kShapePreserving;
  if (weights == "mean_value") return morphing::WeightKind::kMeanValue;
  if (weights == "uniform") return morphing::WeightKind::kUniform;
  throw std::invalid_argument("weights is 'shape_preserving', 'mean_value' or 'uniform', not '" +
                              weights + "'.");
}

std::vector<DiscPlace> disc_places_from(const DiscMap& map, const py::object& triangles,
                                        const DoubleArray& weights) {
  const std::vector<int> in = integers_from(triangles, "triangles");
  const std::vector<Vector3d> with = points_from(weights, "weights");
  if (in.size() != with.size()) {
    throw std::invalid_argument("triangles and weights must be of equal length, not " +
                                std::to_string(in.size()) + " and " + std::to_string(with.size()) +
                                ".");
  }
  std::vector<DiscPlace> places;
  for (std::size_t i = 0; i < in.size(); ++i) {
    if (in[i] < 0 || in[i] >= map.disc().triangle_count()) {
      throw std::invalid_argument("triangles[" + std::to_string(i) + "] is " +
                                  std::to_string(in[i]) + ", but the triangles are 0 to " +
                                  std::to_string(map.disc().triangle_count() - 1) + ".");
    }
    places.push_back({in[i], {with[i].x(), with[i].y(), with[i].z()}});
  }
  return places;
}

py::tuple found_places(const PlaceSearch& search, const DoubleArray& places) {
  const std::vector<morphing::Vector2d> wanted = places_from(places, "places");
  std::vector<int> triangles;
  std::vector<Vector3d> weights;
  {
    const py::gil_scoped_release release;
    for (const morphing::Vector2d& place : wanted) {
      const DiscPlace found = search.find(place);
      triangles.push_back(found.triangle);
      weights.emplace_back(found.weights[0], found.weights[1], found.weights[2]);
    }
  }
  return py::make_tuple(to_array(triangles), to_array(weights));
}

void bind_disc(py::module_& module) {
  py::class_<TriangleDisc>(
      module, "TriangleDisc",
      "A surface of triangles that is a disc: manifold, turned to one side, in one part, with one "
      "border and no handle.")
      .def(py::init([](const DoubleArray& points, const py::object& triangles) {
             return std::make_unique<TriangleDisc>(points_from(points, "points"),
                                                   triangles_from(triangles, "triangles"));
           }),
           py::arg("points"), py::arg("triangles"),
           "points (n, 3), m; triangles (m, 3), counter-clockwise seen from outside. ValueError, "
           "naming a point, an edge or a triangle, for what is no disc, for points that no "
           "triangle has and edges without length.")
      .def_property_readonly(
          "points", [](const TriangleDisc& disc) { return to_array(disc.points()); }, "(n, 3), m.")
      .def_property_readonly(
          "triangles", [](const TriangleDisc& disc) { return triangle_array(disc.triangles()); },
          "(m, 3)")
      .def_property_readonly(
          "border",
          [](const TriangleDisc& disc) {
            std::vector<int> points;
            for (int h : disc.border()) points.push_back(disc.topology().origin(h));
            return to_array(points);
          },
          "(k,) border points, one after the other, with the surface to their left.")
      .def(
          "side_lengths",
          [](const TriangleDisc& disc, const py::object& corners) {
            return to_array(morphing::side_lengths(disc, integers_from(corners, "corners")));
          },
          py::arg("corners"),
          "(k,), m: of the border from each of the corners (k,), border points in order, to the "
          "next.");
  module.def(
      "polygon_on_circle",
      [](const DoubleArray& lengths) {
        return to_array(
            morphing::ConvexPolygon::on_circle(numbers_from(lengths, "lengths")).corners());
      },
      py::arg("lengths"),
      "(k, 2): the corners of a convex polygon on the unit circle, over arcs in proportion to "
      "lengths (k,), such as side_lengths() of a TriangleDisc, or the mean of those of two.");
}

void bind_map(py::module_& module) {
  py::class_<DiscMap>(
      module, "DiscMap",
      "A TriangleDisc laid into a convex polygon of the plane, one to one and linear on each "
      "triangle: its border onto the sides, by chord lengths from corner to corner, each inner "
      "point at the mean of its neighbours (Floater 1997).")
      .def(
          py::init([](const TriangleDisc& disc, const py::object& corners,
                      const DoubleArray& polygon, const std::string& weights) {
            const std::vector<int> named = integers_from(corners, "corners");
            morphing::ConvexPolygon onto(places_from(polygon, "polygon"));
            const morphing::WeightKind kind = kind_of(weights);
            const py::gil_scoped_release release;
            return std::make_unique<DiscMap>(disc, named, std::move(onto), kind);
          }),
          py::arg("disc"), py::arg("corners"), py::arg("polygon"), py::kw_only(),
          py::arg("weights") = "shape_preserving",
          "corners (k,): border points that become the corners of polygon (k, 2), which turns to "
          "the left at each of them; in the order of the border, with the surface to its left. "
          "weights: of neighbours: 'shape_preserving' (Floater 1997), 'mean_value' (Floater 2003) "
          "or 'uniform', which heeds no shape. Inner edges between two points of one side are "
          "divided in the middle. ValueError for other corners and polygons, and, naming it, for a "
          "triangle that has no area left in the plane.")
      .def_property_readonly("disc", &DiscMap::disc, py::return_value_policy::reference_internal,
                             "The TriangleDisc with its divided edges: points of the given one "
                             "keep their numbers, new ones follow.")
      .def_property_readonly(
          "split_edges", [](const DiscMap& map) { return to_array(map.split_edges()); },
          "(l, 2) the points of each divided edge, in the order of the new points.")
      .def_property_readonly(
          "corners", [](const DiscMap& map) { return to_array(map.corners()); }, "(k,)")
      .def_property_readonly(
          "polygon", [](const DiscMap& map) { return to_array(map.polygon().corners()); }, "(k, 2)")
      .def_property_readonly(
          "places", [](const DiscMap& map) { return to_array(map.places()); },
          "(n, 2) of the points of `disc`.")
      .def(
          "positions_at",
          [](const DiscMap& map, const py::object& triangles, const DoubleArray& weights) {
            std::vector<Vector3d> positions;
            for (const DiscPlace& at : disc_places_from(map, triangles, weights)) {
              positions.push_back(position_at(map, at));
            }
            return to_array(positions);
          },
          py::arg("triangles"), py::arg("weights"),
          "(k, 3), m: in triangles (k,) of `disc`, with weights (k, 3) of their corners.")
      .def(
          "places_at",
          [](const DiscMap& map, const py::object& triangles, const DoubleArray& weights) {
            std::vector<morphing::Vector2d> places;
            for (const DiscPlace& at : disc_places_from(map, triangles, weights)) {
              places.push_back(place_at(map, at));
            }
            return to_array(places);
          },
          py::arg("triangles"), py::arg("weights"), "(k, 2): the same in the plane.");
}

}  // namespace

void bind_disc_map(py::module_& module) {
  bind_disc(module);
  bind_map(module);
  py::class_<PlaceSearch>(module, "PlaceSearch",
                          "Which point of a disc is laid at a place of the plane: the inverse of "
                          "a DiscMap.")
      // The search refers to the map.
      .def(py::init<const DiscMap&>(), py::arg("map"), py::keep_alive<1, 2>())
      .def("find", &found_places, py::arg("places"),
           "(triangles (k,), weights (k, 3)) at places (k, 2): the triangle of the map's disc that "
           "has each, found by exact predicates, of several the one of least number, and the "
           "weights of its corners. ValueError for a place outside of the polygon.");
}

}  // namespace hull::bindings
