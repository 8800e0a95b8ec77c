// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/developable/strip_makers.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace hull::production {
namespace {

constexpr double kNoSine = 1e-9;  // of an angle with a direction: along it
// Of the size of strip and polyline: what is so near behind a ray's start is at it.
constexpr double kOnStrip = 1e-12;

// Unit vector. `what` names it in the error.
Vector3d unit_of(const Vector3d& v, const char* what) {
  if (!v.allFinite() || v.norm() == 0.0) {
    throw std::invalid_argument(std::string(what) + " must be finite, and not (0, 0, 0).");
  }
  return v.normalized();
}

// Parameters of rulings, `count` intervals or some more, so that joints are among their ends.
std::vector<double> even_parameters(const BezierChain& a, int count) {
  check_interval_count(count);
  const int spans = a.span_count(), per_span = (count + spans - 1) / spans;
  std::vector<double> s;
  for (int i = 0; i <= spans * per_span; ++i) s.push_back(static_cast<double>(i) / per_span);
  return s;
}

// Refuses rulings along the curve, where the surface has no tangent plane.
void check_aside(const BezierChain& a, double s, const Vector3d& ruling, const char* remedy) {
  const surface::CurveJet jet = a.at(s);
  const double off = jet.d1.cross(ruling).norm();
  if (off > kNoSine * jet.d1.norm() * ruling.norm()) return;
  throw std::invalid_argument("The curve runs along the straight line at its parameter " +
                              std::to_string(s) + ": " + remedy);
}

// Where the rays from a segment meet a ruling's line.
struct Meeting {
  double along;  // of the ruling
  double ray;    // m on the ray
};

// `zero`: a distance, m, that is rounding.
std::optional<Meeting> meeting(const Vector3d& from, const Vector3d& to, const Vector3d& direction,
                               const Vector3d& on_a, const Vector3d& on_b, double zero) {
  // The ruling's line is cut by the plane of the segment and its rays.
  const Vector3d way = to - from, q = on_b - on_a, normal = direction.cross(way);
  const double rise = normal.dot(q);
  // No plane where the segment runs along the rays, no point where the ruling lies in it.
  if (std::abs(rise) <= 1e-14 * normal.norm() * q.norm()) return std::nullopt;
  const double along = normal.dot(from - on_a) / rise;
  const Vector3d off = on_a + along * q - from;
  // Across the ray, in the plane of both.
  const Vector3d aside = way - way.dot(direction) * direction;
  const double part = off.dot(aside) / aside.squaredNorm();
  // Without the part along the segment what is left runs along the ray.
  const double ray = (off - part * way).dot(direction);
  // Ends count, so that a ruling is not missed between two segments.
  constexpr double kEnd = 1e-12;
  const auto within = [](double t) { return t >= -kEnd && t <= 1.0 + kEnd; };
  if (!within(along) || !within(part) || ray < -zero) return std::nullopt;
  return Meeting{std::clamp(along, 0.0, 1.0), ray};
}

}  // namespace

StripBetween cone_through(const BezierChain& a, const Vector3d& tip, int count) {
  if (!tip.allFinite()) throw std::invalid_argument("The tip of a cone must be finite.");
  StripBetween made{a, BezierChain({BezierSpan{tip, tip, tip, tip}}), {{}, 0, 0}};
  for (const double s : even_parameters(a, count)) {
    check_aside(a, s, tip - a.at(s).point, "move the cone's tip off the curve and its tangents.");
    made.strip.rulings.push_back({s, 0.0});
  }
  return made;
}

StripBetween cylinder_along(const BezierChain& a, const Vector3d& direction, double length,
                            int count) {
  if (!(length > 0.0 && std::isfinite(length))) {
    throw std::invalid_argument("The length of a cylinder's rulings must be above 0 m.");
  }
  const Vector3d along = unit_of(direction, "direction");
  std::vector<BezierSpan> shifted;
  for (int k = 0; k < a.span_count(); ++k) {
    shifted.push_back(a.span(k));
    for (Vector3d& p : shifted.back()) p += length * along;
  }
  StripBetween made{a, BezierChain(std::move(shifted)), {{}, 0, 0}};
  for (const double s : even_parameters(a, count)) {
    check_aside(a, s, along, "give the cylinder another direction.");
    made.strip.rulings.push_back({s, s});
  }
  made.strip.last = static_cast<int>(made.strip.rulings.size()) - 1;
  return made;
}

std::vector<StripLine> projected_on(const StripBetween& strip, const std::vector<Vector3d>& points,
                                    const Vector3d& direction) {
  const Vector3d ray = unit_of(direction, "direction");
  if (points.size() < 2) {
    throw std::invalid_argument("A line that is projected must have two points or more.");
  }
  // A polyline that lies on the strip is met, whatever rounding says of its side.
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points) {
    if (!p.allFinite()) throw std::invalid_argument("The points of a line must be finite.");
    box.extend(p);
  }
  for (const Ruling& one : strip.strip.rulings) {
    box.extend(strip.a.at(one.s).point).extend(strip.b.at(one.t).point);
  }
  const double zero = kOnStrip * box.diagonal().norm();
  std::vector<StripLine> lines;
  int last = -2;  // no ruling is after that: the first one that is met begins a line
  for (int i = 0; i < static_cast<int>(strip.strip.rulings.size()); ++i) {
    const Ruling& ruling = strip.strip.rulings[i];
    const Vector3d on_a = strip.a.at(ruling.s).point, on_b = strip.b.at(ruling.t).point;
    std::optional<Meeting> first;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const auto met = meeting(points[k], points[k + 1], ray, on_a, on_b, zero);
      if (met && (!first || met->ray < first->ray)) first = met;
    }
    if (!first) continue;
    if (i != last + 1) lines.emplace_back();
    lines.back().rulings.push_back(i);
    lines.back().along.push_back(first->along);
    last = i;
  }
  std::erase_if(lines, [](const StripLine& line) { return line.rulings.size() < 2; });
  if (lines.empty()) {
    throw std::invalid_argument(
        "The projected line misses the strip, or runs along its rulings: no two rulings that "
        "follow one another are met.");
  }
  return lines;
}

}  // namespace hull::production
