// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/model/curve_network.h"

#include <pybind11/stl.h>

#include <string>

#include "bindings/arrays.h"
#include "bindings/network_classes.h"

namespace hull::bindings {
namespace {

using network::CurveNetwork;
using network::NetworkCurve;
using network::NetworkOptions;
using network::NetworkProblem;

const char* name_of_problem(NetworkProblem::Kind kind) {
  switch (kind) {
    case NetworkProblem::Kind::kShape:
      return "shape";
    case NetworkProblem::Kind::kHalt:
      return "halt";
    case NetworkProblem::Kind::kOffPlane:
      return "off_plane";
    case NetworkProblem::Kind::kGap:
      return "gap";
    case NetworkProblem::Kind::kShortEdge:
      return "short_edge";
    case NetworkProblem::Kind::kOverlap:
      return "overlap";
    case NetworkProblem::Kind::kDuplicate:
      return "duplicate";
    case NetworkProblem::Kind::kDanglingEnd:
      return "dangling_end";
    case NetworkProblem::Kind::kApart:
      return "apart";
    case NetworkProblem::Kind::kWrongOrder:
      return "wrong_order";
    case NetworkProblem::Kind::kNoTangentPlane:
      return "no_tangent_plane";
    case NetworkProblem::Kind::kTee:
      return "tee";
    case NetworkProblem::Kind::kFewSides:
      return "few_sides";
    case NetworkProblem::Kind::kManySides:
      return "many_sides";
    case NetworkProblem::Kind::kOpenRegion:
      return "open_region";
    case NetworkProblem::Kind::kLooseRegion:
      return "loose_region";
    case NetworkProblem::Kind::kMissedCurve:
      return "missed_curve";
  }
  return "";
}

NetworkOptions options_from(double tolerance, double near_misses, double plane_angle) {
  return {{tolerance, near_misses}, plane_angle};
}

void bind_problem(py::module_& module) {
  py::class_<NetworkProblem>(module, "NetworkProblem", "What is to be told of a CurveNetwork.")
      .def_property_readonly(
          "kind", [](const NetworkProblem& p) { return name_of_problem(p.kind); },
          "'shape', 'halt', 'off_plane', 'gap', 'short_edge', 'overlap', 'duplicate', "
          "'dangling_end', "
          "'apart', "
          "'wrong_order', 'no_tangent_plane', 'tee', 'few_sides', 'many_sides'; of NetworkPatches "
          "'open_region', 'loose_region' or 'missed_curve'.")
      .def_readonly("what", &NetworkProblem::what, "A sentence with place and remedy.")
      .def_property_readonly(
          "curves", [](const NetworkProblem& p) { return to_array(p.curves); },
          "(k,) numbers of the curves concerned.")
      .def_property_readonly(
          "places", [](const NetworkProblem& p) { return to_array(p.places); }, "(k, 3), m.")
      .def_property_readonly("is_note", &NetworkProblem::is_note,
                             "Whether nothing has to be done about it.")
      .def("__repr__", [](const NetworkProblem& p) { return p.what; });
}

std::vector<std::array<int, 2>> edge_nodes(const CurveNetwork& network) {
  std::vector<std::array<int, 2>> edges;
  for (const network::CurveEdge& edge : network.frame().joined.edges) {
    edges.push_back({edge.from, edge.to});
  }
  return edges;
}

std::vector<int> edge_curves(const CurveNetwork& network) {
  std::vector<int> curves;
  for (const network::CurveEdge& edge : network.frame().joined.edges) curves.push_back(edge.curve);
  return curves;
}

py::array_t<double> edge_points(const CurveNetwork& network, int edge, int count) {
  const auto& shapes = network.frame().shapes;
  if (edge < 0 || edge >= static_cast<int>(shapes.size())) {
    throw std::invalid_argument("There is no edge " + std::to_string(edge) + ".");
  }
  if (count < 1) throw std::invalid_argument("An edge has one part or more.");
  std::vector<Vector3d> points;
  for (int i = 0; i <= count; ++i) {
    const double u = static_cast<double>(i) / count;
    points.emplace_back(shapes[static_cast<std::size_t>(edge)].evaluate(u, 0).row(0));
  }
  return to_array(points);
}

py::list region_sides_of(const CurveNetwork& network, int region) {
  if (region < 0 || region >= static_cast<int>(network.regions().size())) {
    throw std::invalid_argument("There is no region " + std::to_string(region) + ".");
  }
  py::list sides;
  for (const network::RegionSide& side : network.regions()[static_cast<std::size_t>(region)]) {
    py::list edges;
    for (const network::RegionEdge& edge : side) {
      edges.append(py::make_tuple(edge.edge, edge.is_along));
    }
    sides.append(edges);
  }
  return sides;
}

py::list curve_pieces(const CurveNetwork& network, int curve) {
  if (curve < 0 || curve >= static_cast<int>(network.shapes().size())) {
    throw std::invalid_argument("There is no shape of a curve " + std::to_string(curve) + ".");
  }
  py::list pieces;
  for (const network::NurbsCurve& piece :
       network.shapes()[static_cast<std::size_t>(curve)].pieces) {
    std::vector<Vector3d> points;
    for (Eigen::Index i = 0; i < piece.points().rows(); ++i)
      points.push_back(piece.points().row(i));
    const std::vector<double> weights(piece.weights().begin(), piece.weights().end());
    pieces.append(py::make_tuple(piece.degree(), to_array(piece.knots()), to_array(points),
                                 to_array(weights)));
  }
  return pieces;
}

py::list roles_of(const CurveNetwork& network) {
  py::list roles;
  for (const network::CurveRole& role : network.roles()) {
    roles.append(py::make_tuple(role.border, role.crease, role.smooth));
  }
  return roles;
}

void bind_parts(py::class_<CurveNetwork>& bound) {
  bound
      .def_property_readonly(
          "nodes", [](const CurveNetwork& n) { return to_array(n.frame().joined.nodes); },
          "(n, 3), m: where curves meet, and their knuckles.")
      .def_property_readonly(
          "edges", [](const CurveNetwork& n) { return to_array(edge_nodes(n)); },
          "(m, 2) nodes of the parts of curves between nodes.")
      .def_property_readonly(
          "edge_curves", [](const CurveNetwork& n) { return to_array(edge_curves(n)); },
          "(m,) numbers of their curves.")
      .def_property_readonly(
          "crease_edges",
          [](const CurveNetwork& n) {
            std::vector<int> creases;
            const auto& is_crease = n.frame().normals.is_crease;
            for (std::size_t e = 0; e < is_crease.size(); ++e) {
              if (is_crease[e]) creases.push_back(static_cast<int>(e));
            }
            return to_array(creases);
          },
          "(k,) edges along which the surface has a knuckle, at one end at least.")
      .def("edge_points", &edge_points, py::arg("edge"), py::arg("count"),
           "(count + 1, 3), m: along an edge, from its first node.")
      .def(
          "pieces", &curve_pieces, py::arg("curve"),
          "Of a curve, from knuckle to knuckle: tuples (degree, knots (k,), control points (p, 3), "
          "weights (p,)).")
      .def_property_readonly("roles", &roles_of,
                             "Of each curve a tuple: how many of its edges are on the network's "
                             "border, on a knuckle of the surface, and where it is smooth.");
}

}  // namespace

void bind_curve_network(py::module_& module) {
  bind_problem(module);
  py::class_<CurveNetwork> bound(module, "CurveNetwork",
                                 "Curves joined where they meet: nodes, edges, and the regions "
                                 "between them with a surface each.");
  bound
      .def(py::init([](const std::vector<NetworkCurve>& curves, double tolerance,
                       double near_misses, double plane_angle) {
             const NetworkOptions options = options_from(tolerance, near_misses, plane_angle);
             const py::gil_scoped_release release;
             return std::make_unique<CurveNetwork>(curves, options);
           }),
           py::arg("curves"), py::arg("tolerance"), py::kw_only(), py::arg("near_misses") = 10.0,
           py::arg("plane_angle") = 0.035,
           "Of NetworkCurves, joined within tolerance, m; those that come within near_misses times "
           "it without being joined are named. plane_angle, rad: how far curves may be off the "
           "tangent plane where they meet. What is wrong with the curves is among `problems`; "
           "ValueError for other arguments that are none.")
      .def_property_readonly(
          "problems", [](const CurveNetwork& network) { return network.problems(); },
          "NetworkProblems; notes last.")
      .def_property_readonly("curves", [](const CurveNetwork& n) { return n.curves(); })
      .def_property_readonly(
          "region_count",
          [](const CurveNetwork& n) { return static_cast<int>(n.regions().size()); })
      .def("sides", &region_sides_of, py::arg("region"),
           "Of a region, counter-clockwise seen from outside: lists of tuples (edge, whether it is "
           "gone along).")
      .def(
          "with_curve",
          [](const CurveNetwork& network, const NetworkCurve& curve, int number) {
            const py::gil_scoped_release release;
            return std::make_unique<CurveNetwork>(network.with_curve(number, curve));
          },
          py::arg("curve"), py::arg("number"),
          "The CurveNetwork with a NetworkCurve in place of the one of that number. What curves "
          "meet that stay as they are, is not looked for again. ValueError for a number that none "
          "has.")
      .def(
          "with_curves",
          [](const CurveNetwork& network, const std::vector<NetworkCurve>& curves) {
            const py::gil_scoped_release release;
            return std::make_unique<CurveNetwork>(network.with_curves(curves));
          },
          py::arg("curves"),
          "The same with all NetworkCurves given, of which several may be others than before. "
          "ValueError where they are not as many.")
      .def("patch", &CurveNetwork::patch, py::arg("region"),
           "The TransfinitePatch of a region. ValueError where it has one side, more than ten, or "
           "an edge with a halt.");
  bind_parts(bound);
  module.def(
      "network_meetings",
      [](const std::vector<NetworkCurve>& curves, double tolerance) {
        std::vector<network::Contact> found;
        {
          const py::gil_scoped_release release;
          found = network::network_meetings(curves, tolerance);
        }
        py::list meetings;
        for (const network::Contact& contact : found) {
          meetings.append(py::make_tuple(
              contact.first.curve, contact.second.curve,
              to_array(std::vector<Vector3d>{contact.first.place, contact.second.place})));
        }
        return meetings;
      },
      py::arg("curves"), py::arg("tolerance"),
      "Where NetworkCurves come within a tolerance, m, of one another, of each coherent stretch "
      "once: tuples (number of a curve, of another one or the same, places (2, 3) on both, m). "
      "ValueError for a curve that cannot be made.");
  module.def(
      "network_check",
      [](const std::vector<NetworkCurve>& curves, double tolerance, double near_misses,
         double plane_angle) {
        const NetworkOptions options = options_from(tolerance, near_misses, plane_angle);
        const py::gil_scoped_release release;
        return network::network_check(curves, options);
      },
      py::arg("curves"), py::arg("tolerance"), py::kw_only(), py::arg("near_misses") = 10.0,
      py::arg("plane_angle") = 0.035,
      "The problems of NetworkCurves as a CurveNetwork; none where it is sound.");
}

}  // namespace hull::bindings
