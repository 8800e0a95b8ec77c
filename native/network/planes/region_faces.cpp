// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/planes/region_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace hull::network {
namespace {

constexpr int kTurnSteps = 16;

double turn_along(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes,
                  const NodeOrder& order, const RegionEdge& side) {
  const CurveEdge& edge = joined.edges[static_cast<std::size_t>(side.edge)];
  const EdgeShape& shape = shapes[static_cast<std::size_t>(side.edge)];
  const Vector3d& from = order.normals[static_cast<std::size_t>(edge.from)];
  const Vector3d& to = order.normals[static_cast<std::size_t>(edge.to)];
  double turn = 0.0;
  // The angles between tangents, seen along normals that go evenly from one node's to the other's:
  // what the edge turns within the surface.
  Vector3d before = shape.tangent_from(true);
  for (int i = 1; i <= kTurnSteps; ++i) {
    const double u = static_cast<double>(i) / kTurnSteps;
    const Vector3d next = i == kTurnSteps ? Vector3d(-shape.tangent_from(false))
                                          : Vector3d(shape.evaluate(u, 1).row(1)).normalized();
    const Vector3d normal = ((1.0 - u) * from + u * to).normalized();
    turn += std::atan2(normal.dot(before.cross(next)), before.dot(next));
    before = next;
  }
  // The other way round it turns to the other side, seen along the same normals.
  return side.is_along ? turn : -turn;
}

// The inner angle of a face that comes to a node and goes on along an end.
double inner_angle(const NodeOrder& order, std::size_t node, const RegionEdge& on) {
  const auto& ends = order.around[node];
  const auto at = std::ranges::find_if(
      ends, [&](const EdgeEnd& end) { return end.edge == on.edge && end.is_start == on.is_along; });
  // Counterclockwise from there comes the end by which it came.
  return order.angles[node][static_cast<std::size_t>(at - ends.begin())];
}

}  // namespace

RegionFaces region_faces(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes,
                         const NodeOrder& order) {
  std::vector<NetworkEdge> edges;
  for (const CurveEdge& edge : joined.edges) edges.push_back({edge.from, edge.to, edge.curve});
  RegionFaces faces{regions_between(static_cast<int>(joined.nodes.size()), edges, order.around),
                    {},
                    {},
                    std::vector<int>(2 * edges.size(), -1)};
  const Shells& shells = faces.topology.shells;
  std::vector<RegionEdge> side_of_half(static_cast<std::size_t>(shells.half_edges().end()));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int half = faces.topology.half_of_edge[e];
    // Either half has the face of its side to its left.
    side_of_half[static_cast<std::size_t>(half)] = {static_cast<int>(e), true};
    side_of_half[static_cast<std::size_t>(shells.mate(half))] = {static_cast<int>(e), false};
  }
  std::vector<double> turns;
  for (int face : shells.faces().numbers()) {
    faces.loops.emplace_back();
    double turn = 0.0;
    for (int half : shells.half_edges_of(shells.faces()[face].outer)) {
      const RegionEdge side = side_of_half[static_cast<std::size_t>(half)];
      faces.loops.back().push_back(side);
      const RegionEdge next =
          side_of_half[static_cast<std::size_t>(shells.half_edges()[half].next)];
      const CurveEdge& edge = joined.edges[static_cast<std::size_t>(side.edge)];
      const auto node = static_cast<std::size_t>(side.is_along ? edge.to : edge.from);
      // At a node the way turns by what its inner angle lacks of half a turn.
      turn += std::numbers::pi - inner_angle(order, node, next);
      turn += turn_along(joined, shapes, order, side);
    }
    turns.push_back(turn);
  }
  const auto least = std::ranges::min_element(turns) - turns.begin();
  faces.border = std::move(faces.loops[static_cast<std::size_t>(least)]);
  // Regions behind it have a number less than their faces had.
  faces.loops.erase(faces.loops.begin() + least);
  for (std::size_t region = 0; region < faces.loops.size(); ++region) {
    for (const RegionEdge& side : faces.loops[region]) {
      faces.region_of_side[2 * static_cast<std::size_t>(side.edge) + (side.is_along ? 0 : 1)] =
          static_cast<int>(region);
    }
  }
  return faces;
}

}  // namespace hull::network
