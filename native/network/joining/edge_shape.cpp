// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/joining/edge_shape.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace hull::network {
namespace {

constexpr int kHaltSamples = 16;
constexpr double kHalted = 1e-9;  // of a length: the speed of what stands still
// Of the parameter: where the tangent of a curve that stands still at its end is taken from. The
// chord's direction is off by about as much; its length, of the second order, keeps eight digits.
constexpr double kInside = 1e-4;
constexpr int kChords = 32;  // of which an edge's length is the sum

// What an edge is by itself: numbers of edges and nodes shift where others come or go.
using EdgeKey = std::tuple<int, int, double, double>;

EdgeKey key_of(const CurveEdge& edge) { return {edge.curve, edge.piece, edge.low, edge.high}; }

std::map<EdgeKey, std::size_t> numbers_of_unchanged(const KnownEdges& known) {
  std::map<EdgeKey, std::size_t> numbers;
  if (known.joined == nullptr) return numbers;
  for (std::size_t e = 0; e < known.shapes->size(); ++e) {
    const CurveEdge& edge = known.joined->edges[e];
    if (!known.is_changed[static_cast<std::size_t>(edge.curve)]) numbers[key_of(edge)] = e;
  }
  return numbers;
}

}  // namespace

EdgeShape::EdgeShape(const CurveEdge& edge, const NurbsCurve& piece, const Vector3d& from,
                     const Vector3d& to)
    : piece_(piece),
      low_(edge.low),
      high_(edge.high),
      from_shift_(from - piece.point(edge.low)),
      to_shift_(to - piece.point(edge.high)),
      length_(0.0) {
  // The length of what is between the nodes, not of the curve's part.
  Vector3d before = from;
  for (int i = 1; i <= kChords; ++i) {
    const Vector3d next = evaluate(static_cast<double>(i) / kChords, 0).row(0);
    length_ += (next - before).norm();
    before = next;
  }
  start_tangent_ = found_tangent(true);
  end_tangent_ = found_tangent(false);
  halt_ = found_halt();
}

Points3 EdgeShape::evaluate(double u, int order) const {
  const double width = high_ - low_;
  // At 1 the end bit for bit, and never beyond it by rounding: the curve may end there, too.
  const double t = u >= 1.0 ? high_ : std::min(low_ + u * width, high_);
  Points3 rows = piece_.evaluate(t, order);
  // Shifts to the nodes fade with a slope of zero at both ends: tangents there stay the piece's.
  const double first[] = {1.0 - u * u * (3.0 - 2.0 * u), -6.0 * u * (1.0 - u), 12.0 * u - 6.0};
  double scale = 1.0;
  for (int k = 0; k <= order; ++k) {
    const double share = first[k];
    // Both shares sum to 1, so that their derivatives are opposite.
    const double other = k == 0 ? u * u * (3.0 - 2.0 * u) : -share;
    rows.row(k) = scale * rows.row(k) + (share * from_shift_ + other * to_shift_).transpose();
    scale *= width;
  }
  return rows;
}

Vector3d EdgeShape::given(double u) const {
  return piece_.point(u >= 1.0 ? high_ : std::min(low_ + u * (high_ - low_), high_));
}

Vector3d EdgeShape::found_tangent(bool is_start) const {
  const Points3 jet = evaluate(is_start ? 0.0 : 1.0, 1);
  Vector3d tangent = jet.row(1);
  // A curve whose first control points are one has a tangent all the same.
  if (!(tangent.norm() > kHalted * length_)) {
    const Vector3d inner = evaluate(is_start ? kInside : 1.0 - kInside, 0).row(0);
    return (inner - Vector3d(jet.row(0))).normalized();
  }
  return (is_start ? tangent : Vector3d(-tangent)).normalized();
}

std::optional<Vector3d> EdgeShape::found_halt() const {
  // Before the first sample there is no tangent to turn back from.
  Vector3d before = Vector3d::Zero();
  for (int i = 0; i <= kHaltSamples; ++i) {
    const Points3 jet = evaluate(static_cast<double>(i) / kHaltSamples, 1);
    const Vector3d slope = jet.row(1);
    if (!(slope.norm() > kHalted * length_)) return Vector3d(jet.row(0));
    const Vector3d tangent = slope.normalized();
    // Turned back between two samples: there it stood still.
    if (tangent.dot(before) < -0.5) return Vector3d(jet.row(0));
    before = tangent;
  }
  return std::nullopt;
}

std::vector<EdgeShape> edge_shapes(const JoinedCurves& joined,
                                   const std::vector<CurveShape>& shapes, const KnownEdges& known) {
  const auto known_numbers = numbers_of_unchanged(known);
  std::vector<EdgeShape> edges;
  for (const CurveEdge& edge : joined.edges) {
    const Vector3d& from = joined.nodes[static_cast<std::size_t>(edge.from)];
    const Vector3d& to = joined.nodes[static_cast<std::size_t>(edge.to)];
    const auto found = known_numbers.find(key_of(edge));
    if (found != known_numbers.end()) {
      const CurveEdge& same = known.joined->edges[found->second];
      // A curve that is as it was may end at nodes that others have moved.
      if (known.joined->nodes[static_cast<std::size_t>(same.from)] == from &&
          known.joined->nodes[static_cast<std::size_t>(same.to)] == to) {
        edges.push_back((*known.shapes)[found->second]);
        continue;
      }
    }
    const auto& pieces = shapes[static_cast<std::size_t>(edge.curve)].pieces;
    edges.emplace_back(edge, pieces[static_cast<std::size_t>(edge.piece)], from, to);
  }
  return edges;
}

}  // namespace hull::network
