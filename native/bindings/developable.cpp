// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <stdexcept>

#include "bindings/arrays.h"
#include "bindings/production_classes.h"
#include "production/developable/developable_strip.h"
#include "production/developable/ruled_warp.h"

namespace hull::bindings {
namespace {

using production::BezierChain;
using production::BezierSpan;
using production::DevelopableStrip;

std::vector<BezierSpan> spans_from(const DoubleArray& points, const char* name) {
  const std::vector<Vector3d> flat = points_from(points, name);
  if (flat.empty() || flat.size() % 4 != 0) {
    throw std::invalid_argument(std::string(name) +
                                " must have four rows for each cubic span, its Bézier points.");
  }
  std::vector<BezierSpan> spans;
  for (std::size_t i = 0; i < flat.size(); i += 4) {
    spans.push_back({flat[i], flat[i + 1], flat[i + 2], flat[i + 3]});
  }
  return spans;
}

// A strip with the curves that it is of.
struct Strip {
  BezierChain a, b;
  DevelopableStrip strip;
};

py::array_t<double> ends(const BezierChain& curve, const DevelopableStrip& strip, bool on_a) {
  std::vector<Vector3d> points;
  for (const production::Ruling& r : strip.rulings) {
    points.push_back(curve.at(on_a ? r.s : r.t).point);
  }
  return to_array(points);
}

py::tuple developed_arrays(const Strip& s) {
  const production::DevelopedStrip flat = production::developed(s.a, s.b, s.strip);
  return py::make_tuple(to_array(flat.a), to_array(flat.b));
}

}  // namespace

void bind_developable(py::module_& module) {
  py::class_<production::LargestWarp>(module, "LargestWarp",
                                      "Of the rulings between two curves at equal parameters.")
      .def_readonly("found", &production::LargestWarp::found, "rad/m: the largest that was met …")
      .def_readonly("at", &production::LargestWarp::at, "… and at which parameter.")
      .def_readonly("bound", &production::LargestWarp::bound, "rad/m: no ruling has more.");

  module.def(
      "ruled_warp",
      [](const DoubleArray& a, const DoubleArray& b, double t) {
        if (!(t >= 0.0 && t <= 1.0)) throw std::invalid_argument("t must be in [0, 1].");
        return production::warp_at(spans_from(a, "a").at(0), spans_from(b, "b").at(0), t);
      },
      py::arg("a"), py::arg("b"), py::arg("t"),
      "rad/m: the angle between the normals at both ends of the ruling at t between the cubics of "
      "Bézier points a and b (4, 3), divided by its length.");
  module.def(
      "largest_warp",
      [](const DoubleArray& a, const DoubleArray& b) {
        return production::largest_warp(spans_from(a, "a").at(0), spans_from(b, "b").at(0));
      },
      py::arg("a"), py::arg("b"),
      "LargestWarp of all rulings between the cubics of Bézier points a and b (4, 3), with a "
      "certain bound, within 0.1 % of what was found if there is one. Infinite where a ruling has "
      "no length or runs along an edge.");

  py::class_<Strip>(module, "DevelopableStrip",
                    "The developable surface between two curves, closed at its ends by cones.")
      .def(py::init([](const DoubleArray& a, const DoubleArray& b, int count) {
             BezierChain one(spans_from(a, "a")), other(spans_from(b, "b"));
             DevelopableStrip strip = production::developable_strip(one, other, count);
             return Strip{std::move(one), std::move(other), std::move(strip)};
           }),
           py::arg("a"), py::arg("b"), py::arg("count") = 200,
           "a, b: Bézier points (4 k, 3) of cubic spans, four each. count: intervals along a. "
           "ValueError where no straight line lies in one tangent plane of both curves.")
      .def_property_readonly(
          "rulings",
          [](const Strip& s) {
            std::vector<Eigen::Vector2d> pairs;
            for (const production::Ruling& r : s.strip.rulings) pairs.push_back({r.s, r.t});
            return to_array(pairs);
          },
          "(n, 2): parameters on a and on b, span k over [k, k + 1], of straight lines of the "
          "surface, from one end to the other.")
      .def_property_readonly(
          "core", [](const Strip& s) { return py::make_tuple(s.strip.first, s.strip.last); },
          "(first, last) of the rulings that are not of cones at the ends.")
      .def_property_readonly(
          "ends",
          [](const Strip& s) {
            return py::make_tuple(ends(s.a, s.strip, true), ends(s.b, s.strip, false));
          },
          "Of the rulings, on a and on b: two arrays (n, 3).")
      .def("developed", &developed_arrays,
           "The same ends laid out in the plane, two arrays (n, 2): lengths, areas and geodesic "
           "curvatures are kept, up to the fourth power of the rulings' distance.");
}

}  // namespace hull::bindings
