// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/curves/network_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modelling/fairing/curve_smoothing.h"
#include "modelling/fairing/spline_ends.h"
#include "network/curves/conics.h"
#include "network/curves/master_order.h"
#include "network/joining/network_problem.h"

namespace hull::network {
namespace {

using modelling::CurveEnd;

constexpr double kNoDirection = 1e-12;  // of a direction's length in a plane

// The unit tangent and the curvature vector, 1/m, that a curve has at one of its ends; what is not
// asked for is not there.
struct EndShape {
  std::optional<Vector3d> tangent, curvature;
  bool is_straight = false;
};

// Makes the shape of one curve; its masters have theirs.
class Shaping {
 public:
  Shaping(const CurveDefinition& definition, const std::vector<CurveDefinition>& definitions,
          const std::vector<CurveShape>& shapes, double tolerance)
      : definition_(definition),
        definitions_(definitions),
        shapes_(shapes),
        tolerance_(tolerance) {}

  CurveShape run() const;

 private:
  [[noreturn]] void refuse(const std::string& reason) const {
    throw std::invalid_argument("Curve " + definition_.name + ": " + reason);
  }
  void check() const;
  // What a function makes; what it refuses is refused with the curve's name.
  template <class Make>
  auto named(const Make& make) const {
    try {
      return make();
    } catch (const std::invalid_argument& fault) {
      refuse(fault.what());
    }
  }
  CurveShape simple() const;
  NurbsCurve line() const;
  NurbsCurve arc(const EndShape& start) const;
  NurbsCurve conic(const EndShape& start, const EndShape& end) const;
  CurveShape free() const;
  NurbsCurve piece(std::size_t from, std::size_t to, const EndShape& start, const EndShape& end,
                   double* error) const;
  EndShape end_shape(const EndCondition& condition, bool is_start) const;
  EndShape of_master(const EndCondition& condition, bool is_start) const;
  Vector3d in_plane(const Vector3d& direction) const;

  const CurveDefinition& definition_;
  const std::vector<CurveDefinition>& definitions_;
  const std::vector<CurveShape>& shapes_;
  double tolerance_;
};

void Shaping::check() const {
  const auto& points = definition_.points;
  if (points.size() < 2) refuse("it needs two points or more.");
  for (const Vector3d& point : points) {
    if (!point.allFinite()) refuse("one of its points is no place.");
  }
  if (!definition_.weights.empty() && definition_.weights.size() != points.size()) {
    refuse("it needs a weight for each point, or none.");
  }
  int before = 0;
  for (int knuckle : definition_.knuckles) {
    if (knuckle <= before || knuckle >= static_cast<int>(points.size()) - 1) {
      refuse("knuckles are points between its ends, in order.");
    }
    before = knuckle;
  }
  if (!definition_.plane) return;
  const CarrierPlane& plane = *definition_.plane;
  const double length = plane.normal.norm();
  if (!(length > 0.0) || !std::isfinite(length + plane.distance)) refuse("its plane is none.");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double off = std::abs(plane.normal.dot(points[i]) - plane.distance) / length;
    if (off > tolerance_) {
      refuse("point " + std::to_string(i) + " is " + length_text(off) + " off its plane.");
    }
  }
}

Vector3d Shaping::in_plane(const Vector3d& direction) const {
  if (!direction.allFinite() || !(direction.norm() > 0.0))
    refuse("a direction at its end is none.");
  Vector3d inside = direction.normalized();
  if (!definition_.plane) return inside;
  const Vector3d normal = definition_.plane->normal.normalized();
  inside -= inside.dot(normal) * normal;
  if (!(inside.norm() > kNoDirection))
    refuse("a direction at its end is that of its plane's normal.");
  return inside.normalized();
}

EndShape Shaping::end_shape(const EndCondition& condition, bool is_start) const {
  EndShape shape;
  switch (condition.kind) {
    case EndCondition::Kind::kFree:
      break;
    case EndCondition::Kind::kStraight:
      shape.is_straight = true;
      break;
    case EndCondition::Kind::kTangent:
      shape.tangent = in_plane(condition.direction);
      break;
    default:
      return of_master(condition, is_start);
  }
  return shape;
}

EndShape Shaping::of_master(const EndCondition& condition, bool is_start) const {
  const auto& points = definition_.points;
  const Vector3d end = is_start ? points.front() : points.back();
  const NurbsCurve* nearest = nullptr;
  double parameter = 0.0, least = 0.0;
  for (const NurbsCurve& curve : shapes_[static_cast<std::size_t>(condition.master)].pieces) {
    const double t = curve.nearest_parameter(end);
    const double distance = (curve.point(t) - end).norm();
    if (nearest != nullptr && distance >= least) continue;
    nearest = &curve;
    parameter = t;
    least = distance;
  }
  if (least > tolerance_) {
    refuse("its " + std::string(is_start ? "start" : "end") + " is " + length_text(least) +
           " from " + definitions_[static_cast<std::size_t>(condition.master)].name +
           ", its master.");
  }
  const Points3 jet = nearest->evaluate(parameter, 2);
  const Vector3d d1 = jet.row(1), d2 = jet.row(2);
  EndShape shape;
  shape.tangent = in_plane(d1);
  const Vector3d along = is_start ? points[1] - points[0] : end - points[points.size() - 2];
  // A master runs its own way: its slave's points there tell the sense.
  if (shape.tangent->dot(along) < 0.0) *shape.tangent *= -1.0;
  if (condition.kind == EndCondition::Kind::kSlaveCurvature) {
    // The normal part of the second derivative over the squared speed; in a plane the part there.
    Vector3d bend = (d2 - d2.dot(d1) / d1.squaredNorm() * d1) / d1.squaredNorm();
    if (definition_.plane) {
      const Vector3d normal = definition_.plane->normal.normalized();
      bend -= bend.dot(normal) * normal;
    }
    shape.curvature = bend - bend.dot(*shape.tangent) * *shape.tangent;
  }
  return shape;
}

CurveEnd condition_at(const Vector3d& place, const EndShape& shape) {
  CurveEnd end;
  end.is_straight = shape.is_straight;
  end.given.resize(1 + (shape.tangent ? 1 : 0) + (shape.curvature ? 1 : 0), 3);
  end.given.row(0) = place;
  // Chord lengths are the parameters: the speed is 1, or near it.
  if (shape.tangent) end.given.row(1) = *shape.tangent;
  if (shape.curvature) end.given.row(2) = *shape.curvature;
  return end;
}

NurbsCurve Shaping::piece(std::size_t from, std::size_t to, const EndShape& start,
                          const EndShape& end, double* error) const {
  const auto count = static_cast<Eigen::Index>(to - from + 1);
  Eigen::MatrixXd points(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    points.row(i) = definition_.points[from + static_cast<std::size_t>(i)];
  }
  modelling::SmoothingOptions options;
  options.start = condition_at(points.row(0), start);
  options.end = condition_at(points.row(count - 1), end);
  options.knots_at_points = true;
  if (!definition_.weights.empty()) {
    const auto at = [&](std::size_t i) {
      return definition_.weights.begin() + static_cast<std::ptrdiff_t>(i);
    };
    options.weights.assign(at(from), at(to) + 1);
  }
  const auto conditions = [&] {
    using modelling::SplineEnds;
    return static_cast<int>(count) + SplineEnds::extra(options.start) +
           SplineEnds::extra(options.end);
  };
  // A polynomial of two degrees or one has no end without curvature but on a straight line.
  if (conditions() < 4) options.start.is_straight = options.end.is_straight = false;
  // Conditions have given rows besides the places: a second derivative takes a quintic.
  options.degree = std::min(start.curvature || end.curvature ? 5 : 3, conditions() - 1);
  const modelling::SmoothCurve smooth =
      named([&] { return modelling::smooth_curve(points, definition_.deviation, options); });
  *error += smooth.error;
  return {smooth.degree, smooth.knots, smooth.coefficients};
}

CurveShape Shaping::free() const {
  std::vector<std::size_t> breaks{0};
  for (int knuckle : definition_.knuckles) breaks.push_back(static_cast<std::size_t>(knuckle));
  breaks.push_back(definition_.points.size() - 1);
  const EndShape start = end_shape(definition_.start, true),
                 end = end_shape(definition_.end, false);
  CurveShape shape;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    shape.pieces.push_back(piece(breaks[k], breaks[k + 1], k == 0 ? start : EndShape(),
                                 k + 2 == breaks.size() ? end : EndShape(), &shape.error));
  }
  return shape;
}

NurbsCurve Shaping::line() const {
  if (definition_.points.size() != 2) refuse("a straight line has two points.");
  Points3 ends(2, 3);
  ends << definition_.points[0].transpose(), definition_.points[1].transpose();
  return {1, {0.0, 0.0, 1.0, 1.0}, ends};
}

NurbsCurve Shaping::arc(const EndShape& start) const {
  const auto& points = definition_.points;
  if (points.size() == 3) {
    return named([&] { return arc_through(points[0], points[1], points[2]); });
  }
  if (points.size() != 2 || !start.tangent) {
    refuse("a circular arc has three points, or two and a direction at its start.");
  }
  return named([&] { return arc_from_tangent(points[0], *start.tangent, points[1]); });
}

NurbsCurve Shaping::conic(const EndShape& start, const EndShape& end) const {
  const auto& points = definition_.points;
  if (points.size() != 2 || !start.tangent || !end.tangent) {
    refuse("a conic has two points and directions at both.");
  }
  const auto apex = apex_of(points[0], *start.tangent, points[1], -*end.tangent);
  if (!apex || (apex->place - points[0]).dot(*start.tangent) <= 0.0 ||
      (points[1] - apex->place).dot(*end.tangent) <= 0.0) {
    refuse("the directions at its ends do not meet between them.");
  }
  // A conic is in one plane: towards the middle of two places it would leave in other directions.
  if (apex->apart > tolerance_) {
    refuse("the lines along the directions at its ends miss one another by " +
           length_text(apex->apart) + ": give directions in one plane with both points.");
  }
  return named([&] { return conic_arc(points[0], apex->place, points[1], definition_.fullness); });
}

CurveShape Shaping::simple() const {
  if (!definition_.knuckles.empty()) refuse("only a free curve has knuckles.");
  const EndShape start = end_shape(definition_.start, true);
  const EndShape end = end_shape(definition_.end, false);
  switch (definition_.kind) {
    case CurveDefinition::Kind::kLine:
      return {{line()}};
    case CurveDefinition::Kind::kArc:
      return {{arc(start)}};
    default:
      return {{conic(start, end)}};
  }
}

CurveShape Shaping::run() const {
  check();
  return definition_.kind == CurveDefinition::Kind::kFree ? free() : simple();
}

}  // namespace

std::vector<CurveShape> network_curve_shapes(const std::vector<CurveDefinition>& definitions,
                                             double tolerance) {
  std::vector<CurveShape> shapes(definitions.size());
  for (int number : masters_first(definitions)) {
    const auto curve = static_cast<std::size_t>(number);
    shapes[curve] = Shaping(definitions[curve], definitions, shapes, tolerance).run();
  }
  return shapes;
}

}  // namespace hull::network
