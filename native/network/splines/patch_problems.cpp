// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/patch_problems.h"

#include <set>

namespace hull::network {

namespace {

NetworkProblem of_region(NetworkProblem::Kind kind, const NetworkFrame& frame,
                         const std::vector<RegionSide>& sides) {
  NetworkProblem problem{kind, "", {}, {}};
  std::set<int> curves;
  for (const RegionSide& side : sides) {
    const RegionEdge& first = side.front();
    const CurveEdge& edge = frame.joined.edges[static_cast<std::size_t>(first.edge)];
    problem.places.push_back(
        frame.joined.nodes[static_cast<std::size_t>(first.is_along ? edge.from : edge.to)]);
    for (const RegionEdge& one : side) {
      curves.insert(frame.joined.edges[static_cast<std::size_t>(one.edge)].curve);
    }
  }
  problem.curves.assign(curves.begin(), curves.end());
  problem.what = "The region at " + place_text(problem.places.front());
  return problem;
}

}  // namespace

NetworkProblem open_region(const NetworkFrame& frame, const std::vector<RegionSide>& sides,
                           const std::string& reason) {
  NetworkProblem problem = of_region(NetworkProblem::Kind::kOpenRegion, frame, sides);
  problem.what += " is left open: " + reason;
  return problem;
}

NetworkProblem loose_region(const NetworkFrame& frame, const std::vector<RegionSide>& sides) {
  NetworkProblem problem = of_region(NetworkProblem::Kind::kLooseRegion, frame, sides);
  problem.what +=
      " is not everywhere smooth with its neighbours: the tangent planes along its border "
      "contradict one another. Move curves that nearly touch there apart, or divide it.";
  return problem;
}

NetworkProblem missed_curve(const std::string& name, int curve, const Vector3d& place,
                            double error) {
  return {NetworkProblem::Kind::kMissedCurve,
          "The surface is " + length_text(error) + " off curve " + name + " near " +
              place_text(place) +
              ": let the curve have a knuckle where it bends sharply, or a "
              "point more there.",
          {curve},
          {place}};
}

}  // namespace hull::network
