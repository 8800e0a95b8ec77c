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

}  // namespace

double angle_around(const Vector3d& normal, const Vector3d& from, const Vector3d& to) {
  const Vector3d right = (from - normal.dot(from) * normal).normalized();
  const double angle = std::atan2(to.dot(normal.cross(right)), to.dot(right));
  // Faces may have more than half a turn at a node.
  return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

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
      // Both seen from the node: the way that was come, and the way on.
      const Vector3d back =
          shapes[static_cast<std::size_t>(side.edge)].tangent_from(!side.is_along);
      const Vector3d on = shapes[static_cast<std::size_t>(next.edge)].tangent_from(next.is_along);
      // The only edge of a node turns right round.
      const bool is_back = order.around[node].size() == 1;
      // At a node the way turns by what its inner angle lacks of half a turn.
      turn += std::numbers::pi -
              (is_back ? 2.0 * std::numbers::pi : angle_around(order.normals[node], on, back));
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
