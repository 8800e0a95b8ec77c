// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/corner_net.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "conversion/exact/blossom.h"

namespace hull::conversion {
namespace {

// A span of a ring, in units of the corner square within that ring.
struct Span {
  double u, v, size;
  surface::BicubicPoints points;
};

// The spans of a ring that touch the corner square, or the lines to it from the corner.
struct RingSpans {
  Span right, diagonal, above;
};

// The irregular knot at corner k of a cell, and the square of the cell it is evaluated in.
struct KnotNode {
  int index = -1;    // of the corner
  int halvings = 0;  // the square's size is 2^-halvings of the cell
};

KnotNode knot_node(const surface::LimitSurface& surface, int cell, int k) {
  // Children are in rows, corners counter-clockwise.
  static constexpr std::array<int, 4> kChildAt{0, 1, 3, 2};
  surface::SurfaceNode node = surface.layout().root(cell);
  int halvings = 0;
  while (node.kind == surface::SurfaceNode::Kind::kSplit) {
    node = surface.layout().split(node.index)[kChildAt[k]];
    ++halvings;
  }
  assert(node.kind == surface::SurfaceNode::Kind::kCorner && node.turn == k);
  return {node.index, halvings};
}

// `scale`: the size of the ring's square, in corner squares.
RingSpans ring_spans(const surface::CornerBasis& basis, const surface::CornerRing& ring,
                     double scale) {
  const auto span_at = [&](double u, double v) {
    const auto& segments = basis.segments();
    const auto holds = [&](const surface::RingSegment& s) {
      return u > s.u && u < s.u + s.size && v > s.v && v < s.v + s.size;
    };
    const auto found = std::find_if(segments.begin(), segments.end(), holds);
    assert(found != segments.end());
    const int number = static_cast<int>(found - segments.begin());
    return Span{scale * found->u, scale * found->v, scale * found->size,
                ring.segment_points(number)};
  };
  // Just beyond the half that the next ring fills: a segment there may be whole or one of four
  // quarters.
  constexpr double kIn = 1e-3, kBeyond = 0.5 + 1e-3;
  return {span_at(kBeyond, kIn), span_at(kBeyond, kBeyond), span_at(kIn, kBeyond)};
}

// The clamped knots of one direction, as far as needed.
using KnotRow = std::array<double, kMostInner + 8>;
KnotRow knot_row(int inner, double beyond) {
  KnotRow knots{};
  // The first four stay 0.
  for (int k = 0; k <= inner; ++k) knots[4 + k] = std::exp2(k - inner);
  for (int k = 0; k < 3; ++k) knots[5 + inner + k] = beyond + k;
  return knots;
}

// Control point i, j.
Vector3d point_of(const Span& span, const KnotRow& u, int i, const KnotRow& v, int j) {
  const auto weights = [&](const KnotRow& knots, int k, double begin) {
    const auto local = [&](int m) { return (knots[k + m] - begin) / span.size; };
    return blossom_weights(local(1), local(2), local(3));
  };
  return blossom(span.points, weights(u, i, span.u), weights(v, j, span.v));
}

}  // namespace

CornerFunctions corner_functions(int inner, double beyond, double t) {
  const KnotRow knots = knot_row(inner, beyond);
  int first = 0;  // of the four functions that live there
  // Places are within [0, 1], which has inner + 1 spans.
  while (first < inner && t >= knots[first + 4]) ++first;
  // Cox-de Boor, as in basis_values(), for the few knots of a corner and without allocating.
  std::array<double, 4> values{1.0};
  CornerFunctions result;
  for (int degree = 1; degree <= 3; ++degree) {
    const std::array<double, 4> lower = values;
    values = {};
    for (int k = 0; k < degree; ++k) {
      const int at = first + 4 - degree + k;  // the knot where lower function k begins
      const double span = knots[at + degree] - knots[at], share = (t - knots[at]) / span;
      values[k] += (1.0 - share) * lower[k];
      values[k + 1] += share * lower[k];
      // Slopes follow from the functions of degree two, those of the last round before.
      if (degree < 3) continue;
      result.slope[first + k] -= 3.0 * lower[k] / span;
      result.slope[first + k + 1] += 3.0 * lower[k] / span;
    }
  }
  for (int k = 0; k < 4; ++k) result.value[first + k] = values[k];
  return result;
}

surface::SurfaceJet CornerNet::evaluate(double u, double v) const {
  const CornerFunctions fu = corner_functions(inner, beyond_u, u);
  const CornerFunctions fv = corner_functions(inner, beyond_v, v);
  surface::SurfaceJet jet;
  for (int i = 0; i < count(); ++i) {
    Vector3d point = Vector3d::Zero(), slope = Vector3d::Zero();
    for (int j = 0; j < count(); ++j) {
      point += fv.value[j] * at(i, j);
      slope += fv.slope[j] * at(i, j);
    }
    jet.point += fu.value[i] * point;
    jet.du += fu.slope[i] * point;
    jet.dv += fu.value[i] * slope;
  }
  return jet;
}

CornerNet corner_net(const surface::LimitSurface& surface, int h, const Grading& grading) {
  const KnotNode node = knot_node(surface, h / 4, h % 4);
  assert(grading.halvings > node.halvings && grading.inner <= kMostInner);
  const surface::CornerBasis& basis = surface.layout().basis(node.index);
  surface::CornerRing ring(basis, surface.corner(node.index));
  // The first ring's inner square is half of the knot's node, which may be a quadrant already.
  for (int k = node.halvings + 1; k < grading.halvings; ++k) ring.advance();
  // The ring around the corner square, then those within.
  std::vector<RingSpans> rings;
  for (int k = 0; k <= grading.inner; ++k, ring.advance()) {
    // The ring around the corner square has a square of twice its size.
    rings.push_back(ring_spans(basis, ring, std::exp2(1 - k)));
  }
  const RingSpans& around = rings.front();
  CornerNet net;
  net.inner = grading.inner;
  // Where one side of the diagonal is cut into quarters the knots of the patch are too.
  net.beyond_u = 1.0 + std::min(around.right.size, around.diagonal.size);
  net.beyond_v = 1.0 + std::min(around.above.size, around.diagonal.size);
  const KnotRow u = knot_row(net.inner, net.beyond_u), v = knot_row(net.inner, net.beyond_v);
  for (int i = 0; i < net.count(); ++i) {
    for (int j = 0; j < net.count(); ++j) {
      // A point is of the outermost ring that its function reaches into.
      const int a = std::min(i, net.inner + 1), b = std::min(j, net.inner + 1);
      const RingSpans& spans = rings[std::min(net.inner + 1 - std::max(a, b), net.inner)];
      const Span& span = a > b ? spans.right : b > a ? spans.above : spans.diagonal;
      net.points.push_back(point_of(span, u, i, v, j));
    }
  }
  net.at(0, 0) = ring.limit();
  return net;
}

}  // namespace hull::conversion
