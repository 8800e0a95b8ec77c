// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "network/model/curve_network.h"

namespace hull::testing {

using network::CurveDefinition;
using network::NetworkCurve;

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

}  // namespace hull::testing
