// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/creases/crease_curves.h"

#include <pybind11/stl.h>

#include <stdexcept>
#include <string>

#include "bindings/arrays.h"

namespace hull::bindings {
namespace {

std::vector<double> parameters_on(const surface::CreaseCurve& curve, const DoubleArray& array) {
  const std::vector<double> t = numbers_from(array, "t");
  for (std::size_t i = 0; i < t.size(); ++i) {
    // Written so that NaN fails too.
    if (t[i] >= 0.0 && t[i] <= curve.edge_count()) continue;
    throw std::invalid_argument("t[" + std::to_string(i) + "] is outside of [0, " +
                                std::to_string(curve.edge_count()) + "].");
  }
  return t;
}

py::tuple evaluate_crease(const surface::CreaseCurve& curve, const DoubleArray& array,
                          int derivatives) {
  const std::vector<double> t = parameters_on(curve, array);
  if (derivatives < 0 || derivatives > 2) {
    throw std::invalid_argument("derivatives is 0, 1 or 2, not " + std::to_string(derivatives) +
                                ".");
  }
  std::vector<std::vector<Vector3d>> values(derivatives + 1, std::vector<Vector3d>(t.size()));
  for (std::size_t i = 0; i < t.size(); ++i) {
    const surface::CurveJet jet = curve.evaluate(t[i], derivatives);
    const Vector3d* parts[] = {&jet.point, &jet.d1, &jet.d2};
    for (std::size_t k = 0; k < values.size(); ++k) values[k][i] = *parts[k];
  }
  py::tuple result(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) result[k] = to_array(values[k]);
  return result;
}

py::tuple places(const surface::CreaseCurve& curve, const DoubleArray& array,
                 surface::CellPlace (surface::CreaseCurve::*side)(double) const) {
  std::vector<int> cells;
  std::vector<Eigen::Vector2d> uv;
  for (double t : parameters_on(curve, array)) {
    const surface::CellPlace place = (curve.*side)(t);
    cells.push_back(place.cell);
    uv.emplace_back(place.u, place.v);
  }
  return py::make_tuple(to_array(cells), to_array(uv));
}

}  // namespace

void bind_crease_curves(py::module_& module) {
  py::class_<surface::CreaseCurve>(
      module, "CreaseCurve",
      "A chain of crease or border edges as the cubic B-spline that the surface has there, over t "
      "from 0 to edge_count, one a control edge.\n\n"
      "Knots are the whole numbers from -3 to edge_count + 3 and control points those of the "
      "chain: with 2 p - q beyond a corner, and those of a closed chain again from the start. At "
      "a dart, where the curve is a cubic on each of the intervals 2^-(k+1) to 2^-k from it, the "
      "knots are graded and end in four of one value.")
      .def_property_readonly("kind",
                             [](const surface::CreaseCurve& c) {
                               return c.kind() == surface::CreaseKind::kBorder ? "border"
                                                                               : "crease";
                             })
      .def_property_readonly("closed", &surface::CreaseCurve::closed)
      .def_property_readonly(
          "vertices", [](const surface::CreaseCurve& c) { return to_array(c.vertices()); },
          "(k,) the chain's control vertices in order; a closed chain's first is not repeated.")
      .def_property_readonly("edge_count", &surface::CreaseCurve::edge_count)
      .def_property_readonly(
          "control_points",
          [](const surface::CreaseCurve& c) { return to_array(c.spline().points()); },
          "(n, 3), m: of the B-spline.")
      .def_property_readonly(
          "knots", [](const surface::CreaseCurve& c) { return to_array(c.spline().knots()); },
          "(n + 4,); the curve is defined from knots[3] = 0 to knots[-4] = edge_count.")
      .def_property_readonly("dart_error", &surface::CreaseCurve::dart_error,
                             "Bound on the distance from the surface's curve in the last interval "
                             "at a dart, m; 0 without darts.")
      .def("evaluate", &evaluate_crease, py::arg("t"), py::arg("derivatives") = 0,
           "t: (k,) in [0, edge_count]. Returns a tuple of (k, 3) arrays: the points; with "
           "derivatives 1 or 2 also the first and second derivatives by t, m. At a dart these do "
           "not exist; there they are those of the spline's last interval.")
      .def(
          "left",
          [](const surface::CreaseCurve& c, const DoubleArray& t) {
            return places(c, t, &surface::CreaseCurve::left);
          },
          py::arg("t"),
          "Where the surface has the points t, in the faces left of the curve as seen from "
          "outside: (cells (k,), uv (k, 2)); cell -1 where a border has no face.")
      .def(
          "right",
          [](const surface::CreaseCurve& c, const DoubleArray& t) {
            return places(c, t, &surface::CreaseCurve::right);
          },
          py::arg("t"), "The same in the faces right of the curve.");
  module.def("crease_curves", &surface::crease_curves, py::arg("surface"),
             py::call_guard<py::gil_scoped_release>(),
             "All creases and borders as a list of CreaseCurve: chains from corner to corner, "
             "closed chains, and such that end at darts; one with one dart starts there.");
}

}  // namespace hull::bindings
