// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <stdexcept>

#include "bindings/arrays.h"
#include "bindings/production_classes.h"
#include "production/developable/ruled_warp.h"
#include "production/developable/strip_makers.h"

namespace hull::bindings {
namespace {

using production::BezierChain;
using production::BezierSpan;
using production::DevelopableStrip;
using production::StripBetween;

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

BezierSpan one_span(const DoubleArray& points, const char* name) {
  const std::vector<BezierSpan> spans = spans_from(points, name);
  if (spans.size() != 1) {
    throw std::invalid_argument(std::string(name) + " must be one cubic span, four Bézier points.");
  }
  return spans.front();
}

py::array_t<double> ends(const BezierChain& curve, const DevelopableStrip& strip, bool on_a) {
  std::vector<Vector3d> points;
  for (const production::Ruling& r : strip.rulings) {
    points.push_back(curve.at(on_a ? r.s : r.t).point);
  }
  return to_array(points);
}

py::tuple developed_arrays(const StripBetween& s) {
  const production::DevelopedStrip flat = production::developed(s.a, s.b, s.strip);
  return py::make_tuple(to_array(flat.a), to_array(flat.b));
}

// Lines on a strip: [(points on it (k, 3), the same laid out (k, 2)), …].
py::list projected_lines(const StripBetween& s, const DoubleArray& points,
                         const DoubleArray& direction) {
  const auto lines = production::projected_on(s, points_from(points, "points"),
                                              point_from(direction, "direction"));
  const production::DevelopedStrip flat = production::developed(s.a, s.b, s.strip);
  py::list result;
  for (const production::StripLine& line : lines) {
    std::vector<Vector3d> on_strip;
    std::vector<Eigen::Vector2d> laid;
    for (std::size_t i = 0; i < line.rulings.size(); ++i) {
      const int k = line.rulings[i];
      const production::Ruling& ruling = s.strip.rulings[k];
      const Vector3d a = s.a.at(ruling.s).point;
      on_strip.push_back(a + line.along[i] * (s.b.at(ruling.t).point - a));
      laid.push_back(flat.a[k] + line.along[i] * (flat.b[k] - flat.a[k]));
    }
    result.append(py::make_tuple(to_array(on_strip), to_array(laid)));
  }
  return result;
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
        return production::warp_at(one_span(a, "a"), one_span(b, "b"), t);
      },
      py::arg("a"), py::arg("b"), py::arg("t"),
      "rad/m: the angle between the normals at both ends of the ruling at t between the cubics of "
      "Bézier points a and b (4, 3), divided by its length.");
  module.def(
      "largest_warp",
      [](const DoubleArray& a, const DoubleArray& b) {
        return production::largest_warp(one_span(a, "a"), one_span(b, "b"));
      },
      py::arg("a"), py::arg("b"),
      "LargestWarp of all rulings between the cubics of Bézier points a and b (4, 3), with a "
      "certain bound, within 0.1 % of what was found if there is one. Infinite where a ruling has "
      "no length or runs along an edge.");

  py::class_<StripBetween>(
      module, "DevelopableStrip",
      "The developable surface between two curves, closed at its ends by cones.")
      .def(py::init([](const DoubleArray& a, const DoubleArray& b, int count) {
             BezierChain one(spans_from(a, "a")), other(spans_from(b, "b"));
             DevelopableStrip strip = production::developable_strip(one, other, count);
             return StripBetween{std::move(one), std::move(other), std::move(strip)};
           }),
           py::arg("a"), py::arg("b"), py::arg("count") = 200,
           "a, b: Bézier points (4 k, 3) of cubic spans, four each. count: intervals along a. "
           "ValueError where no straight line lies in one tangent plane of both curves.")
      .def_static(
          "cone",
          [](const DoubleArray& a, const DoubleArray& tip, int count) {
            return production::cone_through(BezierChain(spans_from(a, "a")), point_from(tip, "tip"),
                                            count);
          },
          py::arg("a"), py::arg("tip"), py::kw_only(), py::arg("count") = 200,
          "The cone of straight lines from a curve, a as above, to its tip (3,), in which all end "
          "on the side of b. ValueError for a tip on the curve or on one of its tangents.")
      .def_static(
          "cylinder",
          [](const DoubleArray& a, const DoubleArray& direction, double length, int count) {
            return production::cylinder_along(BezierChain(spans_from(a, "a")),
                                              point_from(direction, "direction"), length, count);
          },
          py::arg("a"), py::kw_only(), py::arg("direction"), py::arg("length"),
          py::arg("count") = 200,
          "The cylinder from a curve, a as above, along a direction (3,), with rulings of one "
          "length, m. ValueError where the curve runs along the direction, for a direction (0, 0, "
          "0) and for a length that is not above 0.")
      .def_property_readonly(
          "rulings",
          [](const StripBetween& s) {
            std::vector<Eigen::Vector2d> pairs;
            for (const production::Ruling& r : s.strip.rulings) pairs.push_back({r.s, r.t});
            return to_array(pairs);
          },
          "(n, 2): parameters on a and on b, span k over [k, k + 1], of straight lines of the "
          "surface, from one end to the other.")
      .def_property_readonly(
          "core", [](const StripBetween& s) { return py::make_tuple(s.strip.first, s.strip.last); },
          "(first, last) of the rulings that are not of cones at the ends.")
      .def_property_readonly(
          "ends",
          [](const StripBetween& s) {
            return py::make_tuple(ends(s.a, s.strip, true), ends(s.b, s.strip, false));
          },
          "Of the rulings, on a and on b: two arrays (n, 3).")
      .def("developed", &developed_arrays,
           "The same ends laid out in the plane, two arrays (n, 2): lengths, areas and geodesic "
           "curvatures are kept, up to the fourth power of the rulings' distance.")
      .def("projected", &projected_lines, py::arg("points"), py::kw_only(), py::arg("direction"),
           "A polyline (k, 3) projected onto the strip along a direction (3,): where rays from it "
           "meet "
           "rulings, of several the one nearest to it. Rays go on through the strip. A list of "
           "(points on the strip (k, 3), the same laid out in the plane (k, 2)), one for each "
           "sequence of rulings that are met; it ends on the last of them. ValueError where none "
           "are.");
}

}  // namespace hull::bindings
