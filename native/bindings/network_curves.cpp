// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "bindings/arrays.h"
#include "bindings/network_classes.h"
#include "network/model/curve_network.h"

namespace hull::bindings {
namespace {

using network::CurveDefinition;
using network::EndCondition;
using network::NetworkCurve;

template <class Kind, std::size_t count>
using KindNames = std::array<std::pair<const char*, Kind>, count>;

constexpr KindNames<NetworkCurve::Kind, 8> kCurveKinds{{
    {"station", NetworkCurve::Kind::kStation},
    {"waterline", NetworkCurve::Kind::kWaterline},
    {"buttock", NetworkCurve::Kind::kButtock},
    {"diagonal", NetworkCurve::Kind::kDiagonal},
    {"free", NetworkCurve::Kind::kFree},
    {"knuckle", NetworkCurve::Kind::kKnuckle},
    {"profile", NetworkCurve::Kind::kProfile},
    {"deck_edge", NetworkCurve::Kind::kDeckEdge},
}};
constexpr KindNames<NetworkCurve::Role, 2> kCurveRoles{{
    {"boundary", NetworkCurve::Role::kBoundary},
    {"reference", NetworkCurve::Role::kReference},
}};
constexpr KindNames<CurveDefinition::Kind, 4> kShapeKinds{{
    {"free", CurveDefinition::Kind::kFree},
    {"line", CurveDefinition::Kind::kLine},
    {"arc", CurveDefinition::Kind::kArc},
    {"conic", CurveDefinition::Kind::kConic},
}};
constexpr KindNames<EndCondition::Kind, 5> kEndKinds{{
    {"free", EndCondition::Kind::kFree},
    {"tangent", EndCondition::Kind::kTangent},
    {"straight", EndCondition::Kind::kStraight},
    {"slave_tangent", EndCondition::Kind::kSlaveTangent},
    {"slave_curvature", EndCondition::Kind::kSlaveCurvature},
}};

template <class Kind, std::size_t count>
Kind kind_named(const KindNames<Kind, count>& names, const std::string& given,
                const char* argument) {
  std::string all;
  for (const auto& [name, kind] : names) {
    if (given == name) return kind;
    all += (all.empty() ? "'" : ", '") + std::string(name) + "'";
  }
  throw std::invalid_argument(std::string(argument) + " is one of " + all + ", not '" + given +
                              "'.");
}

template <class Kind, std::size_t count>
const char* name_of_kind(const KindNames<Kind, count>& names, Kind kind) {
  for (const auto& [name, its_kind] : names) {
    if (its_kind == kind) return name;
  }
  return "";
}

EndCondition curve_end_from(const std::string& kind, const py::object& direction, int master) {
  EndCondition end;
  end.kind = kind_named(kEndKinds, kind, "kind");
  if (!direction.is_none()) end.direction = point_from(DoubleArray(direction), "direction");
  end.master = master;
  return end;
}

EndCondition end_condition_from(const py::object& end, const char* name) {
  if (end.is_none()) return {};
  if (!py::isinstance<EndCondition>(end)) {
    throw py::type_error(std::string(name) + " has to be a CurveEnd, or None.");
  }
  return end.cast<EndCondition>();
}

std::optional<network::CarrierPlane> carrier_from(const py::object& plane) {
  if (plane.is_none()) return std::nullopt;
  const std::vector<double> numbers = numbers_from(DoubleArray(plane), "plane");
  if (numbers.size() != 4) {
    throw std::invalid_argument(
        "plane has to be of shape (4,): a normal x, y, z and an offset, for normal·p = offset.");
  }
  return network::CarrierPlane{{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

NetworkCurve network_curve_from(const std::string& name, const DoubleArray& points,
                                const std::string& kind, const std::string& shape,
                                const DoubleArray& weights, const py::object& knuckles,
                                double deviation, double fullness, const py::object& plane,
                                const py::object& start, const py::object& end,
                                const std::string& role) {
  NetworkCurve curve;
  curve.role = kind_named(kCurveRoles, role, "role");
  curve.kind = kind_named(kCurveKinds, kind, "kind");
  CurveDefinition& definition = curve.definition;
  definition.name = name;
  definition.kind = kind_named(kShapeKinds, shape, "shape");
  definition.points = points_from(points, "points");
  definition.weights = numbers_from(weights, "weights");
  definition.knuckles = integers_from(knuckles, "knuckles");
  definition.deviation = deviation;
  definition.fullness = fullness;
  definition.start = end_condition_from(start, "start");
  definition.end = end_condition_from(end, "end");
  definition.plane = carrier_from(plane);
  return curve;
}

}  // namespace

void bind_network_curves(py::module_& module) {
  py::class_<EndCondition>(module, "CurveEnd", "How a NetworkCurve begins or ends.")
      .def(py::init(&curve_end_from), py::arg("kind") = "free", py::kw_only(),
           py::arg("direction") = py::none(), py::arg("master") = -1,
           "kind: 'free', 'straight' (without curvature), 'tangent' (with a direction (3,) along "
           "the curve), 'slave_tangent' or 'slave_curvature' (as the curve of the number master is "
           "there). ValueError for another kind.")
      .def_property_readonly(
          "kind", [](const EndCondition& end) { return name_of_kind(kEndKinds, end.kind); })
      .def_property_readonly(
          "direction",
          [](const EndCondition& end) { return py::array_t<double>(3, end.direction.data()); },
          "(3,)")
      .def_readonly("master", &EndCondition::master);
  py::class_<NetworkCurve>(module, "NetworkCurve", "A curve of a CurveNetwork.")
      .def(py::init(&network_curve_from), py::arg("name"), py::arg("points"), py::kw_only(),
           py::arg("kind") = "free", py::arg("shape") = "free", py::arg("weights") = py::tuple(),
           py::arg("knuckles") = py::tuple(), py::arg("deviation") = 0.0, py::arg("fullness") = 1.0,
           py::arg("plane") = py::none(), py::arg("start") = py::none(),
           py::arg("end") = py::none(), py::arg("role") = "boundary",
           "points (n, 3), m. kind: 'station', 'waterline', 'buttock', 'diagonal', 'free', "
           "'knuckle' (the surface has one along it), 'profile' or 'deck_edge'. shape: 'free' (a "
           "smooth spline), 'line' of two points, 'arc' of three points, or of two and a tangent "
           "at the start, 'conic' of two points and tangents at both, with a fullness below 1 for "
           "an ellipse, 1 for a parabola, above 1 for a hyperbola. Of free curves: weights (n,) of "
           "points, knuckles (k,) numbers of points between the ends, deviation, m, in the mean "
           "from the points (0: they are met). plane (4,): a normal and an offset, in which it "
           "stays. start, end: CurveEnds; None: free. role, for network_patches: 'boundary', along "
           "which patches have borders, or 'reference', which they pass through. What does not fit "
           "is among the problems of the network.")
      .def_property_readonly(
          "role", [](const NetworkCurve& curve) { return name_of_kind(kCurveRoles, curve.role); })
      .def_property_readonly("name",
                             [](const NetworkCurve& curve) { return curve.definition.name; })
      .def_property_readonly(
          "kind", [](const NetworkCurve& curve) { return name_of_kind(kCurveKinds, curve.kind); })
      .def_property_readonly("shape",
                             [](const NetworkCurve& curve) {
                               return name_of_kind(kShapeKinds, curve.definition.kind);
                             })
      .def_property_readonly(
          "points", [](const NetworkCurve& curve) { return to_array(curve.definition.points); },
          "(n, 3), m.");
}

}  // namespace hull::bindings
