// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/move_limits.h"

#include <stdexcept>
#include <string>
#include <tuple>

namespace hull::bindings {
namespace {

modelling::MoveLimits alone_from(const py::object& locked, const py::object& held_points,
                                 const DoubleArray& held_normals) {
  modelling::MoveLimits limits{integers_from(locked, "locked"), {}};
  const std::vector<int> points = integers_from(held_points, "held_points");
  const std::vector<Vector3d> normals = points_from(held_normals, "held_normals");
  if (points.size() != normals.size()) {
    throw std::invalid_argument("held_points and held_normals must be of equal length, not " +
                                std::to_string(points.size()) + " and " +
                                std::to_string(normals.size()) + ".");
  }
  for (std::size_t i = 0; i < points.size(); ++i) limits.held.push_back({points[i], normals[i]});
  return limits;
}

std::vector<modelling::TiedPoint> ties_from(const py::object& tied, const DoubleArray& directions) {
  const std::vector<std::array<int, 2>> pairs = pairs_from(tied, "tied");
  const std::vector<Vector3d> vectors = points_from(directions, "tied_directions");
  if (pairs.size() != vectors.size()) {
    throw std::invalid_argument("There must be as many tied_directions as pairs tied, " +
                                std::to_string(pairs.size()) + ", not " +
                                std::to_string(vectors.size()) + ".");
  }
  std::vector<modelling::TiedPoint> result;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    result.push_back({pairs[i][0], pairs[i][1], vectors[i]});
  }
  return result;
}

}  // namespace

modelling::ReshapeLimits limits_from(const py::object& locked, const py::object& held_points,
                                     const DoubleArray& held_normals, const py::object& tied,
                                     const DoubleArray& tied_directions, const py::iterable& kept) {
  return {alone_from(locked, held_points, held_normals),
          ties_from(tied, tied_directions),
          {},
          conditions_from(kept, "kept")};
}

std::vector<modelling::MoveCondition> conditions_from(const py::iterable& conditions,
                                                      const std::string& what) {
  std::vector<modelling::MoveCondition> result;
  for (const py::handle item : conditions) {
    const std::string name = what + "[" + std::to_string(result.size()) + "]";
    try {
      const auto [points, slopes] = item.cast<std::tuple<py::object, DoubleArray>>();
      result.push_back({integers_from(points, (name + "[0]").c_str()),
                        points_from(slopes, (name + "[1]").c_str())});
    } catch (const py::cast_error&) {
      throw std::invalid_argument(name + " must be (control points (k,), slopes (k, 3)).");
    }
  }
  return result;
}

}  // namespace hull::bindings
