// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/queries/surface_tree.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "bindings/arrays.h"
#include "surface/queries/closest_point.h"
#include "surface/queries/infinity.h"
#include "surface/queries/ray_hits.h"

namespace hull::bindings {
namespace {

struct ClosestPoints {
  std::vector<surface::ClosestPoint> all;
};

struct RayHits {
  std::vector<surface::RayHit> all;
};

template <class Result, class Value>
py::array_t<Value> numbers(const std::vector<Result>& results, Value (*get)(const Result&)) {
  py::array_t<Value> array(static_cast<py::ssize_t>(results.size()));
  Value* to = array.mutable_data();
  for (const Result& result : results) *to++ = get(result);
  return array;
}

// NaN where nothing was found.
template <class Result>
py::array_t<double> points_of(const std::vector<Result>& results) {
  std::vector<Vector3d> points;
  points.reserve(results.size());
  for (const Result& at : results) {
    points.push_back(at.cell < 0 ? Vector3d::Constant(std::nan("")) : at.point);
  }
  return to_array(points);
}

template <class Result>
py::array_t<double> parameters_of(const std::vector<Result>& results) {
  std::vector<Eigen::Vector2d> uv;
  uv.reserve(results.size());
  for (const Result& at : results) {
    uv.push_back(at.cell < 0 ? Eigen::Vector2d::Constant(std::nan(""))
                             : Eigen::Vector2d(at.u, at.v));
  }
  return to_array(uv);
}

ClosestPoints find_closest_points(const surface::SurfaceTree& tree, const DoubleArray& points,
                                  double max_distance) {
  const std::vector<Vector3d> from = points_from(points, "points");
  const py::gil_scoped_release release;
  return {surface::closest_points(tree, from, max_distance)};
}

RayHits find_ray_hits(const surface::SurfaceTree& tree, const DoubleArray& origins,
                      const DoubleArray& directions, double max_distance) {
  const std::vector<Vector3d> from = points_from(origins, "origins");
  const std::vector<Vector3d> along = points_from(directions, "directions");
  if (from.size() != along.size()) {
    throw std::invalid_argument("origins and directions must be of equal length, not " +
                                std::to_string(from.size()) + " and " +
                                std::to_string(along.size()) + ".");
  }
  const py::gil_scoped_release release;
  RayHits hits;
  hits.all.reserve(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    try {
      const auto hit = surface::first_ray_hit(tree, {from[i], along[i], 0.0, max_distance});
      hits.all.push_back(hit.value_or(surface::RayHit{}));
    } catch (const std::invalid_argument& error) {
      // The core knows one ray alone, not its number.
      throw std::invalid_argument("origins[" + std::to_string(i) + "], directions[" +
                                  std::to_string(i) + "]: " + error.what());
    }
  }
  return hits;
}

RayHits find_all_ray_hits(const surface::SurfaceTree& tree, const DoubleArray& origin,
                          const DoubleArray& direction, double max_distance) {
  const surface::Ray ray{point_from(origin, "origin"), point_from(direction, "direction"), 0.0,
                         max_distance};
  const py::gil_scoped_release release;
  return {surface::all_ray_hits(tree, ray)};
}

void bind_query_results(py::module_& module) {
  py::class_<ClosestPoints>(module, "ClosestPoints",
                            "The points of a surface nearest to k given ones, in their order.")
      .def("__len__", [](const ClosestPoints& c) { return c.all.size(); })
      .def_property_readonly(
          "points", [](const ClosestPoints& c) { return points_of(c.all); },
          "(k, 3), m; NaN where none lies within max_distance.")
      .def_property_readonly(
          "distances",
          [](const ClosestPoints& c) {
            return numbers<surface::ClosestPoint, double>(
                c.all, [](const surface::ClosestPoint& at) { return at.distance; });
          },
          "(k,), m, never negative; infinite where none.")
      .def_property_readonly(
          "cells",
          [](const ClosestPoints& c) {
            return numbers<surface::ClosestPoint, int>(
                c.all, [](const surface::ClosestPoint& at) { return at.cell; });
          },
          "(k,) cells; -1 where none.")
      .def_property_readonly(
          "uv", [](const ClosestPoints& c) { return parameters_of(c.all); },
          "(k, 2) where in the cell; NaN where none.")
      .def_property_readonly(
          "kinds",
          [](const ClosestPoints& c) {
            return numbers<surface::ClosestPoint, int>(
                c.all, [](const surface::ClosestPoint& at) { return static_cast<int>(at.kind); });
          },
          "(k,): 0 where the surface is smooth, 1 on a crease or border, 2 at a corner or "
          "irregular knot.")
      .def_property_readonly(
          "sides",
          [](const ClosestPoints& c) {
            return numbers<surface::ClosestPoint, int>(
                c.all, [](const surface::ClosestPoint& at) { return at.side; });
          },
          "(k,): 1 on the side of the normal (in the water), -1 on the other one, 0 on the "
          "surface, "
          "beyond a border, and where there is no normal.")
      .def_property_readonly(
          "gaps",
          [](const ClosestPoints& c) {
            return numbers<surface::ClosestPoint, double>(
                c.all, [](const surface::ClosestPoint& at) { return at.gap; });
          },
          "(k,), m: no point of the surface is nearer than distances - gaps. About 1e-14 of the "
          "size, but more for points at the same distance from much of the surface.");

  py::class_<RayHits>(module, "RayHits", "Points where rays meet a surface.")
      .def("__len__", [](const RayHits& h) { return h.all.size(); })
      .def_property_readonly(
          "distances",
          [](const RayHits& h) {
            return numbers<surface::RayHit, double>(h.all,
                                                    [](const surface::RayHit& at) { return at.t; });
          },
          "(k,), m from the origin, whatever the length of the direction; infinite where missed.")
      .def_property_readonly(
          "points", [](const RayHits& h) { return points_of(h.all); },
          "(k, 3), m; NaN where missed.")
      .def_property_readonly(
          "cells",
          [](const RayHits& h) {
            return numbers<surface::RayHit, int>(h.all,
                                                 [](const surface::RayHit& at) { return at.cell; });
          },
          "(k,) cells; -1 where missed.")
      .def_property_readonly(
          "uv", [](const RayHits& h) { return parameters_of(h.all); },
          "(k, 2) where in the cell; NaN where missed.")
      .def_property_readonly(
          "grazing",
          [](const RayHits& h) {
            return numbers<surface::RayHit, bool>(
                h.all, [](const surface::RayHit& at) { return at.grazing; });
          },
          "(k,) whether the ray touches the surface or runs along it, rather than crosses it.");
}

}  // namespace

void bind_surface_tree(py::module_& module) {
  bind_query_results(module);
  py::class_<surface::SurfaceTree>(
      module, "SurfaceTree",
      "Finds points of a limit surface that are nearest to given ones, and where rays meet it: "
      "exactly, some microseconds each.\n\n"
      "The tree keeps a copy of the surface as it is now; after surface.set_points() it needs "
      "refit().")
      .def(py::init([](const surface::LimitSurface& surface, const py::object& cells) {
             if (cells.is_none()) {
               const py::gil_scoped_release release;
               return std::make_unique<surface::SurfaceTree>(surface);
             }
             const std::vector<int> own = integers_from(cells, "cells");
             const py::gil_scoped_release release;
             return std::make_unique<surface::SurfaceTree>(surface, own);
           }),
           py::arg("surface"), py::kw_only(), py::arg("cells") = py::none(),
           "cells: (k,) of these alone, as if the others were not there.")
      .def("refit", &surface::SurfaceTree::refit, py::arg("surface"),
           py::call_guard<py::gil_scoped_release>(),
           "Follows the surface the tree was made of after set_points(); quicker than a new tree. "
           "Not to be called while another thread uses the tree.")
      .def_property_readonly("size", &surface::SurfaceTree::size,
                             "Diagonal of the box around the surface's control points, m.")
      .def("closest_points", &find_closest_points, py::arg("points"),
           py::arg("max_distance") = surface::kInfinity,
           "points: (k, 3), m. Returns ClosestPoints: of all points of the surface the nearest, if "
           "it is no farther than max_distance (m).")
      .def("ray_hits", &find_ray_hits, py::arg("origins"), py::arg("directions"),
           py::arg("max_distance") = surface::kInfinity,
           "origins, directions: (k, 3); directions of any length but zero. Returns RayHits: for "
           "each ray the first, within max_distance (m) of its origin.")
      .def("all_ray_hits", &find_all_ray_hits, py::arg("origin"), py::arg("direction"),
           py::arg("max_distance") = surface::kInfinity,
           "origin, direction: (3,). Returns RayHits: all of one ray, in order of distance. One at "
           "the common side or corner of cells counts once; where the ray runs along the surface "
           "there are two, where it comes to it and where it leaves it.");
}

}  // namespace hull::bindings
