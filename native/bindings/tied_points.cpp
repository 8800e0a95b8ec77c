// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/tied_points.h"

#include <array>
#include <stdexcept>
#include <string>

namespace hull::bindings {

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

}  // namespace hull::bindings
