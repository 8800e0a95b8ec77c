// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/planes/node_order.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "mesh/tolerances.h"

namespace hull::network {
namespace {

constexpr int kReflections = 24;
constexpr double kOneDirection = 0.02;  // rad: tangents that do not tell edges apart
constexpr double kPassesOn = 0.9659;    // the cosine of 15°: two edges that span no plane
// Of products and sums of unit vectors: shorter ones are mostly what rounding and the curves' fit
// leave of directions on one line, or around a point, and tell of no view.
constexpr double kLeastCandidate = 1e-3;
constexpr double kAsGood = 1e-6;  // of what is seen: more than rounding
constexpr double kTurn = 2.0 * std::numbers::pi;

using Ends = std::vector<EdgeEnd>;

const EdgeShape& shape_of(const std::vector<EdgeShape>& shapes, const EdgeEnd& end) {
  return shapes[static_cast<std::size_t>(end.edge)];
}

// In the plane across a normal, from some direction in it, counterclockwise.
struct NodeView {
  Vector3d right, up;

  explicit NodeView(const Vector3d& normal) {
    right = normal.unitOrthogonal();
    up = normal.cross(right);
  }
  double angle(const Vector3d& direction) const {
    return std::atan2(direction.dot(up), direction.dot(right));
  }
};

// How far apart directions are seen along a normal: the least angle between neighbours, by the
// least length in which one is seen.
double spread_seen(const Vector3d& normal, const std::vector<Vector3d>& directions) {
  const NodeView view(normal);
  std::vector<double> angles;
  double least_length = 1.0;
  for (const Vector3d& direction : directions) {
    angles.push_back(view.angle(direction));
    least_length = std::min(least_length, normal.cross(direction).norm());
  }
  std::ranges::sort(angles);
  // Around the circle, from the last one to the first.
  double least = angles.front() + kTurn - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) {
    least = std::min(least, angles[i] - angles[i - 1]);
  }
  return least * least_length;
}

// From 0 to 2 pi, from one direction to another around a normal, counterclockwise.
double angle_around(const Vector3d& normal, const Vector3d& from, const Vector3d& to) {
  const Vector3d right = (from - normal.dot(from) * normal).normalized();
  const double angle = std::atan2(to.dot(normal.cross(right)), to.dot(right));
  // Faces may have more than half a turn at a node.
  return angle < 0.0 ? angle + kTurn : angle;
}

// Zero where two directions on one line leave it open.
Vector3d view_of(const std::vector<Vector3d>& directions) {
  if (directions.size() == 2 && directions[0].dot(directions[1]) < -kPassesOn) {
    return Vector3d::Zero();
  }
  // Normals of two edges see flat stars best, axes of the moments those of many edges, and the sum
  // those that are pointed, as the tip of a cone.
  std::vector<Vector3d> candidates;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < directions.size(); ++i) {
    moments += directions[i] * directions[i].transpose();
    sum += directions[i];
    for (std::size_t k = 0; k < i; ++k) candidates.push_back(directions[k].cross(directions[i]));
  }
  if (directions.size() > 2) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
    for (int i = 0; i < 3; ++i) candidates.emplace_back(axes.eigenvectors().col(i));
    candidates.push_back(sum);
  }
  Vector3d best = Vector3d::Zero();
  double most = 0.0;
  for (const Vector3d& candidate : candidates) {
    if (!(candidate.norm() > kLeastCandidate)) continue;
    const Vector3d normal = candidate.normalized();
    // What is as good is not taken: rounding would choose, else.
    const double seen = spread_seen(normal, directions);
    if (seen <= most * (1.0 + kAsGood)) continue;
    most = seen;
    best = normal;
  }
  return best;
}

// A view by itself has no sense. Senses go from node to node over edges, then the whole is turned
// outwards; only then is there a counterclockwise order.
class Ordering3d {
 public:
  Ordering3d(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes)
      : joined_(joined), shapes_(shapes) {
    order_.around.resize(joined.nodes.size());
    for (std::size_t e = 0; e < joined.edges.size(); ++e) {
      const int edge = static_cast<int>(e);
      order_.around[static_cast<std::size_t>(joined.edges[e].from)].push_back({edge, true});
      order_.around[static_cast<std::size_t>(joined.edges[e].to)].push_back({edge, false});
    }
  }

  NodeOrder run() {
    for (const Ends& ends : order_.around) {
      std::vector<Vector3d> directions;
      for (const EdgeEnd& end : ends) {
        directions.push_back(shape_of(shapes_, end).tangent_from(end.is_start));
      }
      // Zero where edges leave it open: such nodes have what is brought to them.
      order_.normals.push_back(view_of(directions));
    }
    spread_senses();
    turn_outwards();
    order_.angles.resize(order_.around.size());
    for (std::size_t node = 0; node < order_.around.size(); ++node) {
      sort_ends(node);
      set_angles(node);
    }
    return std::move(order_);
  }

 private:
  struct Step {
    double sureness;
    int node;
    Vector3d carried;
    bool operator<(const Step& other) const { return sureness < other.sureness; }
  };

  void spread_senses() {
    const auto is_seen = [](const Vector3d& normal) { return !normal.isZero(0.0); };
    const auto first = std::ranges::find_if(order_.normals, is_seen);
    const int start =
        first == order_.normals.end() ? 0 : static_cast<int>(first - order_.normals.begin());
    std::vector<bool> is_done(order_.normals.size(), false);
    // A tree over the edges along which senses are surest: a node where the surface bends sharply
    // is reached from its other neighbours, if there are any.
    std::priority_queue<Step> steps;
    // Above all cosines: it comes first, and keeps its sense.
    steps.push({2.0, start, first == order_.normals.end() ? Vector3d::UnitZ() : *first});
    while (!steps.empty()) {
      const Step step = steps.top();
      steps.pop();
      const auto node = static_cast<std::size_t>(step.node);
      if (is_done[node]) continue;
      is_done[node] = true;
      Vector3d& normal = order_.normals[node];
      if (!is_seen(normal)) normal = step.carried.normalized();
      if (normal.dot(step.carried) < 0.0) normal = -normal;
      for (const EdgeEnd& end : order_.around[node]) {
        const CurveEdge& edge = joined_.edges[static_cast<std::size_t>(end.edge)];
        const int next = end.is_start ? edge.to : edge.from;
        if (is_done[static_cast<std::size_t>(next)]) continue;
        const Vector3d carried = carried_along(shape_of(shapes_, end), end.is_start, normal);
        const Vector3d& there = order_.normals[static_cast<std::size_t>(next)];
        // The other node's sense is open yet: what counts is how near its line is to what is
        // brought.
        steps.push({is_seen(there) ? std::abs(there.dot(carried)) : 0.0, next, carried});
      }
    }
  }

  void turn_outwards() {
    Eigen::AlignedBox3d box;
    for (const Vector3d& node : joined_.nodes) box.extend(node);
    Vector3d centre = box.center();
    // Seen from the middle of the upper end a hull's bottom faces away as its sides do.
    centre.z() = box.max().z();
    // A half hull has its middle in the centre plane.
    if (box.min().y() >= -kOnCentrePlane * box.diagonal().norm()) centre.y() = 0.0;
    double outwards = 0.0;
    for (std::size_t node = 0; node < joined_.nodes.size(); ++node) {
      outwards += order_.normals[node].dot(joined_.nodes[node] - centre);
    }
    if (outwards >= 0.0) return;
    for (Vector3d& normal : order_.normals) normal = -normal;
  }

  void sort_ends(std::size_t node) {
    const NodeView view(order_.normals[node]);
    Ends& ends = order_.around[node];
    const auto angle = [&](const EdgeEnd& end) {
      return view.angle(shape_of(shapes_, end).tangent_from(end.is_start));
    };
    // By angles, then neighbours too close for that by chords: as often as there are ends, around
    // the circle, which has no first.
    std::ranges::sort(ends, {}, angle);
    const auto is_left_of = [&](const EdgeEnd& a, const EdgeEnd& b) {
      return turned(node, view, b, a) > 0.0;
    };
    for (std::size_t round = 0; round < ends.size(); ++round) {
      for (std::size_t i = 0; i < ends.size() && ends.size() > 1; ++i) {
        EdgeEnd &a = ends[i], &b = ends[(i + 1) % ends.size()];
        double between = std::fmod(angle(b) - angle(a) + 2.0 * kTurn, kTurn);
        between = std::min(between, kTurn - between);
        if (between < kOneDirection && is_left_of(a, b)) std::swap(a, b);
      }
    }
  }

  void set_angles(std::size_t node) {
    const NodeView view(order_.normals[node]);
    const Ends& ends = order_.around[node];
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const EdgeEnd &a = ends[i], &b = ends[(i + 1) % ends.size()];
      double& angle = order_.angles[node].emplace_back(kTurn);
      // The only edge of a node turns right round.
      if (ends.size() == 1) continue;
      angle = angle_around(order_.normals[node], shape_of(shapes_, a).tangent_from(a.is_start),
                           shape_of(shapes_, b).tangent_from(b.is_start));
      // Of edges in one direction rounding tells 0 as often as a whole turn: chords tell, as they
      // do the order.
      const bool is_none = angle < kOneDirection;
      const bool is_whole = angle > kTurn - kOneDirection;
      if (!is_none && !is_whole) continue;
      const double by_chords = turned(node, view, a, b);
      if (is_none && by_chords < 0.0) angle += kTurn;
      if (is_whole && by_chords > 0.0) angle -= kTurn;
    }
  }

  // The angle from one edge to another, by their chords at one distance from the node.
  double turned(std::size_t node, const NodeView& view, const EdgeEnd& from,
                const EdgeEnd& to) const {
    // At one distance from the node: an edge that bends would be compared with what another is
    // further on, else.
    const double reach =
        0.25 * std::min(shape_of(shapes_, from).length(), shape_of(shapes_, to).length());
    const auto seen = [&](const EdgeEnd& end) {
      const EdgeShape& shape = shape_of(shapes_, end);
      const double share = reach / shape.length();
      const Vector3d place = shape.evaluate(end.is_start ? share : 1.0 - share, 0).row(0);
      return view.angle(place - joined_.nodes[node]);
    };
    return std::remainder(seen(to) - seen(from), kTurn);
  }

  const JoinedCurves& joined_;
  const std::vector<EdgeShape>& shapes_;
  NodeOrder order_;
};

}  // namespace

Vector3d carried_along(const EdgeShape& shape, bool from_start, const Vector3d& direction) {
  const auto at = [&](int i) {
    const double u = static_cast<double>(i) / kReflections;
    return shape.evaluate(from_start ? u : 1.0 - u, 1);
  };
  const auto reflected = [](const Vector3d& v, const Vector3d& across) {
    // Where two points or tangents are the same there is no plane to reflect in, and no need.
    const double square = across.squaredNorm();
    return square > 0.0 ? Vector3d(v - 2.0 * across.dot(v) / square * across) : v;
  };
  Vector3d carried = direction;
  Points3 here = at(0);
  for (int i = 1; i <= kReflections; ++i) {
    const Points3 next = at(i);
    const Vector3d chord = (next.row(0) - here.row(0)).transpose();
    const double sense = from_start ? 1.0 : -1.0;
    const Vector3d tangent = sense * here.row(1).transpose().normalized();
    const Vector3d next_tangent = sense * next.row(1).transpose().normalized();
    // In the plane midway between the points, then in that which brings the reflected tangent to
    // the next: both together turn, and do not turn about the edge.
    const Vector3d first = reflected(carried, chord), first_tangent = reflected(tangent, chord);
    carried = reflected(first, next_tangent - first_tangent);
    here = next;
  }
  return carried;
}

NodeOrder node_order(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes) {
  return Ordering3d(joined, shapes).run();
}

}  // namespace hull::network
