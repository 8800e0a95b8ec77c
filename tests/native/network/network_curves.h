// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "network/model/curve_network.h"

namespace hull::testing {

using network::CurveDefinition;
using network::CurveNetwork;
using network::NetworkCurve;
using network::NetworkOptions;
using network::NetworkProblem;

// Through points of a way over 0 … 1.
inline NetworkCurve curve_along(const std::string& name, const std::function<Vector3d(double)>& way,
                                int count = 9,
                                NetworkCurve::Kind kind = NetworkCurve::Kind::kFree) {
  NetworkCurve curve;
  curve.definition.name = name;
  curve.kind = kind;
  for (int i = 0; i < count; ++i) {
    curve.definition.points.push_back(way(static_cast<double>(i) / (count - 1)));
  }
  return curve;
}

inline NetworkCurve line_between(const std::string& name, const Vector3d& from,
                                 const Vector3d& to) {
  NetworkCurve curve;
  curve.definition.name = name;
  curve.definition.kind = CurveDefinition::Kind::kLine;
  curve.definition.points = {from, to};
  return curve;
}

// Curves u = i / first and v = k / second of a surface over the unit square; a point where each two
// of them cross, and `between` others between those.
inline std::vector<NetworkCurve> net_on(const std::function<Vector3d(double, double)>& surface,
                                        int first, int second, int between) {
  std::vector<NetworkCurve> curves;
  for (int i = 0; i <= first; ++i) {
    const double u = static_cast<double>(i) / first;
    curves.push_back(curve_along(
        "U" + std::to_string(i), [&](double t) { return surface(u, t); },
        second * (between + 1) + 1));
  }
  for (int k = 0; k <= second; ++k) {
    const double v = static_cast<double>(k) / second;
    curves.push_back(curve_along(
        "V" + std::to_string(k), [&](double t) { return surface(t, v); },
        first * (between + 1) + 1));
  }
  return curves;
}

inline constexpr double kTol = 1e-3;

inline NetworkOptions with_tolerance(double tolerance = kTol) {
  NetworkOptions options;
  options.joining.tolerance = tolerance;
  return options;
}

inline CurveNetwork network_of(std::vector<NetworkCurve> curves, double tolerance = kTol) {
  return CurveNetwork(std::move(curves), with_tolerance(tolerance));
}

inline std::vector<NetworkProblem::Kind> kinds_of(const CurveNetwork& network) {
  std::vector<NetworkProblem::Kind> kinds;
  for (const NetworkProblem& problem : network.problems()) kinds.push_back(problem.kind);
  return kinds;
}

inline std::string told(const CurveNetwork& network) {
  std::string all;
  for (const NetworkProblem& problem : network.problems()) all += problem.what + "\n";
  return all;
}

inline std::vector<NetworkCurve> square() {
  return net_on([](double u, double v) { return Vector3d(10 * u, 10 * v, 0); }, 1, 1, 2);
}

inline Vector3d torus(double u, double v) {
  const double a = 1.4 * u, b = 1.2 * v - 0.3;
  const double reach = 10.0 + 3.0 * std::cos(b);
  return {reach * std::sin(a), reach * std::cos(a), 3.0 * std::sin(b)};
}

// Two planes with a knuckle of an angle along y = 5, with lines across.
inline std::vector<NetworkCurve> chine(double angle) {
  const auto at = [angle](double x, double t) {
    const double over = std::max(0.0, t - 5.0);
    return Vector3d(x, std::min(t, 5.0) + over * std::cos(angle), -over * std::sin(angle));
  };
  std::vector<NetworkCurve> curves;
  for (double t : {0.0, 5.0, 10.0}) {
    curves.push_back(line_between("L" + std::to_string(int(t)), at(0, t), at(12, t)));
  }
  for (double x : {0.0, 4.0, 8.0, 12.0}) {
    NetworkCurve frame;
    frame.definition.name = "S" + std::to_string(int(x));
    frame.definition.points = {at(x, 0), at(x, 5), at(x, 10)};
    frame.definition.knuckles = {1};
    curves.push_back(frame);
  }
  return curves;
}

}  // namespace hull::testing
